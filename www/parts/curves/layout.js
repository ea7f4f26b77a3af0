// Where the plots against time lie, and their scales.
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Frame } from '../../kit/chart.js' */
import { scaleLinear } from 'd3-scale';
import { paidAt } from '../../core/paid.js';
import { extentOf } from '../../kit/extent.js';
import { rememberEach } from '../../kit/memo.js';
import { endOf } from './axes.js';

/** @typedef {import('d3-scale').ScaleLinear<number, number>} Scale */
/** @typedef {'position' | 'theta' | 'linear' | 'angular' | 'cost'} PlotName */
/** A value at each sample. @typedef {(run: Run) => Float64Array} Column */
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
/** Where there is no room for all: what there is to compare with the paper's figure, or what there is to see of any drive. @type {Record<'figure' | 'any', readonly PlotName[]>} */
const foremost = {
  figure: ['position', 'theta', 'linear', 'angular'],
  any: ['position', 'linear', 'cost'],
};
const roomForAll = 260;
/** So many of its spans they may reach beyond it; a costly one would leave no room for the parts of J. */
const reachOf = (/** @type {PlotName} */ name) => (name === 'cost' ? 1 : 2);

const inDegrees = (/** @type {number} */ radians) => (radians * 180) / Math.PI;

/** The curves of a plot. @type {Readonly<Record<PlotName, readonly Column[]>>} */
export const curvesOf = {
  position: [(run) => run.x, (run) => run.y],
  theta: [rememberEach((run) => run.theta.map(inDegrees))],
  linear: [(run) => run.linear],
  angular: [(run) => run.angular],
  cost: [rememberEach((run) => run.time.map((_, i) => paidAt(run, i)))],
};

/**
 * @param {{ width: number, height: number }} size @param {Run} driving @param {readonly Run[]} others @param {Experiment['limits']} limits
 * @param {boolean} [isFigure] Whether the paper has a figure of it.
 * @returns {Layout}
 */
export function layoutOf({ width, height }, driving, others, limits, isFigure = false) {
  const [left, right] = [margin.left, width - margin.right];
  const first = foremost[isFigure ? 'figure' : 'any'];
  const shown = height < roomForAll ? shares.filter(([name]) => first.includes(name)) : shares;
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
  const own = extentsOf[name](driving);
  const reach = reachOf(name) * Math.max(own[1] - own[0], 1e-3);
  let [low, high] = own;
  for (const run of others) {
    const [from, to] = extentsOf[name](run);
    low = Math.min(low, Math.max(from, own[0] - reach));
    high = Math.max(high, Math.min(to, own[1] + reach));
  }
  if (name !== 'theta') [low, high] = [Math.min(low, 0), Math.max(high, 0)];
  if (name === 'cost') high = Math.max(high, Math.min(driving.cost.total, 1.6 * high));
  if (limit !== null && high > 0.6 * limit) high = Math.max(high, limit);
  if (limit !== null && low < -0.6 * limit) low = Math.min(low, -limit);
  // What does not change has an axis with short numbers all the same.
  const lacking = (name === 'theta' ? 0.2 : 0.02) - (high - low);
  if (lacking > 0) [low, high] = [name === 'cost' ? low : low - lacking / 2, high + lacking / 2];
  // Above a limit there is room to see that more is asked for.
  const room = (limit === null ? 0.06 : 0.14) * Math.max(high - low, 1e-3);
  return [name === 'cost' ? low : low - room, high + room];
}

/** @param {PlotName} name */
const extentOfRun = (name) =>
  rememberEach((/** @type {Run} */ run) => {
    const [low, high] = extentOf(curvesOf[name].map((column) => column(run)));
    return low <= high ? [low, high] : [0, 1];
  });

/** Of runs that are drawn again and again, as pins are. */
export const extentsOf = /** @type {Record<PlotName, (run: Run) => [number, number]>} */ (
  Object.fromEntries(Object.keys(curvesOf).map((name) => [name, extentOfRun(/** @type {PlotName} */ (name))]))
);
