// The core under Node: what the page has to show is computed by the very module that the page was built with.
import { readFile } from 'node:fs/promises';
import init, { Evolution, paper } from '../../../pkg/ep_locomotion.js';

export * from '../../../pkg/ep_locomotion.js';

/** @typedef {import('../../../pkg/ep_locomotion.js').Experiment} Experiment */
/** @typedef {import('../../../pkg/ep_locomotion.js').Gains} Gains */
/** @typedef {import('../../../pkg/ep_locomotion.js').Preset} Preset */

export const wasm = new URL('../../../pkg/ep_locomotion_bg.wasm', import.meta.url);
export const glue = new URL('../../../pkg/ep_locomotion.js', import.meta.url);
/** Of the one instance of the core. */
export const { memory } = await init({ module_or_path: await readFile(wasm) });

/** A cost as it is shown. @param {number} cost */
export const shown = (cost) => cost.toFixed(3);

/** Gains as they are shown. @param {Gains} gains */
export const shownGains = (gains) => [...gains].map((gain) => gain.toFixed(3));

/** @param {Preset} preset @param {'ep' | 'arbitrary'} method */
export function paperGains(preset, method) {
  const row = paper().find((one) => one.preset === preset && one.method === method);
  if (!row) throw new Error(`the core has no ${method} gains for ${preset}`);
  return row.gains;
}

/** Some generations of an evolution: what is shown of the newest one, its best gains in full, and the hash. @param {Experiment} from @param {number} [generations] */
export function evolve(from, generations = 0) {
  const evolution = new Evolution(from);
  for (let i = 0; i < generations; i++) evolution.step();
  const { best, median } = evolution.statistics();
  return {
    shown: { cost: shown(best.cost), gains: shownGains(best.gains) },
    median: shown(median),
    gains: best.gains,
    hash: evolution.hash(),
  };
}

/** The statistics of generations 0 to `count`, as they come from a frame. @param {Experiment} from @param {number} count @returns {import('../../../www/core/engine.js').Statistics[]} */
export function historyOf(from, count) {
  const evolution = new Evolution(from);
  const history = [evolution.statistics()];
  while (history.length <= count) history.push(evolution.step());
  return JSON.parse(JSON.stringify(history));
}
