// The tests that need no browser. Where each browser has a process of its own, one process runs these for all.
import { test as declare } from 'node:test';

/** Which tests a process runs: what needs no browser, what the page does in every engine alike, what engines can do differently. @typedef {'logic' | 'page' | 'engine'} Kind */

/** Whether this process runs such tests: all of them, if nobody says. @param {Kind} kind */
export const runs = (kind) => (process.env.PAGE_TESTS ?? kind) === kind;

export const test = runs('logic') ? declare : /** @type {typeof declare} */ (() => {});

/**
 * What takes time to make, made when the first test needs it and then kept.
 * @template T
 * @param {() => Promise<T>} make
 */
export function onceOnly(make) {
  /** @type {Promise<T> | undefined} */
  let made;
  return () => {
    made ??= make();
    return made;
  };
}
