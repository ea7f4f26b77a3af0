// What is loaded of the words: those of the page's language.
/** @import { Language } from './language.js' */
import { language } from './language.js';

/**
 * Other texts, but as many of them, and functions of the same arguments.
 * @template T
 * @typedef {T extends string ? string : T extends (...args: infer A) => infer R ? (...args: A) => Alike<R> : T} Alike
 */
/** @template T @typedef {{ [Name in keyof T]: Alike<T[Name]> }} Words */

/**
 * The words of a room. Neither language has one that the other lacks.
 * @template E
 * @template K
 * @param {{ en: () => Promise<E & Words<K>>, ko: () => Promise<K & Words<E>> }} languages
 * @returns {() => Promise<Words<E> & Words<K>>}
 */
export const picked = (languages) =>
  /** @type {Record<Language, () => Promise<any>>} */ (languages)[language];
