// The lowest point of a landscape of J that is not on screen, on the points that its map would show.
import { lowestOf } from '../parts/landscape/lowest.js';
import { counts, gainsAt, linearRange } from '../parts/landscape/request.js';

/** @import { Engine, Experiment, Preset } from '../core/engine.js' */
/** @import { GainName, Landscape, Spec } from '../parts/landscape/request.js' */
/** @import { Lowest } from './words/common.js' */

/** With the gain that is on no axis. @typedef {{ experiment: Experiment, preset: Preset, x: GainName, y: GainName, third: number }} Asked */

/** What its map would be made from. @param {Asked} asked @returns {Spec} */
export function specOf({ experiment, preset, x, y, third }) {
  const [across, up] = [x, y].map((gain) => ({ gain, log: false }));
  return { experiment, x: across, y: up, range: linearRange[preset], third };
}

/** @param {Engine} engine @param {Spec} spec @returns {Promise<Landscape>} */
export async function mapOf(engine, spec) {
  const count = counts[counts.length - 1];
  const [from, to] = spec.range;
  const ends = { from, to, count };
  const asked = { x: { ...spec.x, ...ends }, y: { ...spec.y, ...ends }, gains: gainsAt(spec, [0, 0]) };
  const costs = await engine.surveys.landscape(spec.experiment, asked);
  return { spec, count, costs, milliseconds: 0 };
}

/** @param {Engine} engine @param {Asked} asked @returns {Promise<Lowest>} */
export async function lowestPoint(engine, asked) {
  const spec = specOf(asked);
  const none = { gains: gainsAt(spec, [0, 0]), cost: Number.POSITIVE_INFINITY };
  return { ...(lowestOf(await mapOf(engine, spec)) ?? none), most: spec.range[1] };
}
