// What Disturbance keeps in the state; what is tried stands in the run.
/** @import { Measured } from './request.js' */
import { createSlice } from '../../run/store.js';

export const disturbanceSlice = createSlice(
  'disturbance',
  {
    /** Beside one of its two sizes. @type {{ index: number, text: string } | null} */ error: null,
    /** @type {Measured | null} */ measured: null,
    message: '',
  },
  ['error'],
);

/** @typedef {ReturnType<typeof disturbanceSlice.of>} DisturbanceState */
