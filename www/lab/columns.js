// A history by columns. It is drawn at every generation and may be long: of what has grown only what is new is read.
/** @import { Statistics } from '../core/engine.js' */

/** What a curve cannot show is NaN. @type {Record<'generation' | 'best' | 'median' | 'kx' | 'ky' | 'ktheta', (one: Statistics) => number>} */
const numbers = {
  generation: ({ generation }) => generation,
  best: ({ best }) => finite(best.cost),
  median: ({ median }) => finite(median),
  // A σ that has underflowed has no place on a logarithmic axis.
  kx: ({ meanSigmas }) => meanSigmas[0] || Number.NaN,
  ky: ({ meanSigmas }) => meanSigmas[1] || Number.NaN,
  ktheta: ({ meanSigmas }) => meanSigmas[2] || Number.NaN,
};

const finite = (/** @type {number} */ value) => (Number.isFinite(value) ? value : Number.NaN);

/** @template {keyof typeof numbers} K @param {readonly K[]} names */
export function createColumns(names) {
  const columns = names.map((name) => ({ name, values: new Float64Array(256) }));
  let count = 0;
  /** @type {Statistics | undefined} */
  let last;

  /** @param {readonly Statistics[]} history @returns {Record<K, Float64Array>} */
  return (history) => {
    // Of another run nothing is the same.
    if (count > history.length || history[count - 1] !== last) count = 0;
    for (const column of columns) {
      if (column.values.length < history.length) {
        const larger = new Float64Array(2 * history.length);
        larger.set(column.values);
        column.values = larger;
      }
      for (let i = count; i < history.length; i += 1) column.values[i] = numbers[column.name](history[i]);
    }
    count = history.length;
    last = history[count - 1];
    return /** @type {Record<K, Float64Array>} */ (
      Object.fromEntries(columns.map(({ name, values }) => [name, values.subarray(0, count)]))
    );
  };
}
