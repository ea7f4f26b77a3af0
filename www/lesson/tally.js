// How often somebody has driven by hand, and the best that came of it.
import { remember } from '../kit/memo.js';
import { noTally, progressSlice } from './state.js';

/** @import { Experiment } from '../core/engine.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
/** @import { Store } from '../run/store.js' */
/** @import { Tally } from './state.js' */

/** What a drive by hand depends on: all but evolution. @param {Experiment} experiment */
export const taskText = (experiment) => JSON.stringify({ ...experiment, evolution: null });
const textOf = remember(taskText);

/** @param {Store} store */
export function createTally(store) {
  /** @type {Scene['driving'] | null} */
  let last = null;
  return {
    /** Counts what drives by hand, while the experiment stays the same. @param {State} state @param {Scene} scene */
    count(state, { driving, experiment, chosen }) {
      const { driver, handGains, page } = state;
      if (driver !== 'hand' || !handGains || chosen || driving === last || page !== 'lab') return;
      last = driving;
      const text = textOf(experiment);
      const { tally } = progressSlice.of(state);
      const before = tally.experiment === text ? tally : { ...noTally, experiment: text };
      const { total } = driving.cost;
      const isBest = driving.arrived && (!before.best || total < before.best.cost);
      progressSlice.update(store, {
        tally: {
          ...before,
          drives: before.drives + 1,
          costs: [...before.costs, total],
          best: isBest ? { gains: handGains, cost: total } : before.best,
        },
      });
    },
  };
}

/** What was driven in this experiment. @param {Tally} tally @param {Experiment} experiment */
export const tallyOf = (tally, experiment) => (tally.experiment === textOf(experiment) ? tally : noTally);
