// The first thing to do: robots at many starts around one parking place, three sliders, and evolution, which does better.
/** @import { Part } from '../part.js' */
import { partKey } from '../../link/keys.js';
import { gainsUpTo, numberText } from '../../link/values.js';
import { makerFrom } from '../load.js';
import { mostGain, parkSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

const gainsKey = partKey(
  'park',
  slice,
  'gains',
  (text) => gainsUpTo(text, mostGain),
  (gains) => gains.map(numberText).join(','),
);

/** @type {Part} */
export const park = {
  name: 'park',
  slice,
  // Elsewhere nobody sees them, and they stay.
  keys: [
    {
      ...gainsKey,
      stays: true,
      text: (state, usual) => (state.page === 'park' ? gainsKey.text(state, usual) : null),
    },
  ],
  places: {
    gains: { lock: '#park-gains, .park-walk', hide: '#park-gains, .park-walk' },
    run: { lock: '#park-evolve', hide: '#park-evolve' },
  },
  alone: true,
  figure: [0.75, 640],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
