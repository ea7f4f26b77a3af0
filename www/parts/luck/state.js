// What Luck keeps in the state.
/** @import { SeedSurvey } from './request.js' */
import { createSlice } from '../../run/store.js';

/**
 * @typedef {object} LuckState
 * @property {number} count How many seeds to run next.
 * @property {number} generations For how many generations.
 * @property {boolean} log Costs are shown as the logarithm of their distance to the lowest.
 * @property {number | null} progress From 0 to 1 while seeds run.
 * @property {SeedSurvey | null} result
 * @property {number | null} chosen The index of a run.
 * @property {number | null} pointed The run under the pointer.
 * @property {boolean} cancelled
 * @property {string} message
 */

export const luckSlice = createSlice(
  'luck',
  /** @type {LuckState} */ ({
    count: 100,
    generations: 200,
    log: false,
    progress: null,
    result: null,
    chosen: null,
    pointed: null,
    cancelled: false,
    message: '',
  }),
);
