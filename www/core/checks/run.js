// Runs all checks in a worker; then what a worker and the page itself must have in common.
/** @import { Engine } from '../engine.js' */
/** @import { SurveyOptions } from '../surveys.js' */
/** @import { Golden, Result } from './check.js' */
import { same } from './check.js';

/** Generations that both evolve: so few that the page does not stutter. */
const generations = 20;

/** The results by group. @param {Engine} engine @param {Golden} golden @param {SurveyOptions} options @returns {Promise<Result[][]>} */
export async function allResults(engine, golden, { signal, onProgress }) {
  const { surveys } = engine;
  const experiment = engine.experiment('velocity-limits');
  // Before all others, as what is on screen waits for it.
  const channel = surveys.channel();
  const groups = await surveys.checks(golden, { signal, onProgress, channel });
  const evolved = await surveys.evolve(experiment, generations, { signal, channel });
  const outcome = same(engine.hashOf(experiment, generations), evolved.hash);
  const before = groups.slice(0, -1);
  return [...before, [...(groups.at(-1) ?? []), { name: 'worker', about: [generations], ...outcome }]];
}
