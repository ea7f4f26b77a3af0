// How far columns of numbers reach. As arguments of Math.max they may be too many for an engine.
import { rememberEach } from './memo.js';

/** @param {ArrayLike<number>} values */
export function largest(values) {
  let most = Number.NEGATIVE_INFINITY;
  for (let i = 0; i < values.length; i += 1) most = Math.max(most, values[i]);
  return most;
}

/** The least and the largest of all that are finite. @param {readonly ArrayLike<number>[]} columns @param {readonly [number, number]} [least] What they span at least. @returns {[number, number]} */
export function extentOf(columns, [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]) {
  for (const values of columns) {
    const ends = (values instanceof Float64Array && outlineOf(values)?.ends) || null;
    const count = ends?.length ?? values.length;
    for (let i = 0; i < count; i += 1) {
      const at = values[ends ? ends[i] : i];
      if (at < low && at !== Number.NEGATIVE_INFINITY) low = at;
      if (at > high && at !== Number.POSITIVE_INFINITY) high = at;
    }
  }
  return [low, high];
}

/** Columns that are longer have an outline, of about half as many stretches. */
const long = 8192;

/** What a long column reaches: of each stretch of so many numbers where the least and the largest stand. @typedef {{ stretch: number, ends: Uint32Array }} Outline */

/** The outline of a long column of finite numbers, which is drawn again and again. @type {(values: Float64Array) => Outline | null} */
export const outlineOf = (values) => (values.length > long ? longOutline(values) : null);

const longOutline = rememberEach((/** @type {Float64Array} */ values) => {
  const stretch = Math.ceil((2 * values.length) / long);
  const ends = new Uint32Array(2 * Math.ceil(values.length / stretch));
  let sum = 0;
  for (let from = 0, at = 0; from < values.length; from += stretch, at += 2) {
    const end = Math.min(from + stretch, values.length);
    let [least, most, low, high] = [from, from, values[from], values[from]];
    for (let i = from; i < end; i += 1) {
      const value = values[i];
      if (value < low) {
        least = i;
        low = value;
      } else if (value > high) {
        most = i;
        high = value;
      }
      sum += value;
    }
    ends[at] = least;
    ends[at + 1] = most;
  }
  return Number.isFinite(sum) ? { stretch, ends } : null;
});
