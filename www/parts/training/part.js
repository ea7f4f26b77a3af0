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
  called: {
    en: {
      name: 'Training',
      purpose:
        'Gains evolved on one start have learned that start. Evolve on many, test on starts never seen before.',
    },
    ko: {
      name: '학습',
      purpose:
        '출발점 하나로 진화한 이득은 그 출발점만 익힙니다. 여러 출발점으로 진화시켜 처음 보는 곳에서 시험해 보십시오.',
    },
  },
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
  room: 'plane',
  figure: [0.7, 640],
  load: () => makerFrom([loadWords], () => import('./page.js')),
};
