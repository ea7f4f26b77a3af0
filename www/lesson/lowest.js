// The lowest point of a landscape of J that is not on screen, on the points that its map would show.
import { lowestOf } from '../parts/landscape/lowest.js';
import { counts, gainsAt, linearRange } from '../parts/landscape/request.js';

/** @import { Engine, Experiment, Preset } from '../core/engine.js' */
/** @import { GainName } from '../parts/landscape/request.js' */
/** @import { Lowest } from './words/common.js' */

/**
 * @param {Engine} engine
 * @param {{ experiment: Experiment, preset: Preset, x: GainName, y: GainName, third: number }} map With the gain that is on no axis.
 * @returns {Promise<Lowest>}
 */
export async function lowestPoint(engine, { experiment, preset, x, y, third }) {
  const count = counts[counts.length - 1];
  const range = linearRange[preset];
  const [from, to] = range;
  const [across, up] = [x, y].map((gain) => ({ gain, log: false }));
  const spec = { experiment, x: across, y: up, range, third };
  const ends = { from, to, count };
  const asked = { x: { ...across, ...ends }, y: { ...up, ...ends }, gains: gainsAt(spec, [0, 0]) };
  const costs = await engine.surveys.landscape(experiment, asked);
  const none = { gains: asked.gains, cost: Number.POSITIVE_INFINITY };
  return { ...(lowestOf({ spec, count, costs, milliseconds: 0 }) ?? none), most: to };
}
