// The same evolution with many seeds.
/** @import { Part } from '../part.js' */
import { createLuckPage } from './page.js';
import { luckSlice as slice } from './state.js';

/** @type {Part} */
export const luck = {
  name: 'luck',
  slice,
  places: {
    gains: { lock: '#luck-rank' },
    run: { lock: '#luck-run', hide: '.luck-bar' },
    seed: { lock: '#luck-open', hide: '#luck-open' },
  },
  figure: [0.7, 640],
  create: createLuckPage,
};
