// What of an experiment is another one now than when something was found for it.
/** @import { Experiment } from '../core/engine.js' */

const names = /** @type {const} */ (['start', 'goal', 'limits', 'seed', 'settings']);

/** @param {Experiment} then @param {Experiment} now */
export function changesOf(then, now) {
  if (then === now) return [];
  const split = (/** @type {Experiment} */ experiment) => {
    const { starts, goal, limits, evolution, ...rest } = experiment;
    const { seed, ...evolving } = evolution;
    return { start: starts, goal, limits, seed, settings: { ...rest, evolving } };
  };
  const [before, after] = [split(then), split(now)];
  return names.filter((name) => JSON.stringify(before[name]) !== JSON.stringify(after[name]));
}

/** Where each seed is tried. @param {Experiment} then @param {Experiment} now */
export const changesButSeed = (then, now) => changesOf(then, now).filter((name) => name !== 'seed');

/** @param {Experiment} a @param {Experiment} b */
export const isSameButSeed = (a, b) => changesButSeed(a, b).length === 0;
