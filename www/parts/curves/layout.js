// Where the plots against time lie, and their scales.
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Frame } from '../../kit/chart.js' */
import { scaleLinear } from 'd3-scale';
import { endOf } from './axes.js';
import { paidAt } from '../../core/paid.js';

/** @typedef {import('d3-scale').ScaleLinear<number, number>} Scale */
/** @typedef {'position' | 'theta' | 'linear' | 'angular' | 'cost'} PlotName */
/** @typedef {{ name: PlotName, frame: Frame, scale: Scale, limit: number | null }} Plot */
/** @typedef {{ time: Scale, plots: Plot[] }} Layout */

const margin = { left: 40, right: 64, top: 6, bottom: 24 };
const gap = 12;
/** J has the most to show. */
const shares = /** @type {readonly [PlotName, number][]} */ ([
  ['position', 1],
  ['theta', 0.9],
  ['linear', 0.9],
  ['angular', 0.9],
  ['cost', 1.5],
]);
/** Where there is no room for all. @type {readonly PlotName[]} */
const foremost = ['position', 'linear', 'cost'];
const roomForAll = 260;
/** So many of its spans they may reach beyond it; a costly one would leave no room for the parts of J. */
const reachOf = (/** @type {PlotName} */ name) => (name === 'cost' ? 1 : 2);

const inDegrees = (/** @type {number} */ radians) => (radians * 180) / Math.PI;

/** The curves of a plot: the value at each sample. @type {Readonly<Record<PlotName, readonly ((run: Run, i: number) => number)[]>>} */
export const curvesOf = {
  position: [(run, i) => run.x[i], (run, i) => run.y[i]],
  theta: [(run, i) => inDegrees(run.theta[i])],
  linear: [(run, i) => run.linear[i]],
  angular: [(run, i) => run.angular[i]],
  cost: [paidAt],
};

/**
 * @param {{ width: number, height: number }} size @param {Run} driving @param {readonly Run[]} others @param {Experiment['limits']} limits
 * @returns {Layout}
 */
export function layoutOf({ width, height }, driving, others, limits) {
  const [left, right] = [margin.left, width - margin.right];
  const shown = height < roomForAll ? shares.filter(([name]) => foremost.includes(name)) : shares;
  const free = height - margin.top - margin.bottom - gap * (shown.length - 1);
  const all = shown.reduce((sum, [, share]) => sum + share, 0);
  let top = margin.top;
  return {
    time: scaleLinear([0, endOf(driving, others)], [left, right]),
    plots: shown.map(([name, share]) => {
      const bottom = top + (free * share) / all;
      const frame = { left, right, top, bottom };
      top = bottom + gap;
      const limit = name === 'linear' ? limits.speed : name === 'angular' ? limits.turnRate : null;
      return {
        name,
        frame,
        limit,
        scale: scaleLinear(domainOf(name, driving, others, limit), [frame.bottom, frame.top]),
      };
    }),
  };
}

/** @param {PlotName} name @param {Run} driving @param {readonly Run[]} others @param {number | null} limit @returns {[number, number]} */
function domainOf(name, driving, others, limit) {
  const own = extentOf(name, driving);
  const reach = reachOf(name) * Math.max(own[1] - own[0], 1e-3);
  let [low, high] = own;
  for (const run of others) {
    const [from, to] = extentOf(name, run);
    low = Math.min(low, Math.max(from, own[0] - reach));
    high = Math.max(high, Math.min(to, own[1] + reach));
  }
  if (name !== 'theta') [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  if (name === 'cost') high = Math.max(high, Math.min(driving.cost.total, 1.6 * high));
  if (limit !== null && high > 0.6 * limit) high = Math.max(high, limit);
  if (limit !== null && low < -0.6 * limit) low = Math.min(low, -limit);
  // Above a limit there is room to see that more is asked for.
  const room = (limit === null ? 0.06 : 0.14) * Math.max(high - low, 1e-3);
  return [name === 'cost' ? low : low - room, high + room];
}

/** Of runs that are drawn again and again, as pins are. @type {WeakMap<Run, Partial<Record<PlotName, [number, number]>>>} */
const extents = new WeakMap();

/** @param {PlotName} name @param {Run} run @returns {[number, number]} */
function extentOf(name, run) {
  const known = extents.get(run)?.[name];
  if (known) return known;
  let [low, high] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (const value of curvesOf[name])
    for (let i = 0; i < run.time.length; i += 1) {
      const at = value(run, i);
      if (!Number.isFinite(at)) continue;
      low = Math.min(low, at);
      high = Math.max(high, at);
    }
  /** @type {[number, number]} */
  const extent = low <= high ? [low, high] : [0, 1];
  extents.set(run, { ...extents.get(run), [name]: extent });
  return extent;
}
