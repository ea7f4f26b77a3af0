// What is loaded of the words: those of the page's language.
import { language } from './language.js';

/**
 * Other texts, but as many of them, and functions of the same arguments.
 * @template T
 * @typedef {T extends string ? string : T extends (...args: infer A) => infer R ? (...args: A) => Alike<R> : T} Alike
 */
/** @template T @typedef {{ [Name in keyof T]: Alike<T[Name]> }} Words */
/** What each of them is. @template U @typedef {(U extends any ? (one: U) => void : never) extends (one: infer I) => void ? I : never} Each */

/**
 * The words of a room. Neither language has one that the other lacks.
 * @template E
 * @template K
 * @param {{ en: () => Promise<E & Words<K>>, ko: () => Promise<K & Words<E>> }} languages
 * @returns {(() => Promise<Words<E> & Words<K>>) & { there: () => Words<E> & Words<K> }} `there`: the words, once they are loaded.
 */
export function picked(languages) {
  const bring = languages[language];
  /** @type {any} */
  let words;
  const load = async () => {
    words ??= await bring();
    return words;
  };
  return Object.assign(load, { there: () => words });
}

/**
 * What needs words is loaded after them. If it awaited them itself, WebKit would hold for ever a page from which it is taken away meanwhile.
 * @template M
 * @param {readonly (() => Promise<unknown>)[]} words @param {() => Promise<M>} module
 * @returns {Promise<M>}
 */
export async function afterWords(words, module) {
  await Promise.all(words.map((load) => load()));
  return module();
}
