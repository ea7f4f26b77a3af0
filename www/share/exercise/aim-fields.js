// In the maker: when the exercise is solved, for how many points, and what is drawn for each student.
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Varied } from '../../run/variant.js' */
import { html, nothing } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { options, valueIn } from '../../kit/templates.js';
import { aimOf, aimText, scaleOf, scaleText } from '../../link/exercise.js';
import { number, numberText } from '../../link/values.js';
import { most } from '../../run/aim.js';
import { variedNames } from '../../run/variant.js';
import { messageOf } from '../../words/errors.js';
import words from '../words/index.js';

const { texts } = words;

/** As they are typed. @typedef {{ kind: 'none' | 'cost' | 'parks' | 'unseen', value: string, drives: string, points: readonly string[] }} Fields */

/** @type {Readonly<Record<'cost' | 'parks' | 'unseen', string>>} */
const firstValues = { cost: '8', parks: '28/32', unseen: '0.6' };
const kinds = /** @type {const} */ (['none', 'cost', 'parks', 'unseen']);
const heads = { cost: 'J<', parks: 'parks:', unseen: 'unseen:' };

/** @type {Fields} */
const blank = { kind: 'none', value: '', drives: '', points: ['', '', '', ''] };

/** @param {Exercise} exercise @returns {Fields} */
function fieldsOf({ aim, scale }) {
  if (!aim) return blank;
  const { kind } = aim.wanted;
  const value = aimText({ ...aim, drives: null }).slice(heads[kind].length);
  const points = scale ? scaleText(scale).split(/[:,]/) : blank.points;
  return { kind, value, drives: aim.drives === null ? '' : String(aim.drives), points };
}

/** What is wrong is said in the words of the field that it is in. @template T @param {string} why @param {() => T} read */
function orSay(why, read) {
  try {
    return read();
  } catch {
    throw new Error(why);
  }
}

/** As links have it: nine tenths, for who types 90 %. @param {string} text */
const shareOf = (text) => (text.endsWith('%') ? String(Number(text.slice(0, -1) || 'x') / 100) : text);

/** @param {Fields} fields @returns {Pick<Exercise, 'aim' | 'scale'>} */
function asked({ kind, ...fields }) {
  if (kind === 'none') return { aim: null, scale: null };
  const [value, drives] = [fields.value.trim(), fields.drives.trim()];
  const points = fields.points.map((text) => text.trim());
  const wanted = `${heads[kind]}${kind === 'unseen' ? shareOf(value) : value}`;
  orSay(words.wrongValue(kind, most), () => aimOf(wanted));
  const aim = orSay(words.wrongDrives(most), () => aimOf(drives ? `${wanted};drives<=${drives}` : wanted));
  const hasNone = points.every((text) => text === '');
  return {
    aim,
    scale: hasNone
      ? null
      : orSay(words.wrongPoints(most), () => {
          const [a, p, b, q] = points.map((text) => numberText(number(text)));
          return scaleOf(`${a}:${p},${b}:${q}`);
        }),
  };
}

/** @param {() => Exercise} draft @param {(patch: Partial<Exercise>) => void} change @param {() => void} redraw */
export function createAimFields(draft, change, redraw) {
  let typed = { fields: blank, error: '' };

  /** @param {Partial<Fields>} patch */
  const type = (patch) => {
    const fields = { ...typed.fields, ...patch };
    try {
      const next = asked(fields);
      typed = { fields, error: '' };
      change(next);
    } catch (reason) {
      typed = { fields, error: messageOf(reason) };
      redraw();
    }
  };

  const on = {
    type,
    /** @param {Event} event */
    kind(event) {
      const kind = /** @type {Fields['kind']} */ (valueIn(event));
      type(kind === 'none' ? blank : { kind, value: firstValues[kind], points: blank.points });
    },
    /** @param {number} index @param {string} text */
    points: (index, text) =>
      type({ points: typed.fields.points.map((one, i) => (i === index ? text : one)) }),
    /** @param {Varied} name */
    vary(name) {
      const { vary } = draft();
      change({ vary: variedNames.filter((one) => vary.includes(one) !== (one === name)) });
    },
  };

  return {
    /** What is typed: another object when it has changed. */
    typed: () => typed,
    /** @param {Exercise} exercise */
    read(exercise) {
      typed = { fields: fieldsOf(exercise), error: '' };
    },
    /** @param {Exercise} exercise @param {unknown} note On what is asked for. */
    fields: (exercise, note) => fieldsHtml(typed, exercise, note, on),
  };
}

/** @param {string} id @param {string} label @param {string} value @param {(text: string) => void} onInput */
function field(id, label, value, onInput) {
  return html`<input id=${id} type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-label=${label}
  .value=${live(value)} @input=${(/** @type {Event} */ event) => onInput(valueIn(event))}>`;
}

/**
 * @param {{ fields: Fields, error: string }} typed @param {Exercise} exercise @param {unknown} note
 * @param {{ type: (patch: Partial<Fields>) => void, kind: (event: Event) => void, points: (index: number, text: string) => void, vary: (name: Varied) => void }} on
 */
function fieldsHtml({ fields: { kind, value, drives, points }, error }, { vary, aim }, note, on) {
  return html`
    <label for="maker-aim" class="maker-label">${texts.makerAim}</label>
    <div class="maker-aim row">
      <select id="maker-aim" @change=${on.kind}>${options(
        kinds.map((one) => /** @type {const} */ ([one, words.aims[one]])),
        kind,
      )}</select>
      ${kind === 'none' ? nothing : field('maker-value', texts.makerValue, value, (text) => on.type({ value: text }))}
    </div>
    ${note}
    ${
      kind === 'none'
        ? nothing
        : html`<div class="maker-aim row"><label for="maker-budget">${texts.makerDrives}</label>
            ${field('maker-budget', texts.makerDrives, drives, (text) => on.type({ drives: text }))}</div>
          <div class="maker-points" role="group" aria-label=${texts.makerPoints}>${[1, 3].map(
            (
              at,
              i,
            ) => html`${field(`maker-points-${i}`, words.pointsLabel(i), points[at], (text) => on.points(at, text))}
              <span aria-hidden="true">${texts.makerPointsAt}</span>
              ${field(`maker-at-${i}`, words.pointsAtLabel(i), points[at - 1], (text) => on.points(at - 1, text))}`,
          )}</div>`
    }
    <p id="maker-aim-error" class="field-error" role="alert" .hidden=${error === ''}>${error}</p>
    <fieldset class="maker-vary"><legend class="maker-label">${texts.makerVary}</legend>${variedNames.map(
      (
        name,
      ) => html`<label class="check"><input id="maker-vary-${name}" type="checkbox" .checked=${live(vary.includes(name))}
        @change=${() => on.vary(name)}> <span>${words.varied[name]}</span></label>`,
    )}</fieldset>
    ${
      aim?.wanted.kind === 'cost' && (vary.includes('goal') || vary.includes('starts'))
        ? html`<p id="maker-uneven" class="muted">${texts.makerUneven}</p>`
        : nothing
    }`;
}
