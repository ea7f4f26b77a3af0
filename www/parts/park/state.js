// What Park keeps in the state.
/** @import { Triple } from '../../core/engine.js' */
import { createSlice } from '../../run/store.js';

/** Gains, and from how many of the starts they park. @typedef {{ gains: Triple, parked: number }} Tried */
/** The best robot of a generation. @typedef {Tried & { generation: number, drives: number }} Bred */

/** Where no slider of a link goes beyond. */
export const mostGain = 1000;

/** Sliders that go as far as these gains, and no less far than they did. @param {Triple} ends @param {Triple} gains @returns {Triple} */
export function reaching(ends, gains) {
  const [kx, ky, ktheta] = ends.map((end, i) => (gains[i] > end ? 10 * Math.ceil(gains[i] / 10) : end));
  return [kx, ky, ktheta];
}

/** Whether some gain is on no slider that ends there. @param {Triple} gains @param {Triple} ends */
export const areBeyond = (gains, ends) => gains.some((gain, i) => gain > ends[i]);

const slice = createSlice(
  'park',
  {
    /** By hand; null: nobody has moved a slider. @type {Triple | null} */ gains: null,
    /** The best by hand, of equals the last. @type {Tried | null} */ best: null,
    /** What evolution has shown, one a generation. @type {readonly Bred[]} */ bred: [],
    evolving: false,
    /** The gains that drive, and how far from the best by hand they are on the way to evolution's; null: others drive. @type {{ share: number, gains: Triple } | null} */
    between: null,
    /** The robot that is looked at, by its start. @type {number | null} */ looked: null,
    seed: 1,
    /** Where the sliders end, which begin at 0. At first no hand parks all with them; they grow to where evolution has gone, and do not shrink. @type {Triple} */
    ends: [12, 12, 12],
    /** Where they ended before evolution came to its end. @type {Triple} */ endsBefore: [12, 12, 12],
    message: '',
  },
  ['message'],
  ['gains', 'best', 'bred', 'evolving', 'seed', 'ends', 'endsBefore'],
);

/** @typedef {ReturnType<typeof slice.of>} ParkState */

/** A link with other numbers begins with them afresh: what was found before is not of them. @type {typeof slice} */
export const parkSlice = {
  ...slice,
  opened(state, patch) {
    const { gains } = /** @type {Partial<ParkState>} */ (patch ?? {});
    const isOther = gains && String(gains) !== String(slice.of(state).gains);
    if (!isOther) return slice.opened(state, patch);
    const ends = reaching(slice.first.ends, gains);
    return { ...slice.first, ...patch, ends, endsBefore: ends };
  },
};
