// The texts that stand in index.html, of all parts together.
import * as curves from './curves.js';
import * as disturbance from './disturbance.js';
import * as generation from './generation.js';
import * as keep from './keep.js';
import * as keys from './keys.js';
import * as lab from './lab.js';
import * as landscape from './landscape.js';
import * as luck from './luck.js';
import * as robustness from './robustness.js';
import * as settings from './settings.js';
import * as tables from './tables.js';
import * as training from './training.js';

/** Texts of elements with data-text, labels of elements with data-label. @type {Record<string, string>} */
export const texts = Object.assign(
  {},
  ...[
    lab,
    keys,
    keep,
    generation,
    curves,
    landscape,
    robustness,
    tables,
    training,
    disturbance,
    luck,
    settings,
  ].map((words) => words.texts),
);
