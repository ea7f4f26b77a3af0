// Every word on screen.
import { load } from './load.js';

/** @template T @typedef {import('./pick.js').Words<T>} Words */

const all = /** @type {import('./load.js').All} */ (await load());

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
