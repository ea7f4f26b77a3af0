// Gains evolved on one start and on many, tested on starts that evolution never saw.
/** @import { Part } from '../part.js' */
import { createTrainingPage } from './page.js';
import { trainingSlice as slice } from './state.js';

/** @type {Part} */
export const training = {
  name: 'training',
  slice,
  places: {
    postures: { lock: '#training-seen, #training-unseen' },
    run: { lock: '#training-evolve', hide: '.training-controls' },
  },
  tries: ['start'],
  figure: [0.7, 640],
  create: createTrainingPage,
};
