// How often somebody has driven by hand, and the best that came of it. A drag is one drive, however far it goes.
import { onCapture } from '../../kit/elements.js';
import { remember, watch } from '../../kit/memo.js';
import { noTally, progressSlice } from '../state.js';

/** @import { Experiment } from '../../core/engine.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { Live } from '../page.js' */
/** @import { Tally } from '../state.js' */
/** @import { Priced, Step } from '../steps.js' */

/** Of so many experiments what was driven is kept. */
export const mostTallies = 8;

/** What a drive by hand depends on: all but evolution. @param {Experiment} experiment */
export const taskText = (experiment) => JSON.stringify({ ...experiment, evolution: null });
const textOf = remember(taskText);

/** The drive on the plane. @param {Live} live @returns {Priced | null} */
const driveOnPlane = ({ state, scene: { experiment, driving, chosen } }) =>
  chosen || !state.handGains
    ? null
    : {
        experiment: textOf(experiment),
        gains: state.handGains,
        cost: driving.cost.total,
        arrived: driving.arrived,
      };

/** @param {Store} store */
export function createTally(store) {
  /** @type {string | null} */
  let last = null;
  /** The gains with which the experiment began, until others are driven. @type {string | null} */
  let given = null;
  const changed = watch();
  const hand = watchHand(store);
  return {
    /** Counts what drives by hand, while the experiment stays the same. What a link sets up was not driven by hand. @param {Live} live @param {Step} step */
    count(live, step) {
      const { driver, handGains, page, experiment, gainErrors } = live.state;
      if (changed(experiment)) {
        given = String(handGains);
        hand.rest();
      }
      // What was refused is no drive.
      if (String(handGains) === given || gainErrors.some((error) => error !== '')) hand.rest();
      if (driver !== 'hand' || !handGains || page !== 'lab' || !hand.hasMoved()) return;
      const drive = (step.price ?? driveOnPlane)(live);
      if (!drive) return;
      hand.rest();
      given = null;
      const name = `${drive.gains} ${drive.experiment}`;
      if (name !== last || progressSlice.of(live.state).tallies[0]?.experiment !== drive.experiment)
        record(store, drive);
      last = name;
    },
  };
}

/** @param {Store} store @param {Priced} drive */
function record(store, { experiment, gains, cost, arrived }) {
  const { tallies } = progressSlice.of(store.get());
  const before = tallies.find((tally) => tally.experiment === experiment) ?? noTally;
  const isBest = arrived && (!before.best || cost < before.best.cost);
  const isLowest = !before.lowest || cost < before.lowest.cost;
  progressSlice.update(store, {
    tallies: [
      {
        experiment,
        drives: before.drives + 1,
        costs: [...before.costs, cost],
        best: isBest ? { gains, cost } : before.best,
        lowest: isLowest ? { gains, cost } : before.lowest,
      },
      ...tallies.filter((tally) => tally !== before),
    ].slice(0, mostTallies),
  });
}

/** What a hand does with the gains: while it holds a slider, or a key of it, it has not moved yet. @param {Store} store */
function watchHand(store) {
  /** The slider. @type {EventTarget | null} */
  let held = null;
  /** What points at sliders: also a palm, or another hand. @type {Set<number>} */
  const pointers = new Set();
  let moved = false;
  const isOfGains = (/** @type {EventTarget | null} */ target) =>
    target instanceof HTMLInputElement && target.closest('#gains') !== null;
  const letGo = () => {
    if (held) store.redraw();
    held = null;
    pointers.clear();
  };
  onCapture(['pointerdown', 'keydown'], (event) => {
    const { target } = event;
    const isSlider = isOfGains(target) && /** @type {HTMLInputElement} */ (target).type === 'range';
    if (!isSlider && pointers.size > 0) return;
    held = isSlider ? target : null;
    if (isSlider && 'pointerId' in event) pointers.add(event.pointerId);
  });
  onCapture(['pointerup', 'pointercancel'], ({ pointerId }) => {
    if (pointers.delete(pointerId) && pointers.size === 0) letGo();
  });
  onCapture(['keyup'], letGo);
  // Of the slider or of the window: where a press begins, whatever had the focus before loses it.
  onCapture(['blur'], ({ target, currentTarget }) => {
    if (target === held || target === currentTarget) letGo();
  });
  onCapture(['input', 'change'], ({ target, type }) => {
    const isTyping = /** @type {HTMLInputElement} */ (target).type === 'text' && type === 'input';
    if (isOfGains(target) && !isTyping) moved = true;
  });
  return {
    hasMoved: () => moved && held === null,
    rest() {
      moved = false;
    },
  };
}

/** What was driven in this experiment. @param {readonly Tally[]} tallies @param {Experiment} experiment */
export const tallyOf = (tallies, experiment) =>
  tallies.find((tally) => tally.experiment === textOf(experiment)) ?? noTally;

/** What was driven in all others. @param {readonly Tally[]} tallies @param {Experiment} experiment */
export const talliesBut = (tallies, experiment) =>
  tallies.filter((tally) => tally.experiment !== textOf(experiment));
