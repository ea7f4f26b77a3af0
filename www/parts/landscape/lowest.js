// The lowest point of a landscape, of those that its picture shows.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Landscape, Spec } from './request.js' */
import { gainOn, gainsAt } from './request.js';

/** `points`: of how many. A finer picture may have a lower one elsewhere. @typedef {{ gains: Triple, cost: number, points: number }} Lowest */

/** Whether what was computed has these axes. @param {Spec} computed @param {Spec} shown */
export const isOn = (computed, shown) =>
  computed.x === shown.x && computed.y === shown.y && computed.range === shown.range;

/** Where J is lowest, and how low; null while every J is infinite. @param {Landscape} landscape @returns {Lowest | null} */
export function lowestOf({ spec, count, costs }) {
  const least = costs.reduce((best, cost, i) => (cost < costs[best] ? i : best), 0);
  if (!Number.isFinite(costs[least])) return null;
  const gain = (/** @type {'x' | 'y'} */ axis, /** @type {number} */ index) =>
    gainOn(spec[axis], spec.range, index / (count - 1));
  return {
    gains: gainsAt(spec, [gain('x', least % count), gain('y', Math.floor(least / count))]),
    cost: costs[least],
    points: costs.length,
  };
}

/** What the map marks: nothing where all are alike. @param {Landscape} landscape */
export const markedOf = (landscape) =>
  landscape.costs.some((cost) => cost !== landscape.costs[0]) ? lowestOf(landscape) : null;
