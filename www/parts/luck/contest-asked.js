// The contest that is set up: whether it is there, and how it comes to be without a page.
/** @import { Engine, Experiment } from '../../core/engine.js' */
/** @import { Contest } from './contest-request.js' */
/** @import { LuckState } from './state.js' */
import { mostRobotsOfCall } from '../../core/bounds.js';
import { isSameButSeed } from '../changes.js';
import { entered } from './contestants.js';

/** @typedef {Pick<LuckState, 'others' | 'seeds' | 'budget'>} Asked */

const firstSeed = 1;
/** As many as drive side by side in the lanes of the core. */
const seedsOfPart = 8;

/** The seeds [from, to) of each part: no more than the core takes at once. @param {Experiment} experiment @param {Pick<Asked, 'seeds' | 'budget'>} asked */
export function partsOf(experiment, { seeds, budget }) {
  const each = Math.max(1, Math.min(seedsOfPart, Math.floor(mostRobotsOfCall(experiment) / budget)));
  return Array.from({ length: Math.ceil(seeds / each) }, (_, i) => {
    const from = firstSeed + i * each;
    return /** @type {[number, number]} */ ([from, Math.min(from + each, firstSeed + seeds)]);
  });
}

/** Whether it has the contestants, seeds and drives that are set up. @param {Contest} contest @param {Asked} asked */
export const isAsked = (contest, { others, seeds, budget }) =>
  contest.seeds === seeds &&
  contest.budget === budget &&
  contest.lines
    .slice(1)
    .map(({ name }) => name)
    .join() === others.join();

/** Whether it is the one that is set up, and whole. @param {Contest | null} contest @param {Experiment} experiment @param {Asked} asked */
export const isWhole = (contest, experiment, asked) =>
  contest !== null &&
  isAsked(contest, asked) &&
  contest.lines.every(({ trials, error }) => trials.length === asked.seeds || error !== '') &&
  isSameButSeed(contest.experiment, experiment);

/** Runs it whole. @param {Engine} engine @param {Experiment} experiment @param {Asked} asked @returns {Promise<Contest>} */
export async function contestOf(engine, experiment, asked) {
  const { others, seeds, budget } = asked;
  const names = [null, ...others];
  const trials = await Promise.all(
    names.map((name) =>
      Promise.all(
        partsOf(experiment, asked).map((part) =>
          engine.surveys.trials(entered(experiment, name), { seeds: part, drives: budget }),
        ),
      ),
    ),
  );
  const lines = names.map((name, i) => ({ name, trials: trials[i].flat(), error: '' }));
  return { experiment, seeds, budget, lines, cancelled: false };
}
