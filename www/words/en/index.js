// The texts that stand in index.html, of all parts together.
import * as disturbance from './disturbance.js';
import * as lab from './lab.js';
import * as landscape from './landscape.js';
import * as luck from './luck.js';
import * as robustness from './robustness.js';
import * as training from './training.js';

/** Texts of elements with data-text, labels of elements with data-label. @type {Record<string, string>} */
export const texts = Object.assign(
  {},
  ...[lab, landscape, robustness, training, disturbance, luck].map((words) => words.texts),
);
