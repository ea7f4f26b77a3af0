// What is drawn of the Lyapunov function against time, where it lies, and the scales.
/** @import { Stability } from '../../../core/engine.js' */
/** @import { Axes, Frame, Scale, Value } from '../../../kit/chart.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import { endOf } from '../axes.js';

/** @typedef {{ token: string, from: Value, to: Value }} Area A part of V̇ between two edges. */
/** @typedef {{ lyapunov: Value, rate: Value, promised: Value, areas: Area[] }} Drawn */
/** @typedef {{ time: Scale, lyapunov: Axes, rate: Axes, isLog: boolean }} Layout */

/** Above is room for what V is. */
const margin = { left: 46, right: 46, top: 22, bottom: 24 };
const gap = 14;
/** Of the height that V gets. */
const share = 0.45;
/** In their order from zero. */
const tokens = ['--x', '--y', '--theta'];
/** The rate may leave the promised parts behind by so many times their span: a small V makes V̇/V huge. */
const reach = 2;
/** So many times as far as the rate may the promised parts reach, which no limit holds back. */
const promisedReach = 6;

/**
 * V, and V̇ with its promised parts, each on top of those before that have its sign. On a logarithmic axis the slope of V is V̇/V, so
 * this then stands for V̇.
 * @param {Stability} stability @param {boolean} isLog @returns {Drawn}
 */
export function drawnOf({ lyapunov, rate, promisedX, promisedY, promisedTheta }, isLog) {
  const scaled = (/** @type {number} */ value, /** @type {number} */ i) =>
    isLog ? value / lyapunov[i] : value;
  const parts = [promisedX, promisedY, promisedTheta];
  // A part is a square times a number that stays: it never changes its sign.
  const signs = parts.map((values) => Math.sign(values.find((value) => value !== 0) ?? 0));
  const sumOf = (/** @type {readonly Float64Array[]} */ some, /** @type {number} */ i) =>
    scaled(
      some.reduce((sum, values) => sum + values[i], 0),
      i,
    );
  const areas = parts.flatMap((values, p) => {
    if (!signs[p]) return [];
    const below = parts.slice(0, p).filter((_, other) => signs[other] === signs[p]);
    return [
      {
        token: tokens[p],
        from: (/** @type {number} */ i) => sumOf(below, i),
        to: (/** @type {number} */ i) => sumOf([...below, values], i),
      },
    ];
  });
  return {
    lyapunov: (i) => lyapunov[i],
    rate: (i) => scaled(rate[i], i),
    promised: (i) => sumOf(parts, i),
    areas,
  };
}

/**
 * @param {{ width: number, height: number }} size @param {Stability} driving @param {readonly Stability[]} others @param {boolean} isLog
 * @returns {Layout}
 */
export function layoutOf({ width, height }, driving, others, isLog) {
  const [left, right] = [margin.left, width - margin.right];
  const bottom = height - margin.bottom;
  const middle = margin.top + share * (bottom - margin.top - gap);
  const [upper, lower] = [
    { left, right, top: margin.top, bottom: middle },
    { left, right, top: middle + gap, bottom },
  ];
  const time = scaleLinear([0, endOf(driving, others)], [left, right]);
  return {
    time,
    isLog,
    lyapunov: { x: time, frame: upper, y: lyapunovScale(driving, others, upper, isLog) },
    rate: { x: time, frame: lower, y: rateScale(driving, lower, isLog) },
  };
}

/** @param {Stability} driving @param {readonly Stability[]} others @param {Frame} frame @param {boolean} isLog */
function lyapunovScale(driving, others, { top, bottom }, isLog) {
  const finite = (/** @type {Stability} */ { lyapunov }) =>
    lyapunov.filter((value) => value > 0 && Number.isFinite(value));
  const own = finite(driving);
  const most = own.reduce((a, b) => Math.max(a, b), 0) || 1;
  const all = others.map((other) => finite(other).reduce((a, b) => Math.max(a, b), 0));
  const high = Math.max(most, Math.min(2 * most, Math.max(0, ...all)));
  if (!isLog) return scaleLinear([0, 1.06 * high], [bottom, top]);
  const low = Math.max(
    own.reduce((a, b) => Math.min(a, b), most),
    1e-12 * most,
  );
  return scaleLog([low / 1.5, high * 1.5], [bottom, top]);
}

/** @param {Stability} driving @param {Frame} frame @param {boolean} isLog */
function rateScale(driving, { top, bottom }, isLog) {
  const { rate, promised, areas } = drawnOf(driving, isLog);
  const count = driving.time.length;
  const [low, high] = extentOf([promised, ...areas.map(({ to }) => to)], count);
  const own = extentOf([rate], count);
  const [lowest, highest] = isLog && high > low ? within(own, reach * (high - low)) : own;
  const [from, to] = highest > lowest ? within([low, high], promisedReach * (highest - lowest)) : [low, high];
  const ends = [Math.min(lowest, from), Math.max(highest, to)];
  // Nothing happens to a robot that starts at its goal.
  if (ends[0] === ends[1]) ends[0] = -1;
  const room = 0.06 * (ends[1] - ends[0]);
  return scaleLinear([ends[0] - room, ends[1] + room], [bottom, top]);
}

/** @param {readonly [number, number]} ends @param {number} most */
const within = ([low, high], most) => [Math.max(low, -most), Math.min(high, most)];

/** With zero in it. @param {readonly Value[]} values @param {number} count @returns {[number, number]} */
function extentOf(values, count) {
  let [low, high] = [0, 0];
  for (const value of values)
    for (let i = 0; i < count; i += 1) {
      const at = value(i);
      if (!Number.isFinite(at)) continue;
      low = Math.min(low, at);
      high = Math.max(high, at);
    }
  return [low, high];
}
