// How often somebody has driven by hand, and the best that came of it.
import { remember } from '../kit/memo.js';

/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../run/state.js').Scene} Scene */
/** @typedef {import('../run/state.js').State} State */
/** @typedef {import('../run/state.js').Store} Store */
/** @typedef {import('../run/state.js').Triple} Triple */
/** Drives with different gains, in the experiment with this text, the J of each, and the best that arrived. @typedef {{ experiment: string, drives: number, costs: readonly number[], best: { gains: Triple, cost: number } | null }} Tally */

/** @type {Tally} */
export const noTally = Object.freeze({ experiment: '', drives: 0, costs: [], best: null });

/** What a drive by hand depends on: all but evolution. @param {Experiment} experiment */
export const taskText = (experiment) => JSON.stringify({ ...experiment, evolution: null });
const textOf = remember(taskText);

/** @param {Store} store */
export function createTally(store) {
  /** @type {Scene['driving'] | null} */
  let last = null;
  return {
    /** Counts what drives by hand, while the experiment stays the same. @param {State} state @param {Scene} scene */
    count({ driver, handGains, progress, page }, { driving, experiment, chosen }) {
      if (driver !== 'hand' || !handGains || chosen || driving === last || page !== 'lab') return;
      last = driving;
      const text = textOf(experiment);
      const { tally } = progress;
      const before = tally.experiment === text ? tally : { ...noTally, experiment: text };
      const { total } = driving.cost;
      const isBest = driving.arrived && (!before.best || total < before.best.cost);
      store.update({
        progress: {
          ...progress,
          tally: {
            ...before,
            drives: before.drives + 1,
            costs: [...before.costs, total],
            best: isBest ? { gains: handGains, cost: total } : before.best,
          },
        },
      });
    },
  };
}

/** What was driven in this experiment. @param {Tally} tally @param {Experiment} experiment */
export const tallyOf = (tally, experiment) => (tally.experiment === textOf(experiment) ? tally : noTally);
