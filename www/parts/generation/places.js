// Where the individuals stand in the picture: how high is their J, and across by pairs or by rank.
/** @import { Anatomy, Phase } from './record.js' */
import { scaleLinear } from 'd3-scale';
import { forgets, hasPairs } from '../../core/methods.js';

/** @typedef {{ width: number, height: number }} Size */
/** @typedef {{ x: number, y: number }} Place */

export const margin = { left: 58, right: 8, top: 10, bottom: 22 };
/** The row of those whose J is far above most. */
const aboveRow = 20;

/** How high each J is drawn: the best at the bottom, those far above the median in a row of their own. @param {Pick<Anatomy, 'all'>} anatomy @param {Size} size */
export function heightOf({ all }, { height }) {
  const costs = all.map(({ cost }) => cost).filter(Number.isFinite);
  costs.sort((a, b) => a - b);
  const [low, high] = costs.length > 0 ? [costs[0], costs[costs.length - 1]] : [0, 1];
  const median = costs[Math.floor(costs.length / 2)] ?? low;
  const far = low + 4 * (median - low);
  const limit = far > low ? Math.min(far, high) : high;
  const crowded = limit < high || costs.length < all.length;
  const top = margin.top + (crowded ? aboveRow : 0);
  const scale = scaleLinear()
    .domain([low, limit > low ? limit : low + 1])
    .range([height - margin.bottom - 14, top + 6]);
  return {
    scale,
    /** The lowest J of the row above, where it begins and where its middle is. */
    above: crowded ? { limit, line: top, y: margin.top + 6 } : null,
    /** @param {number} cost */
    y: (cost) => (cost <= limit ? scale(cost) : margin.top + 6),
  };
}

/** The middle of one of several columns. @param {Size} size @param {number} columns */
export const columnsOf = ({ width }, columns) => {
  const step = (width - margin.left - margin.right) / columns;
  return { step, x: (/** @type {number} */ column) => margin.left + (column + 0.5) * step };
};

/** How large a mark may be. @param {Size} size @param {number} count */
export const radiusOf = (size, count) => Math.max(1.5, Math.min(6, 0.2 * columnsOf(size, count).step));

/** The place of each number. @param {Anatomy} anatomy @param {Phase} phase @param {Size} size @returns {Place[]} */
export function placesOf(anatomy, phase, size) {
  const { all, count, columns, staying, ranks } = anatomy;
  const { y } = heightOf(anatomy, size);
  const pairs = columnsOf(size, columns);
  const ranked = columnsOf(size, phase === 'ranking' ? anatomy.ranked : all.length);
  /** How far a parent stands left of the middle of its pair, and its offspring right. */
  const aside = Math.min(8, 0.25 * pairs.step);
  /** Before there is an offspring its parent stands alone, in the middle. @param {number} number */
  const byPair = (number) => {
    const apart = phase === 'parents' ? 0 : aside;
    return number < count ? pairs.x(number) - apart : pairs.x(number - count) + apart;
  };
  return all.map(({ cost }, number) => {
    if (phase === 'ranking') return { x: ranked.x(ranks[number]), y: y(cost) };
    if (phase === 'survivors') {
      const place = ranks[number];
      return { x: place < staying ? pairs.x(place) : ranked.x(place), y: y(cost) };
    }
    // Before its drive an offspring has no J: it waits beside its parent.
    const undriven = phase === 'parents' || phase === 'mutation';
    return { x: byPair(number), y: y(undriven ? all[number % count].cost : cost) };
  });
}

/** The numbers in sight, from left to right. @param {Anatomy} anatomy @param {Phase} phase @returns {number[]} */
export function orderOf({ all, count, columns, ranking, ranked, record, method }, phase) {
  if (phase === 'ranking') return ranking.slice(0, ranked);
  if (phase === 'survivors') return record.survivors;
  const parents = record.parents.map((_, number) => number);
  if (phase === 'parents' || all.length === count) return parents;
  if (forgets(method)) return record.offspring.map((_, i) => count + i);
  if (!hasPairs(method)) return all.map((_, number) => number);
  const pairs = Array.from({ length: columns }, (_, i) => [i < count ? i : -1, i + count]);
  return pairs.flat().filter((number) => number >= 0 && number < all.length);
}
