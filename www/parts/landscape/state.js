// What the landscape keeps in the state.
/** @import { AxisChoice, Landscape } from './request.js' */
import { createSlice } from '../../run/store.js';

/**
 * @typedef {object} LandscapeState
 * @property {AxisChoice} x
 * @property {AxisChoice} y
 * @property {number | null} third The gain that is on no axis; null: that of who drives.
 * @property {string} thirdError
 * @property {readonly [number, number] | null} cursor Values of the gains on the axes.
 * @property {Landscape | null} result
 * @property {string} message
 */

export const gainNames = /** @type {const} */ (['kx', 'ky', 'ktheta']);

export const landscapeSlice = createSlice(
  'landscape',
  /** @type {LandscapeState} */ ({
    x: { gain: 'kx', log: false },
    y: { gain: 'ktheta', log: false },
    third: null,
    thirdError: '',
    cursor: null,
    result: null,
    message: '',
  }),
  ['cursor', 'thirdError'],
);
