// Keys of a link that are read together.

/** Of a value that is a list something cannot be read, and the rest is used. */
export class PartlyRead extends Error {
  /** @param {string} message @param {unknown} opened What was read. */
  constructor(message, opened) {
    super(message);
    this.opened = opened;
  }
}

/**
 * A value may be allowed only beside one that comes after it, as a short sample time is with a short horizon.
 * @template T
 * @param {Iterable<[string, string]>} given @param {T} opened @param {(opened: T, key: string, text: string) => T} read
 */
export function readAll(given, opened, read) {
  /** @type {[string, string][]} */
  let left = [...given];
  /** @type {[string, unknown][]} */
  let refused;
  let before;
  do {
    before = left;
    left = [];
    refused = [];
    for (const [key, text] of before) {
      try {
        opened = read(opened, key, text);
      } catch (error) {
        if (error instanceof PartlyRead) opened = /** @type {T} */ (error.opened);
        left.push([key, text]);
        refused.push([key, error]);
      }
    }
  } while (left.length < before.length);
  return { opened, refused };
}
