// From J to a colour, and from gains to pixels.
/** @import { AxisChoice } from './request.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import { costText, fixed, textsApart } from '../../words/numbers.js';

/** @typedef {ReturnType<typeof createCostScale>} CostScale */

/**
 * Shades for costs from the lowest to the highest of a landscape, most of them for the low ones: there lies the valley.
 * @param {Float64Array} costs
 */
export function createCostScale(costs) {
  const sorted = costs.filter(Number.isFinite).sort();
  const low = sorted[0] ?? 0;
  const high = Math.max(sorted[Math.floor(0.98 * (sorted.length - 1))] ?? 1, low + 1e-9);
  const bend = 0.02 * (high - low);
  const whole = Math.log1p((high - low) / bend);
  /** 0 at the lowest cost, 1 at the highest and beyond. @param {number} cost */
  const part = (cost) => (cost < high ? Math.log1p(Math.max(0, cost - low) / bend) / whole : 1);
  return { low, high, most: sorted[sorted.length - 1] ?? high, part, levels: levelsBetween(low, high, part) };
}

/** What stands at the scale: its levels, or the two ends where no two levels tell how far apart those are. @param {CostScale} scale */
export function numbersAt({ low, high, most, part, levels }) {
  if (levels.length > 1) {
    const digits = levels.some((level) => level % 1 !== 0) ? 1 : 0;
    return levels.map((level) => ({ part: part(level), text: fixed(level, level < 100 ? digits : 0) }));
  }
  if (most === low) return [{ part: 0, text: costText(low) }];
  const [first, last] = textsApart(low, high, costText);
  return [
    { part: 0, text: first },
    { part: 1, text: most > high ? `≥\u202f${last}` : last },
  ];
}

/** Round numbers from 0.1 to 99 000, the roundest first. */
const roundCosts = [[1], [2], [5], Array.from({ length: 99 }, (_, i) => i + 1)].flatMap((digits) =>
  [0.1, 1, 10, 100, 1000].flatMap((step) => digits.map((digit) => Number((digit * step).toPrecision(4)))),
);

/** Round costs that lie about evenly over the shades. @param {number} low @param {number} high @param {(cost: number) => number} part */
function levelsBetween(low, high, part) {
  const apart = 0.1;
  /** @type {number[]} */
  const levels = [];
  for (const cost of roundCosts) {
    if (cost <= low || cost >= high) continue;
    const own = part(cost);
    if ([0, 1, ...levels.map(part)].every((other) => Math.abs(own - other) >= apart)) levels.push(cost);
  }
  return levels.sort((a, b) => a - b);
}

/**
 * One axis of gains in pixels.
 * @param {AxisChoice} choice @param {readonly [number, number]} ends @param {readonly [number, number]} pixels
 */
export function createAxis(choice, ends, pixels) {
  const scale = (choice.log ? scaleLog() : scaleLinear()).domain(ends).range(pixels);
  const [low, high] = [Math.min(...pixels), Math.max(...pixels)];
  return {
    /** @param {number} value A value that a log axis cannot show lies far beyond its low end. */
    at: (value) => (choice.log && value <= 0 ? 2 * pixels[0] - pixels[1] : scale(value)),
    /** The value there, on the axis. @param {number} px */
    value: (px) => scale.invert(Math.min(Math.max(px, low), high)),
    /** @param {number} value */
    holds: (value) => value >= ends[0] && value <= ends[1],
    ticks: choice.log ? [0.01, 0.1, 1, 10, 100].filter((tick) => tick <= ends[1]) : scale.ticks(6),
  };
}
