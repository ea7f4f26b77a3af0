// Every word on screen, in the language of the page, which alone is loaded. Every language has the same words: the types demand it.
import { language } from './language.js';

/**
 * Other texts, but as many of them, and functions of the same arguments.
 * @template T
 * @typedef {T extends string ? string : T extends (...args: infer A) => infer R ? (...args: A) => Alike<R> : T} Alike
 */
/** @template T @typedef {{ [Name in keyof T]: Alike<T[Name]> }} Words */
/** @template T @typedef {{ [Part in keyof T]: Words<T[Part]> }} Parts */

/** Neither language has a word that the other lacks. @typedef {Parts<typeof import('./en/index.js')> & Parts<typeof import('./ko/index.js')>} All */

/** @type {Record<import('./language.js').Language, () => Promise<All>>} */
const load = { en: () => import('./en/index.js'), ko: () => import('./ko/index.js') };

const all = await load[language]();

export const {
  checks,
  curves,
  disturbance,
  embed,
  exercise,
  generation,
  instead,
  keep,
  keys,
  lab,
  landscape,
  lesson,
  link,
  luck,
  messages,
  robustness,
  settings,
  stability,
  tables,
  training,
} = all;

/** The texts that stand in index.html, by what its data-text, data-label and data-content say. @type {Record<string, string>} */
export const texts = Object.assign(
  {},
  ...Object.values(all).map((words) => ('texts' in words ? words.texts : {})),
);
