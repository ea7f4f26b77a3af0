// Of the pictures of a class: how far their axes reach, and how many have which J.
import { roundStep } from '../../kit/steps.js';

/** Whether the aim is met, or that nobody can tell. @typedef {'met' | 'not' | 'unjudged'} Kind */
/** @typedef {{ cost: number, gains: readonly number[], kind: Kind }} Point */

/** @type {readonly Kind[]} */
export const kinds = ['met', 'not', 'unjudged'];

/** So many bins, at the most. */
const most = 24;
/** Between these shares of a class all is shown, and as far again on both sides. */
const close = { from: 0.1, to: 0.9 };

/** From the least to the largest of those that are not far from the others. @param {readonly number[]} values @returns {[number, number]} */
export function reach(values) {
  const inOrder = [...values].sort((a, b) => a - b);
  const at = (/** @type {number} */ share) => inOrder[Math.floor(share * (inOrder.length - 1))] ?? 0;
  const [from, to] = [at(close.from), at(close.to)];
  const more = to > from ? to - from : Number.POSITIVE_INFINITY;
  const near = inOrder.filter((value) => value >= from - more && value <= to + more);
  return [near[0] ?? 0, near[near.length - 1] ?? 1];
}

/**
 * How many of each kind are in each bin, from `first` on each `step` wide, and how many are worse than all of these. An aim is a
 * border between two bins, because whoever is on it does not meet it.
 * @param {readonly Point[]} points @param {number | null} aim
 */
export function binsOf(points, aim) {
  const costs = points.map(({ cost }) => cost);
  const high = Math.max(reach(costs)[1], aim ?? Number.NEGATIVE_INFINITY);
  const low = costs.reduce((least, cost) => Math.min(least, cost), aim ?? high);
  const step = roundStep((high - low) / most || 0.1, [1, 2, 2.5, 5]);
  const zero = aim ?? 0;
  const binOf = (/** @type {number} */ cost) => Math.floor((cost - zero) / step);
  const firstBin = binOf(low);
  const count = binOf(high) - firstBin + 1;
  const empty = () => ({ met: 0, not: 0, unjudged: 0 });
  const bins = Array.from({ length: count }, empty);
  const beyond = empty();
  for (const { cost, kind } of points) (bins[binOf(cost) - firstBin] ?? beyond)[kind] += 1;
  return { bins, beyond, first: zero + firstBin * step, step };
}
