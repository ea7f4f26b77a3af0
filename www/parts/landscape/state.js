// What the landscape keeps in the state.
/** @import { AxisChoice, Landscape } from './request.js' */
import { createSlice } from '../../run/store.js';

export const gainNames = /** @type {const} */ (['kx', 'ky', 'ktheta']);

export const landscapeSlice = createSlice(
  'landscape',
  {
    /** @type {AxisChoice} */ x: { gain: 'kx', log: false },
    /** @type {AxisChoice} */ y: { gain: 'ktheta', log: false },
    /** The gain that is on no axis; null: that of who drives. @type {number | null} */ third: null,
    thirdError: '',
    /** Values of the gains on the axes. @type {readonly [number, number] | null} */ cursor: null,
    /** @type {Landscape | null} */ result: null,
    message: '',
  },
  ['cursor', 'thirdError'],
);

/** @typedef {ReturnType<typeof landscapeSlice.of>} LandscapeState */
