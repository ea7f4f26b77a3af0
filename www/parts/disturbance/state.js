// What Disturbance keeps in the state; what is tried stands in the run.
/** @import { Measured } from './request.js' */
import { createSlice } from '../../run/store.js';

/**
 * @typedef {object} DisturbanceState
 * @property {{ index: number, text: string } | null} error Beside one of its two sizes.
 * @property {Measured | null} measured
 * @property {string} message
 */

export const disturbanceSlice = createSlice(
  'disturbance',
  /** @type {DisturbanceState} */ ({
    error: null,
    measured: null,
    message: '',
  }),
  ['error'],
);
