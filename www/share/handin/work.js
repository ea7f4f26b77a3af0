// What stands under the task of an exercise: whether its aim is met, the way to hand in, who works on it where that is needed
// first, and, where a receipt was opened, whether it holds.
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Scene } from '../../run/scene.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Measured } from './measure.js' */
/** @import { Thing } from './own.js' */
/** @import { HandedIn } from './sheet.js' */
import { seenText } from '../../kit/text.js';
import { html, nothing, render } from 'lit-html';
import { byId } from '../../kit/elements.js';
import { watch } from '../../kit/memo.js';
import { createTeller } from '../../lab/announcer.js';
import { onEnter } from '../../kit/templates.js';
import { judged } from '../../run/aim.js';
import { gainsOf } from '../../run/drivers.js';
import { inSight } from '../../parts/parts.js';
import { isFree } from '../../run/guard.js';
import { asksSomething, shownExercise } from '../../run/exercise.js';
import { drivesOf, noTrial } from '../../run/state.js';
import { mostOfWho } from '../../run/variant.js';
import { messageOf } from '../../words/errors.js';
import { measure } from './measure.js';
import { createOwnNow, isOutOfReach } from './own.js';
import { holds, isWhole, toldIn } from './receipt.js';
import { createHandInSheet } from './sheet.js';
import './work.css';
import words from './words/index.js';

const { texts } = words;

/** What is known of what is asked for. @typedef {{ measured: Measured | null, isNew: boolean } | null} Known */
/** @typedef {import('../../parts/part.js').Tools & { answersOf: (state: State) => import('./receipt.js').Answers, onHandIn: (handed: HandedIn) => void }} WorkTools */

/** @param {WorkTools} tools @param {HTMLElement} root */
export function createWork(tools, root) {
  const { engine, store, actions, paper } = tools;
  const channel = engine.surveys.channel();
  const sheet = createHandInSheet(tools);
  const verdict = createVerdict(tools);
  /** null: it could not be measured. @type {Known} */
  let known = { measured: null, isNew: false };
  const asked = watch();
  const isOtherAim = watch();
  const drawn = watch();
  const aimOf = createAim();
  const ownNow = createOwnNow(engine);
  let questions = 0;

  /** @param {State} state @param {Scene} scene */
  const follow = (state, scene) => {
    const { aim } = shownExercise(state);
    const gains = gainsOf(state, state.driver, paper);
    const { own, apart } = ownNow(state);
    if (!aim || !asked(aim, own, String(gains))) return;
    // What is measured for one aim says nothing of another.
    const isOther = isOtherAim(aim.wanted.kind);
    questions += 1;
    const question = questions;
    // What is on the plane is known already.
    const isPlain = state.trial === noTrial && !scene.chosen && apart.length === 0;
    const isShown = isPlain && own.starts.length === 1;
    if (aim.wanted.kind === 'cost' && isShown) {
      const { cost, arrived } = scene.driving;
      known = {
        measured: { cost: cost.total, parked: arrived ? 1 : 0, starts: 1, value: cost.total },
        isNew: true,
      };
      return;
    }
    known = { measured: (isOther ? null : known?.measured) ?? null, isNew: false };
    measure(engine, aim, own, gains, { channel }).then((measured) => {
      // What is on the plane by now is known.
      if (question !== questions) return;
      known = { measured, isNew: true };
      store.redraw();
    }, failOf(question));
  };

  /** What a newer question took the place of is none. @param {number} question */
  const failOf = (question) => (/** @type {unknown} */ error) => {
    if (error instanceof DOMException && error.name === 'AbortError') return;
    if (question === questions) known = null;
    actions.say(messageOf(error));
  };

  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const exercise = shownExercise(state);
      follow(state, scene);
      const said = verdict.of(state);
      const drives = drivesSince(said, drivesOf(state));
      // What is handed in drives in the lab: a part alone on the page has gains of its own.
      const isOpen = asksSomething(exercise) && inSight.lab(state);
      // A run that is made again is handed in once it is all there.
      const isOnItsWay = state.catchingUp !== null;
      const { apart } = ownNow(state);
      const needsWho = exercise.vary.length > 0 && (state.student.who === '' || state.maker.open);
      const { student, evolving } = state;
      const seen = [student, known, drives, isOpen, isOnItsWay, apart, needsWho, evolving];
      if (!drawn(exercise, said, ...seen)) return;
      const hadFocus = root.contains(document.activeElement);
      render(
        html`${said ? html`<p class="work-said ${said.isGood ? '' : 'bad'}" role="status">${said.text}</p>` : nothing}
          ${aimOf(exercise, !isOpen || needsWho || said?.isGood === false ? null : known, drives, evolving)}
          ${asksSomething(exercise) && !isOpen ? awayLine(isFree(state, 'parts') && (() => actions.openPage('lab'))) : nothing}
          ${needsWho && isOpen ? whoForm(actions.setWho, state.maker.open) : nothing}
          ${
            isOpen && !needsWho
              ? html`<button id="hand-in" type="button" class=${said ? '' : 'primary'} .disabled=${state.maker.open || isOnItsWay} @click=${sheet.open}>${texts.handIn}</button>`
              : nothing
          }
          ${isOpen && !needsWho ? apartLine(apart, exercise.aim !== null, actions.backToExercise) : nothing}`,
        root,
      );
      // What was pressed may be gone.
      if (hadFocus && !root.contains(document.activeElement))
        /** @type {HTMLElement | null} */ (root.querySelector('#hand-in, #work-who'))?.focus();
    },
  };
}

