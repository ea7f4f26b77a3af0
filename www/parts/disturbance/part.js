// The error that remains under a disturbance.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { disturbanceSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const disturbance = {
  name: 'disturbance',
  slice,
  places: { settings: { lock: '#disturbance-controls', hide: '#disturbance-controls' } },
  tries: ['start', 'disturbance'],
  beside: ['driver'],
  figure: [0.75, 680],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
