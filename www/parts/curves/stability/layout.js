// What is drawn of the Lyapunov function against time, where it lies, and the scales.
/** @import { Stability } from '../../../core/engine.js' */
/** @import { Axes, Frame, Scale } from '../../../kit/chart.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import { extentOf } from '../../../kit/extent.js';
import { rememberEach } from '../../../kit/memo.js';
import { endOf } from '../axes.js';

/** @typedef {{ part: number, token: string, from: Float64Array, to: Float64Array }} Area A part of V̇ between two edges; 0, 1, 2 for the three gains. */
/** @typedef {{ rate: Float64Array, promised: Float64Array, areas: Area[] }} Drawn */
/** @typedef {{ time: Scale, lyapunov: Axes, rate: Axes, isLog: boolean }} Layout */

/** Above is room for what V is. */
const margin = { left: 46, right: 46, top: 22, bottom: 24 };
/** On the left of numbers with a power of ten. */
const marginOfPowers = 62;
const gap = 14;
/** Of the height that V gets. */
const share = 0.45;
/** In their order from zero. */
const tokens = ['--x', '--y', '--theta'];
/** The rate may leave the promised parts behind by so many times their span: a small V makes V̇/V huge. */
const reach = 2;
/** So many times as far as the rate may the promised parts reach, which no limit holds back. */
const promisedReach = 6;

/** The largest value of V, from above zero, and the least beyond it. */
export const rangeOf = rememberEach((/** @type {Stability} */ { lyapunov }) => {
  let [least, most] = [Number.POSITIVE_INFINITY, 0];
  for (let i = 0; i < lyapunov.length; i += 1) {
    const value = lyapunov[i];
    if (!(value > 0 && value < Number.POSITIVE_INFINITY)) continue;
    if (value < least) least = value;
    if (value > most) most = value;
  }
  return { least, most };
});

const drawnOnEven = rememberEach((/** @type {Stability} */ stability) => drawn(stability, false));
const drawnOnLog = rememberEach((/** @type {Stability} */ stability) => drawn(stability, true));

/**
 * V̇ with its promised parts, each on top of those before that have its sign. On a logarithmic axis the slope of V is V̇/V, so
 * this then stands for V̇.
 * @param {Stability} stability @param {boolean} isLog
 */
export const drawnOf = (stability, isLog) => (isLog ? drawnOnLog : drawnOnEven)(stability);

/** @param {Stability} stability @param {boolean} isLog @returns {Drawn} */
function drawn({ lyapunov, rate, promisedX, promisedY, promisedTheta }, isLog) {
  const scaled = (/** @type {Float64Array} */ values) =>
    isLog ? values.map((value, i) => value / lyapunov[i]) : values;
  const parts = [promisedX, promisedY, promisedTheta];
  // A part is a square times a number that stays: it never changes its sign.
  const signs = parts.map((values) => Math.sign(values.find((value) => value !== 0) ?? 0));
  const sumOf = (/** @type {readonly Float64Array[]} */ some) => {
    const sums = new Float64Array(lyapunov.length);
    for (const values of some) for (let i = 0; i < sums.length; i += 1) sums[i] += values[i];
    return scaled(sums);
  };
  const areas = parts.flatMap((values, p) => {
    if (!signs[p]) return [];
    const below = parts.slice(0, p).filter((_, other) => signs[other] === signs[p]);
    return [{ part: p, token: tokens[p], from: sumOf(below), to: sumOf([...below, values]) }];
  });
  return { rate: scaled(rate), promised: sumOf(parts), areas };
}

/**
 * @param {{ width: number, height: number }} size @param {Stability} driving @param {readonly Stability[]} others @param {boolean} isLog
 * @returns {Layout}
 */
export function layoutOf({ width, height }, driving, others, isLog) {
  const bottom = height - margin.bottom;
  const middle = margin.top + share * (bottom - margin.top - gap);
  const [above, below] = [
    { top: margin.top, bottom: middle },
    { top: middle + gap, bottom },
  ];
  const scales = [lyapunovScale(driving, others, above, isLog), rateScale(driving, below, isLog)];
  const hasPowers = scales.some((scale) => scale.domain().some((end) => Math.abs(end) >= 1e5));
  const [left, right] = [hasPowers ? marginOfPowers : margin.left, width - margin.right];
  const time = scaleLinear([0, endOf(driving, others)], [left, right]);
  return {
    time,
    isLog,
    lyapunov: { x: time, frame: { left, right, ...above }, y: scales[0] },
    rate: { x: time, frame: { left, right, ...below }, y: scales[1] },
  };
}

/** @param {Stability} driving @param {readonly Stability[]} others @param {Pick<Frame, 'top' | 'bottom'>} frame @param {boolean} isLog */
function lyapunovScale(driving, others, { top, bottom }, isLog) {
  const own = rangeOf(driving);
  const most = own.most || 1;
  const high = Math.max(most, Math.min(2 * most, Math.max(0, ...others.map((other) => rangeOf(other).most))));
  if (!isLog) return scaleLinear([0, 1.06 * high], [bottom, top]);
  const low = Math.max(Math.min(own.least, most), 1e-12 * most);
  return scaleLog([low / 1.5, high * 1.5], [bottom, top]);
}

/** @param {Stability} driving @param {Pick<Frame, 'top' | 'bottom'>} frame @param {boolean} isLog */
function rateScale(driving, { top, bottom }, isLog) {
  const { rate, promised, areas } = drawnOf(driving, isLog);
  const [low, high] = extentOf([promised, ...areas.map(({ to }) => to)], zero);
  const own = extentOf([rate], zero);
  const [lowest, highest] = isLog && high > low ? within(own, reach * (high - low)) : own;
  const [from, to] = highest > lowest ? within([low, high], promisedReach * (highest - lowest)) : [low, high];
  const ends = [Math.min(lowest, from), Math.max(highest, to)];
  // Nothing happens to a robot that starts at its goal.
  if (ends[0] === ends[1]) ends[0] = -1;
  const room = 0.06 * (ends[1] - ends[0]);
  return scaleLinear([ends[0] - room, ends[1] + room], [bottom, top]);
}

const zero = /** @type {const} */ ([0, 0]);

/** @param {readonly [number, number]} ends @param {number} most */
const within = ([low, high], most) => [Math.max(low, -most), Math.min(high, most)];
