// The languages in which a controller is written down: a row for each.
/** @import { Controller } from './controller.js' */
/** @import { Words } from './parts.js' */
import { c } from './c.js';
import { javascript } from './javascript.js';
import { matlab } from './matlab.js';
import { python } from './python.js';

/** @typedef {'python' | 'c' | 'matlab' | 'javascript'} LanguageName */
/** @typedef {{ ending: string, type: string, comment: string, write: (controller: Controller, words: Words['comments']) => string }} Language */

/** @type {Readonly<Record<LanguageName, Language>>} */
export const languages = {
  python: { ending: 'py', type: 'text/x-python', comment: '#', write: python },
  c: { ending: 'c', type: 'text/x-c', comment: '//', write: c },
  matlab: { ending: 'm', type: 'text/x-matlab', comment: '%', write: matlab },
  javascript: { ending: 'mjs', type: 'text/javascript', comment: '//', write: javascript },
};
