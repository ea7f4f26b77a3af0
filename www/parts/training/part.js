// Gains evolved on one start and on many, tested on starts that evolution never saw.
/** @import { Part } from '../part.js' */
import { makerFrom } from '../load.js';
import { partKey } from '../../link/keys.js';
import { oneNumberOf } from '../../link/values.js';
import { lengths, trainingSlice as slice } from './state.js';
import { load as loadWords } from './words/load.js';

/** The rows of the paper's gains. */
const papers = ':is(#training-paper-ep, #training-paper-arbitrary) .training-name';

/** @type {Part} */
export const training = {
  name: 'training',
  slice,
  keys: [partKey('evolve', slice, 'generations', (text) => oneNumberOf(lengths, text))],
  places: {
    gains: { lock: ':is(#training-one, #training-circle, #training-grid, #training-hand) .training-name' },
    drives: { lock: papers },
    paper: { lock: papers },
    postures: { lock: '#training-seen, #training-unseen' },
    run: { lock: '#training-evolve', hide: '.training-controls' },
  },
  tries: ['start'],
  figure: [0.7, 640],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
