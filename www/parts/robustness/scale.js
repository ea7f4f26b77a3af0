// From what is asked of each cell to a shade: dark where it is best, as in the landscape.
/** @import { Quantity, Survey } from './request.js' */
import { scaleLinear } from 'd3-scale';
import { headings } from './grid.js';

/** @typedef {ReturnType<typeof createShading>} Shading */

/** What a cell shows; NaN where no robot arrives. @param {Survey} survey @param {Quantity} quantity @param {number | null} heading */
export function readingOf({ runs, tally }, quantity, heading) {
  if (heading === null) {
    const { count, time, cost } = tally;
    const values = { share: count, time, cost }[quantity];
    const unit = quantity === 'share' ? 1 / headings : 1;
    return (/** @type {number} */ cell) => (count[cell] ? values[cell] * unit : Number.NaN);
  }
  const { arrived, finalTime, cost } = runs;
  const values = { share: arrived, time: finalTime, cost }[quantity];
  return (/** @type {number} */ cell) => {
    const run = cell * headings + heading;
    return arrived[run] ? values[run] : Number.NaN;
  };
}

/** Where a mean is that of fewer than half: what arrives from there, if anything does, may well be what had it easy. @param {Survey} survey @param {Quantity} quantity @param {number | null} heading @returns {number[]} Cells. */
function fewIn({ tally: { count } }, quantity, heading) {
  if (quantity === 'share' || heading !== null) return [];
  return [...count.keys()].filter((cell) => count[cell] > 0 && count[cell] < headings / 2);
}

/** The shades of a survey, and what they mean. @param {Survey} survey @param {Quantity} quantity @param {number | null} heading */
export function createShading(survey, quantity, heading) {
  const value = readingOf(survey, quantity, heading);
  const values = Float64Array.from(survey.tally.count, (_, cell) => value(cell));
  const sorted = values.filter(Number.isFinite).sort();
  const most = sorted[sorted.length - 1] ?? 1;
  // A few that need much longer than the others must not darken them all.
  const usual = quantity === 'share' ? 1 : sorted[Math.floor(0.98 * (sorted.length - 1))] || 1;
  const scale = scaleLinear().domain([0, usual]).nice(2);
  const high = scale.domain()[1];
  return {
    values,
    few: fewIn(survey, quantity, heading),
    /** 0 where it is best. @param {number} value */
    part: (value) => (quantity === 'share' ? 1 - value : Math.min(value / high, 1)),
    high,
    ticks:
      quantity === 'share'
        ? [0, 0.5, 1]
        : scale.ticks(2).filter((tick) => tick === high || tick < 0.7 * high),
    /** Some are higher than the scale. */
    open: most > high,
  };
}
