// The tests that need no browser. Where each browser has a process of its own, one process runs these for all.
import { test as declare } from 'node:test';

/** Which tests this process runs: 'in browsers', 'without browsers', or, if nobody says, both. */
const { PAGE_TESTS } = process.env;

export const isForBrowsers = PAGE_TESTS !== 'without browsers';

export const test = PAGE_TESTS === 'in browsers' ? /** @type {typeof declare} */ (() => {}) : declare;

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
