// The task of the duel, and what evolution makes of it.
import { yardOf } from '../../../www/lesson/duel/yard.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { Evolution } from '../harness/core.js';
import { opened } from './links.js';
import { liveOf } from './live.js';

const step = stepOf('duel');

export const { engine } = liveOf('lab');
export const yard = yardOf(engine);
export const contest = yard.experimentOf(opened(step.link).experiment);

/** The best of an evolution with a seed. @param {number} seed @param {number} generation */
export function evolvedBest(seed, generation) {
  const evolution = new Evolution({ ...contest, evolution: { ...contest.evolution, seed } });
  for (let i = 0; i < generation; i++) evolution.step();
  const { cost, gains } = evolution.statistics().best;
  evolution.free();
  return { cost, gains: /** @type {[number, number, number]} */ ([...gains]) };
}
