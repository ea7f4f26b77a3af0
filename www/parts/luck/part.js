// The same evolution with many seeds.
/** @import { Part } from '../part.js' */
import { partOf } from '../load.js';
import { luckSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

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
  load: () => partOf([loadWords()], import('./page.js'), ({ createLuckPage }) => createLuckPage),
};
