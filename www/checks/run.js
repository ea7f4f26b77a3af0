// Runs all checks: the groups in workers, and beside them what a worker and the page itself must have in common.
import { same } from './check.js';

/** @typedef {import('../engine.js').Engine} Engine */
/** @typedef {import('../surveys.js').SurveyOptions} SurveyOptions */
/** @typedef {import('./check.js').Golden} Golden */
/** @typedef {import('./check.js').Result} Result */

/** Generations that both evolve: so few that the page does not stutter. */
const generations = 20;

/** The results by group. @param {Engine} engine @param {Golden} golden @param {SurveyOptions} options @returns {Promise<Result[][]>} */
export async function allResults(engine, golden, { signal, onProgress }) {
  const { surveys } = engine;
  const experiment = engine.experiment('velocity-limits');
  // Two channels, because in one the second job would take the place of the first.
  const [groups, evolved] = await Promise.all([
    surveys.checks(golden, { signal, onProgress, channel: surveys.channel() }),
    surveys.evolve(experiment, generations, { signal, channel: surveys.channel() }),
  ]);
  const outcome = same(engine.hashOf(experiment, generations), evolved.hash);
  const before = groups.slice(0, -1);
  return [...before, [...(groups.at(-1) ?? []), { name: 'worker', about: [generations], ...outcome }]];
}
