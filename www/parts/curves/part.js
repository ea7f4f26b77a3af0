// The drive against time, its stability, and runs beside each other.
/** @import { Part } from '../part.js' */
import { labCurves, labSlice } from '../../lab/state.js';
import { partKey } from '../../link/keys.js';
import { oneOf } from '../../link/values.js';
import { createCurvesPage } from './page.js';
import { curvesSlice as slice, scales, views } from './state.js';

/** @type {Part} */
export const curves = {
  name: 'curves',
  slice,
  keys: [
    partKey('view', slice, 'view', (text) => oneOf(views, text)),
    // The lab's own, which stands here in every link that was ever written.
    partKey('curve', labSlice, 'curve', (text) => oneOf(labCurves, text)),
    partKey('scale', slice, 'scale', (text) => oneOf(scales, text)),
  ],
  figure: [0.72, 700],
  create: createCurvesPage,
};
