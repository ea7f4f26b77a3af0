// One generation, phase by phase.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { oneOf, wholeNumber } from '../../link/values.js';
import { generationSlice as slice, phases } from './state.js';
import { load as loadWords } from './words/load.js';

/** @type {Part} */
export const generation = {
  name: 'generation',
  slice,
  keys: [
    partKey('phase', slice, 'phase', (text) => oneOf(phases, text)),
    partKey('individual', slice, 'chosen', (text) => wholeNumber(text, 3999)),
  ],
  places: {
    run: {
      lock: '#generation-step, #generation-begin',
      hide: '#generation-step button, #generation-begin',
    },
  },
  phases: true,
  beside: ['evolution'],
  figure: [0.72, 620],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
