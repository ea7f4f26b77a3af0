// Every word on screen, in the language of the page. Every language has the same words: the types demand it.
import * as en from './en/index.js';
import * as ko from './ko/index.js';
import { language } from './language.js';

/**
 * Other texts, but as many of them, and functions of the same arguments.
 * @template T
 * @typedef {T extends string ? string : T extends (...args: infer A) => infer R ? (...args: A) => Alike<R> : T} Alike
 */
/** @template T @typedef {{ [Name in keyof T]: Alike<T[Name]> }} Words */
/** @template T @typedef {{ [Part in keyof T]: Words<T[Part]> }} Parts */

/** Neither language has a word that the other lacks. @type {Record<import('./language.js').Language, Parts<typeof en> & Parts<typeof ko>>} */
const all = { en, ko };

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
} = all[language];

/** The texts that stand in index.html, by what its data-text, data-label and data-content say. @type {Record<string, string>} */
export const texts = Object.assign(
  {},
  ...Object.values(all[language]).map((words) => ('texts' in words ? words.texts : {})),
);
