// How often somebody has driven by hand, and the best that came of it.
import { remember } from '../state.js';

/** @typedef {import('../state.js').Scene} Scene */
/** @typedef {import('../state.js').State} State */
/** @typedef {import('../state.js').Store} Store */
/** @typedef {import('../state.js').Triple} Triple */
/** Drives with different gains, in the experiment with this text. @typedef {{ experiment: string, drives: number, best: { gains: Triple, cost: number } | null }} Tally */

/** @type {Tally} */
export const noTally = Object.freeze({ experiment: '', drives: 0, best: null });

/** @param {Store} store */
export function createTally(store) {
  /** @type {Scene['driving'] | null} */
  let last = null;
  const textOf = remember(JSON.stringify);
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
            best: isBest ? { gains: handGains, cost: total } : before.best,
          },
        },
      });
    },
  };
}