/** No form, which some frames forbid. @param {(who: string) => void} onWho @param {boolean} isMade It is only looked at. */
function whoForm(onWho, isMade) {
  const begin = () => {
    const who = seenText(/** @type {HTMLInputElement} */ (byId('work-who')).value);
    if (who) onWho(who);
  };
  return html`
  <div class="work-who row">
    <label for="work-who">${texts.whoFirst}</label>
    <input id="work-who" type="text" maxlength=${mostOfWho} autocomplete="off" placeholder=${texts.whoLabel}
      @keydown=${onEnter(begin)} .disabled=${isMade}>
    <button id="work-begin" type="button" class="primary" .disabled=${isMade} @click=${begin}>${texts.begin}</button>
  </div>`;
}

/** What stands of the aim, which is told too. */
function createAim() {
  const tell = createTeller('aim');
  /** @param {Exercise} exercise @param {Known} known @param {number} drives @param {boolean} isQuiet */
  return (exercise, known, drives, isQuiet) => {
    const result = known?.measured ? resultOf(exercise, known.measured, drives) : null;
    if (result && known?.isNew) {
      const { met, value, drives, points } = result;
      // J the lab says.
      const isCost = exercise.aim?.wanted.kind === 'cost';
      tell([met, isCost ? null : value, drives, points].filter(Boolean).join(', '), isQuiet);
    }
    return aimLine(exercise, known, result);
  };
}

/** Whether the aim is met, and what it came to. @param {Exercise} exercise @param {Measured} measured @param {number} drives */
function resultOf({ aim, scale }, measured, drives) {
  if (!aim) return null;
  const { isMet, points, most } = judged(aim, scale, { value: measured.value, drives });
  return {
    isMet,
    met: words.metText(isMet, aim.drives === null || drives <= aim.drives),
    value: words.valueText(aim.wanted, measured.value),
    drives: aim.drives === null ? null : words.drivesText(drives, aim.drives),
    points: points === null ? null : words.pointsText(points, most ?? 0),
  };
}

