// Fields of an experiment by their paths, such as `weights.final[2]`.
/** @import { Experiment } from '../core/engine.js' */

/** @typedef {number | string | null} Value A number, a word, or null for no limit. */
/** @typedef {{ [key: string]: Value | Tree }} Tree */

/** @param {string} path */
const keysOf = (path) => path.split(/[.[\]]+/).filter(Boolean);

/** @param {Experiment} experiment @param {string} path @returns {Value} */
export const valueAt = (experiment, path) =>
  /** @type {Value} */ (
    keysOf(path).reduce(
      (/** @type {Value | Tree} */ part, key) => /** @type {Tree} */ (part)[key],
      /** @type {Tree} */ (/** @type {unknown} */ (experiment)),
    )
  );

/** The same experiment but for one field. @param {Experiment} experiment @param {string} path @param {Value} value */
export function withValue(experiment, path, value) {
  const next = structuredClone(experiment);
  const keys = keysOf(path);
  const last = keys.pop();
  if (!last) throw new Error('settings: a path has at least one key');
  let part = /** @type {Tree} */ (/** @type {unknown} */ (next));
  for (const key of keys) part = /** @type {Tree} */ (part[key]);
  part[last] = value;
  return next;
}

/** The path in `fields()`, where `[]` means each element. @param {string} path */
export const fieldPath = (path) => path.replace(/\[\d+\]/g, '[]');
