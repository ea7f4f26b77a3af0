// In the maker: when the exercise is solved, for how many points, and what is drawn for each student.
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Varied } from '../../run/variant.js' */
/** @import { Fields } from './asked.js' */
import { html, nothing } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { checkOf } from '../../kit/fields.js';
import { options, valueIn } from '../../kit/templates.js';
import { aimText, scaleText } from '../../link/exercise.js';
import { wayOf } from '../../run/exercise.js';
import { variedNames } from '../../run/variant.js';
import { WrongField, asked, heads, isTurned, pointIds } from './asked.js';
import { exercise as exerciseWords } from '../../words/index.js';
import words from '../words/index.js';

const { texts } = words;

/** @type {Readonly<Record<'cost' | 'parks' | 'unseen', string>>} */
const firstValues = { cost: '8', parks: '28/32', unseen: '0.6' };
const kinds = /** @type {const} */ (['none', 'cost', 'parks', 'unseen']);

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

/** What drives where it is begun. @typedef {Pick<State, 'driver' | 'history' | 'generation'>} Given */
/** `wrong`: the id of the field that is, or none. @typedef {{ fields: Fields, error: string, wrong: string }} Typed */
/** @param {Fields} fields @returns {Typed} */
const right = (fields) => ({ fields, error: '', wrong: '' });

/** @param {() => Exercise} draft @param {(patch: Partial<Exercise>) => void} change @param {() => void} redraw */
export function createAimFields(draft, change, redraw) {
  let typed = right(blank);

  /** @param {Partial<Fields>} patch */
  const type = (patch) => {
    const fields = { ...typed.fields, ...patch };
    try {
      const next = asked(fields);
      typed = right(fields);
      change(next);
    } catch (reason) {
      if (!(reason instanceof WrongField)) throw reason;
      typed = { fields, error: reason.message, wrong: reason.field };
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
      typed = right(fieldsOf(exercise));
    },
    /** @param {Exercise} exercise @param {Given} given @param {unknown} note On what is asked for. */
    fields: (exercise, given, note) => fieldsHtml(typed, exercise, given, note, on),
  };
}

/** @param {string} id @param {string} wrong @param {string} label @param {string} value @param {(text: string) => void} onInput */
function field(id, wrong, label, value, onInput) {
  const isWrong = id === wrong;
  return html`<input id=${id} type="text" inputmode="decimal" autocomplete="off" spellcheck="false" aria-label=${label}
  aria-invalid=${String(isWrong)} aria-describedby=${isWrong ? 'maker-aim-error' : nothing} .value=${live(value)} @input=${(/** @type {Event} */ event) => onInput(valueIn(event))}>`;
}

/** Whether one may evolve again and again, each time with drives that are counted alone. @param {Exercise} exercise */
const isBySeeds = (exercise) =>
  exercise.aim?.drives &&
  wayOf(exercise, 'run') === 'free' &&
  (wayOf(exercise, 'seed') === 'free' || wayOf(exercise, 'settings') === 'free');

/** Where nobody counts, and a budget of drives is to hold. @param {Exercise} exercise */
const uncounted = (exercise) =>
  exercise.aim?.drives
    ? /** @type {const} */ (['parts', 'lesson'])
        .filter((group) => wayOf(exercise, group) === 'free')
        .map((group) => exerciseWords.groups[group])
    : [];

/** How many drives the given generation took, where they count and are past the budget before anybody begins. @param {Exercise} exercise @param {Given} given */
const tooMany = ({ aim }, { driver, history, generation }) => {
  const drives = driver === 'evolved' || generation > 0 ? history[generation]?.evaluations : 0;
  return aim?.drives && drives > aim.drives ? drives : 0;
};

/**
 * @param {Typed} typed @param {Exercise} exercise @param {Given} given @param {unknown} note
 * @param {{ type: (patch: Partial<Fields>) => void, kind: (event: Event) => void, points: (index: number, text: string) => void, vary: (name: Varied) => void }} on
 */
function fieldsHtml({ fields: { kind, value, drives, points }, error, wrong }, exercise, given, note, on) {
  const { vary, aim } = exercise;
  const free = uncounted(exercise);
  const many = tooMany(exercise, given);
  return html`
    <label for="maker-aim" class="maker-label">${texts.makerAim}</label>
    <div class="maker-aim row">
      <select id="maker-aim" @change=${on.kind}>${options(
        kinds.map((one) => /** @type {const} */ ([one, words.aims[one]])),
        kind,
      )}</select>
      ${kind === 'none' ? nothing : field('maker-value', wrong, texts.makerValue, value, (text) => on.type({ value: text }))}
    </div>
    ${note}
    ${
      kind === 'none'
        ? nothing
        : html`<div class="maker-aim row"><label for="maker-budget">${texts.makerDrives}</label>
            ${field('maker-budget', wrong, texts.makerDrives, drives, (text) => on.type({ drives: text }))}</div>
          <div class="maker-points" role="group" aria-label=${texts.makerPoints}>${[1, 3].map(
            (
              at,
              i,
            ) => html`${field(pointIds[at], wrong, words.pointsLabel(i), points[at], (text) => on.points(at, text))}
              <span aria-hidden="true">${texts.makerPointsAt}</span>
              ${field(pointIds[at - 1], wrong, words.pointsAtLabel(i), points[at - 1], (text) => on.points(at - 1, text))}`,
          )}</div>`
    }
    ${isBySeeds(exercise) ? html`<p id="maker-seeds" class="muted">${texts.makerSeeds}</p>` : nothing}
    ${free.length > 0 ? html`<p id="maker-uncounted" class="muted">${words.uncountedText(free)}</p>` : nothing}
    ${many > 0 ? html`<p id="maker-many" class="muted">${words.manyText(many)}</p>` : nothing}
    <p id="maker-aim-error" class="field-error" role="alert" .hidden=${error === ''}>${error}</p>
    ${error === '' && isTurned(exercise) ? html`<p id="maker-turned" class="muted">${texts.makerTurned}</p>` : nothing}
    <fieldset class="maker-vary"><legend class="maker-label">${texts.makerVary}</legend>${variedNames.map(
      (name) => checkOf(`maker-vary-${name}`, words.varied[name], vary.includes(name), () => on.vary(name)),
    )}</fieldset>
    ${
      aim?.wanted.kind === 'cost' && (vary.includes('goal') || vary.includes('starts'))
        ? html`<p id="maker-uneven" class="muted">${texts.makerUneven}</p>`
        : nothing
    }`;
}
