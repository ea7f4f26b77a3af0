// What the lab keeps in the state.
import { createSlice } from '../run/store.js';

export const labCurves = /** @type {const} */ (['cost', 'sigmas']);

/** @typedef {typeof labCurves[number]} LabCurve What is shown over the generations. */

export const labSlice = createSlice('lab', /** @type {{ curve: LabCurve }} */ ({ curve: 'cost' }));
