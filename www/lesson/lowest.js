// The lowest point of a landscape of J, on the very points that the map shows.
import { counts, gainsAt, linearRange } from '../parts/landscape/request.js';
import { gainNames } from '../parts/landscape/state.js';

/** @import { Engine, Experiment, Preset, Triple } from '../core/engine.js' */
/** @import { GainName } from '../parts/landscape/request.js' */
/** @import { Lowest } from './words/common.js' */

/**
 * @param {Engine} engine
 * @param {{ experiment: Experiment, preset: Preset, x: GainName, y: GainName, gains: Triple }} map The gain that is on no axis is that of `gains`.
 * @returns {Promise<Lowest>}
 */
export async function lowestPoint(engine, { experiment, preset, x, y, gains }) {
  const count = counts[counts.length - 1];
  const [from, to] = linearRange[preset];
  const axis = (/** @type {GainName} */ gain) => ({ gain, log: false, from, to, count });
  const costs = await engine.surveys.landscape(experiment, { x: axis(x), y: axis(y), gains });
  const least = costs.reduce((best, cost, i) => (cost < costs[best] ? i : best), 0);
  const value = (/** @type {number} */ index) => from + ((to - from) * index) / (count - 1);
  const third = gains[gainNames.findIndex((name) => name !== x && name !== y)];
  const lowest = gainsAt({ x: axis(x), y: axis(y), third }, [
    value(least % count),
    value(Math.floor(least / count)),
  ]);
  return { gains: lowest, cost: costs[least], most: to };
}
