// Dots that would lie on each other, beside and above each other instead, so that they can be counted.

/**
 * Each stands in its own column while that has room, else in the nearest that has; where none so near has any, above all others of its own.
 * @param {readonly number[]} columns Whole numbers, one a dot. @param {number} lines How many have room in a column. @param {number} reach How many columns aside one may stand. @param {readonly [number, number]} [ends] The first and the last column.
 */
export function stacked(columns, lines, reach, [first, last] = [-Infinity, Infinity]) {
  /** @type {Map<number, number>} */
  const heights = new Map();
  const heightOf = (/** @type {number} */ column) => heights.get(column) ?? 0;
  return columns.map((own) => {
    const near = Array.from({ length: 2 * reach + 1 }, (_, i) => own + (i % 2 ? 1 : -1) * Math.ceil(i / 2));
    const column = near.find((one) => one >= first && one <= last && heightOf(one) < lines) ?? own;
    const level = heightOf(column);
    heights.set(column, level + 1);
    return { column, level };
  });
}
