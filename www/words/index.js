// Every word on screen, in the language of the page, which alone is loaded. Every language has the same words: the types demand it.
import { language } from './language.js';

/** @template T @typedef {import('./pick.js').Words<T>} Words */

/** @template T @typedef {{ [Part in keyof T]: Words<T[Part]> }} Parts */

/** Neither language has a word that the other lacks. @typedef {Parts<typeof import('./en/index.js')> & Parts<typeof import('./ko/index.js')>} All */

/** @type {Record<import('./language.js').Language, () => Promise<All>>} */
const load = { en: () => import('./en/index.js'), ko: () => import('./ko/index.js') };

const all = await load[language]();

export const {
  embed,
  exercise,
  instead,
  keys,
  lab,
  lesson,
  link,
  messages,
  opening,
  pins,
  settings,
  sigmas,
  tables,
} = all;

/** The texts that stand in index.html, by what its data-text, data-label and data-content say. @type {Record<string, string>} */
export const texts = Object.assign(
  {},
  ...Object.values(all).map((words) => ('texts' in words ? words.texts : {})),
);
