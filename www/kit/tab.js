// What the browser keeps for this tab alone, and forgets with it.

/** Whether the page is loaded again, or one came back to it: not where somebody goes to an address anew. */
export function isBack() {
  const [entry] = /** @type {PerformanceNavigationTiming[]} */ (performance.getEntriesByType('navigation'));
  return entry?.type !== 'navigate';
}

/** A browser may keep nothing, or not for a figure in another page. @template T @param {(storage: Storage) => T} use @returns {T | null} */
export function withStorage(use) {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}
