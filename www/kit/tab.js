// What the browser keeps for this tab alone, and forgets with it.

/** A browser may keep nothing, or not for a figure in another page. @template T @param {(storage: Storage) => T} use @returns {T | null} */
export function withStorage(use) {
  try {
    return use(sessionStorage);
  } catch {
    return null;
  }
}
