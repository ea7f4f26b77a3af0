// The core under Node, and what the page must show of it.
import { Evolution } from '../../../www/core/headless.js';

export * from '../../../www/core/headless.js';

/** @typedef {import('../../../www/core/headless.js').Experiment} Experiment */
/** @typedef {import('../../../www/core/headless.js').Gains} Gains */

export const glue = new URL('../../../pkg/ep_locomotion.js', import.meta.url);

/** A cost as it is shown. @param {number} cost */
export const shown = (cost) => cost.toFixed(3);

/** What rounds to nothing has no sign. @param {number} gain */
const shownGain = (gain) => gain.toFixed(3).replace(/^-(?=[0.]+$)/, '');

/** Gains as they are shown. @param {Gains} gains */
export const shownGains = (gains) => [...gains].map(shownGain);

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
