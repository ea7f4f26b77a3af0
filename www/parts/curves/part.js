// The drive against time, its stability, and runs beside each other.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { labCurves, labSlice } from '../../lab/state.js';
import { partKey } from '../../link/keys.js';
import { oneOf } from '../../link/values.js';
import { curvesSlice as slice, scales, views } from './state.js';
import { load as loadStability } from './stability/words/load.js';
import { load as loadWords } from './words/load.js';

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
  // What a gain does to V̇ is seen while it is moved. The lesson needs the height.
  gains: (state) => slice.of(state).view === 'stability' || (state.driver === 'hand' && state.lesson === 0),
  pays: true,
  beside: ['driver'],
  figure: [0.72, 700],
  load: () => makerFrom([loadWords, loadStability], () => import('./page.js')),
};
