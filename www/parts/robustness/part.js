// One set of gains from many starts: where does the robot arrive?
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { oneNumberOf, oneOf, wholeNumber } from '../../link/values.js';
import { headings } from './grid.js';
import { halves, quantities, robustnessSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const robustness = {
  name: 'robustness',
  slice,
  keys: [
    partKey('colour', slice, 'quantity', (text) => oneOf(quantities, text)),
    partKey('half', slice, 'half', (text) => oneNumberOf(halves, text)),
    partKey('heading', slice, 'heading', (text) => wholeNumber(text, headings - 1)),
  ],
  places: { postures: { lock: '#robustness-map' } },
  tries: ['start'],
  beside: ['cost', 'driver'],
  figure: [0.64, 620],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
