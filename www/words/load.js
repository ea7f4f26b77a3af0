// The words of the page itself, in its language, which alone is loaded. Every language has the same words: the types demand it.
import { picked } from './pick.js';

/** @template T @typedef {import('./pick.js').Words<T>} Words */

/** @template T @typedef {{ [Part in keyof T]: Words<T[Part]> }} Parts */

/** Neither language has a word that the other lacks. @typedef {Parts<typeof import('./en/index.js')> & Parts<typeof import('./ko/index.js')>} All */

export const load = picked(
  /** @type {{ en: () => Promise<any>, ko: () => Promise<any> }} */ ({
    en: () => import('./en/index.js'),
    ko: () => import('./ko/index.js'),
  }),
);
