// What a link of the lesson sets up, under Node: so that a claim of the lesson is held by the core itself.
import { openLink } from '../../www/link.js';
import { Evolution, experiment, paperGains, simulate, simulateAll } from './core.js';

/** @typedef {import('./core.js').Experiment} Experiment */
/** @typedef {import('../../www/engine.js').Engine} Engine */

const engine = /** @type {Engine} */ (
  /** @type {unknown} */ ({
    experiment,
    drive: (/** @type {Experiment} */ from, /** @type {number[][]} */ gains) =>
      simulateAll(from, gains.flat()),
  })
);

/** What a link asks for; it must not have anything wrong. @param {string} link */
export function opened(link) {
  const { opened, problems } = openLink(link, engine);
  if (problems.length > 0) throw new Error(problems.join(' '));
  return opened;
}

/** The drive of the robot in ink. @param {string} link */
export function driven(link) {
  const { experiment: own, driver, handGains, preset, generation, trial } = opened(link);
  const tried = trial.start ? { ...own, starts: [trial.start] } : own;
  return simulate(tried, gainsOf());

  function gainsOf() {
    if (driver === 'hand' && handGains) return handGains;
    if (driver === 'paper-ep') return paperGains(preset, 'ep');
    if (driver === 'paper-arbitrary') return paperGains(preset, 'arbitrary');
    const evolution = new Evolution(own);
    for (let i = 0; i < generation; i++) evolution.step();
    return evolution.statistics().best.gains;
  }
}