/** @param {Exercise} exercise @param {Known} known null: nothing that could be judged. @param {ReturnType<typeof resultOf>} result */
function aimLine({ aim }, known, result) {
  if (!aim) return nothing;
  const { wanted } = aim;
  const head = html`<b>${words.wantedText(wanted)}<span class="aim-budget">${words.budgetText(aim.drives)}</span></b>`;
  if (!known) return html`<p id="aim" class="aim">${head}</p>`;
  if (!result) return html`<p id="aim" class="aim" role="status">${head} · ${texts.computing}</p>`;
  const { isMet, met, value, drives, points } = result;
  return html`<p id="aim" class="aim ${wanted.kind} ${isMet ? 'met' : ''} ${known.isNew ? '' : 'late'}">${head}
    <span class="aim-mark"><span aria-hidden="true">${isMet ? '✓' : '○'}</span> ${met}</span>
    ${Object.entries({ value, drives, points }).map(([name, text]) => text && html`<span class="muted aim-${name}">${text}</span> `)}</p>`;
}

/** That nothing is handed in of what is tried here, and the way to where it is, if it is open. @param {false | (() => void)} toLab */
const awayLine = (toLab) => html`
  <p id="aim-away" class="aim-apart"><span>${texts.away}</span>
    ${toLab ? html`<button id="aim-to-lab" type="button" class="link" @click=${toLab}>${texts.toLab}</button>` : nothing}</p>`;

/** That the run is not as the exercise has it, in which it is judged all the same, and the way back; where nothing is judged, one may go one's own way, as far as that is open. @param {readonly Thing[]} apart @param {boolean} isJudged @param {() => void} back */
function apartLine(apart, isJudged, back) {
  const told = isJudged ? apart : apart.filter(isOutOfReach);
  if (told.length === 0) return nothing;
  return html`
    <p id="aim-apart" class="aim-apart"><span>${words.apartText(told)}</span> ${isJudged ? html`<span class="aim-why">${texts.counts}</span>` : nothing}
      <button id="back-to-exercise" type="button" class="link" @click=${back}>${texts.backToExercise}</button></p>`;
}

/** `drives` null: evolution is asked. `made`: what the page had counted then. @typedef {{ text: string, isGood: boolean, drives: number | null, made: number }} Said */
/** As many as the receipt says, and those made since. @param {Said | null} said @param {number} made */
const drivesSince = (said, made) =>
  said === null || said.drives === null ? made : said.drives + made - said.made;

/** What is said of a receipt that was opened, as long as its run is on screen. @param {WorkTools} tools */
function createVerdict({ engine, store, actions, paper, links }) {
  /** @type {{ handin: string, since: number, experiment: object, gains: string, said: Said | null } | null} */
  let of = null;
  const compute = async (/** @type {State} */ state, /** @type {string} */ gains) => {
    const { handin } = state.student;
    const own = {
      handin,
      since: state.work.since,
      experiment: state.experiment,
      gains,
      said: /** @type {Said | null} */ (null),
    };
    of = own;
    const made = drivesOf(state);
    const told = toldIn(handin);
    if (!told || !isWhole(state, engine, links))
      own.said = { text: words.broken, isGood: false, drives: null, made };
    else {
      const measured = await measure(engine, null, state.experiment, gainsOf(state, state.driver, paper));
      const isGood = holds(told, measured);
      const text = isGood
        ? words.held(state.student.who, measured.cost)
        : words.heldNot(told.cost, measured.cost);
      const version = engine.version();
      own.said = {
        text: told.program === version ? text : `${text} ${words.otherProgram(told.program, version)}`,
        isGood,
        drives: state.driver === 'evolved' ? null : told.drives,
        made,
      };
    }
    store.redraw();
  };
  return {
    /** @param {State} state */
    of(state) {
      const { handin } = state.student;
      if (!handin || state.catchingUp || state.computing) return null;
      const gains = String(gainsOf(state, state.driver, paper));
      const isNew = of?.handin !== handin || of.since !== state.work.since;
      // What was paused on its way is not yet what was handed in.
      if (isNew && state.generation === state.work.opened)
        compute(state, gains).catch((error) => actions.say(messageOf(error)));
      return of?.handin === handin && of.experiment === state.experiment && of.gains === gains
        ? of.said
        : null;
    },
  };
}
