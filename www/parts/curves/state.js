// What Curves keeps in the state.
import { createSlice } from '../../run/store.js';

export const views = /** @type {const} */ (['time', 'stability', 'compare', 'numbers']);
export const scales = /** @type {const} */ (['linear', 'log']);

/** @typedef {typeof views[number]} CurvesView */
/** @typedef {{ view: CurvesView, scale: typeof scales[number], message: string }} CurvesState */

export const curvesSlice = createSlice(
  'curves',
  /** @type {CurvesState} */ ({ view: 'time', scale: 'linear', message: '' }),
  ['message'],
);
