// What Park keeps in the state.
/** @import { Triple } from '../../core/engine.js' */
import { createSlice } from '../../run/store.js';

/** Gains, and from how many of the starts they park. @typedef {{ gains: Triple, parked: number }} Tried */
/** The best robot of a generation. @typedef {Tried & { generation: number, drives: number }} Bred */
/**
 * @typedef {object} ParkState
 * @property {Triple | null} gains By hand; null: nobody has moved a slider.
 * @property {Tried | null} best The best by hand, of equals the last.
 * @property {readonly Bred[]} bred What evolution has shown, one a generation.
 * @property {boolean} evolving
 * @property {{ share: number, gains: Triple } | null} between The gains that drive, and how far from the best by hand they are on the way to evolution's; null: others drive.
 * @property {number | null} looked The robot that is looked at, by its start.
 * @property {number} seed
 * @property {string} message
 */

/** Where the sliders end at first, which begin at 0: no hand parks all with them. */
const mostAtFirst = 12;
/** Where no slider of a link goes beyond. */
export const mostGain = 1000;

/**
 * Where the slider of a gain ends: further than at first where evolution, once it has ended, or a link has gone further.
 * @param {Pick<ParkState, 'gains' | 'bred' | 'evolving'>} state @param {number} index
 */
export function reachOf({ gains, bred, evolving }, index) {
  const found = evolving ? undefined : bred.at(-1);
  const largest = Math.max(gains?.[index] ?? 0, found?.gains[index] ?? 0);
  return largest > mostAtFirst ? 10 * Math.ceil(largest / 10) : mostAtFirst;
}

/** Whether they are on no slider of the beginning. @param {Triple} gains */
export const areFurther = (gains) => gains.some((gain) => gain > mostAtFirst);

/** How far evolution has found a gain beyond the slider, and to where that goes on now; null: it has not. @param {readonly Bred[]} bred @param {number} index */
export function beyondOf(bred, index) {
  const gain = bred.at(-1)?.gains[index] ?? 0;
  return gain > 1.5 * mostAtFirst ? { most: mostAtFirst, gain } : null;
}

const slice = createSlice(
  'park',
  /** @type {ParkState} */ ({
    ...{ gains: null, best: null, bred: [], evolving: false, seed: 1, message: '' },
    ...{ between: null, looked: null },
  }),
  [],
  ['gains', 'best', 'bred', 'evolving', 'seed'],
);

/** A link with other numbers begins with them afresh: what was found before is not of them. @type {typeof slice} */
export const parkSlice = {
  ...slice,
  opened(state, patch) {
    const { gains } = /** @type {Partial<ParkState>} */ (patch ?? {});
    const isOther = gains && String(gains) !== String(slice.of(state).gains);
    return isOther ? { ...slice.first, ...patch } : slice.opened(state, patch);
  },
};
