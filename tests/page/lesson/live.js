// What a question of the lesson is answered from, under Node: the page's own answers on the core itself.
import { gainsOf } from '../../../www/run/drivers.js';
import { withDisturbance } from '../../../www/run/scene.js';
import { places } from '../../../www/parts/parts.js';
import { steps } from '../../../www/lesson/steps.js';
import * as en from '../../../www/words/en/lesson.js';
import * as ko from '../../../www/words/ko/lesson.js';
import {
  Evolution,
  experiment,
  fares,
  landscape,
  learningRates,
  paper,
  robustness,
  seedRuns,
  simulateAll,
  startsOnCircle,
} from '../harness/core.js';
import { opened } from './links.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../harness/core.js').Gains} Gains */
/** @typedef {import('../../../www/lesson/page.js').Live} Live */
/** @typedef {import('../../../www/lesson/quiz.js').Outcome} Outcome */

/** @param {Experiment} from @param {number} generations */
function ranTo(from, generations) {
  const evolution = new Evolution(from);
  for (let i = 0; i < generations; i++) evolution.step();
  return evolution;
}

/** @param {Experiment} from @param {number} generations */
function evolved(from, generations) {
  const evolution = ranTo(from, generations);
  const { best, evaluations } = evolution.statistics();
  const population = evolution.population();
  evolution.free();
  return { ...best, population, evaluations };
}

const engine = {
  experiment,
  learningRates,
  startsOnCircle,
  drive: (/** @type {Experiment} */ from, /** @type {number[][]} */ gains) => simulateAll(from, gains.flat()),
  surveys: {
    landscape: async (/** @type {Experiment} */ from, /** @type {any} */ map) => landscape(from, map),
    robustness: async (/** @type {Experiment} */ from, /** @type {any} */ grid) => robustness(from, grid),
    fares: async (/** @type {[Experiment, Gains][]} */ robots) =>
      robots.map(([from, gains]) => fares(from, gains)),
    evolve: async (/** @type {Experiment} */ from, /** @type {number} */ generations) =>
      ranTo(from, generations).statistics().best,
    /** @param {Experiment} from @param {{ first: number, count: number, generations: number }} seeds */
    seedRuns: async (from, { first, count, generations }) =>
      seedRuns(from, { seeds: [first, first + count], generations }),
    evolveAll: async (/** @type {Experiment[]} */ all, /** @type {number} */ generations) =>
      all.map((one) => evolved(one, generations)),
  },
};

/** The state, and what drives, once a link is opened; as far as answers look at it. @param {string} link @returns {Live} */
export function liveOf(link) {
  const run = opened(link);
  const evolution = ranTo(run.experiment, run.generation);
  const state = /** @type {any} */ ({
    ...run,
    slices: Object.fromEntries(
      places.slices.map(({ name, first }) => [name, { ...first, ...run.parts[name] }]),
    ),
    // No part of the page computes here.
    page: 'lab',
    history: Array.from({ length: run.generation + 1 }, (_, g) => evolution.statistics(g)),
    population: evolution.population(),
  });
  const { start, disturbance } = run.trial;
  const scene = {
    ...run.experiment,
    starts: start ? [start] : run.experiment.starts,
    ...(disturbance && withDisturbance(disturbance)),
  };
  const gains = gainsOf(state, run.driver, paper());
  const [driving] = simulateAll(scene, [...gains]);
  return /** @type {any} */ ({
    engine: { ...engine, record: (/** @type {number} */ g) => evolution.record(g) },
    state,
    gains,
    paper: paper(),
    scene: { experiment: scene, driving },
  });
}

/** What comes out of a question, and what is then said of it. @param {import('../../../www/lesson/steps.js').StepName} step @param {string} name */
export async function answered(step, name) {
  const block = steps
    .find((one) => one.name === step)
    ?.blocks.find((one) => one.kind === 'quiz' && one.name === name);
  if (block?.kind !== 'quiz') throw new Error(`no question ${step}.${name}`);
  const outcome = await block.quiz.answer(liveOf(block.quiz.shows ?? ''));
  const why = [en, ko].map(({ steps: words }) => /** @type {any} */ (words[step]).quizzes[name].why(outcome));
  return { outcome, why };
}

/** The link of a try. @param {import('../../../www/lesson/steps.js').StepName} step @param {string} name */
export function tryOf(step, name) {
  for (const block of steps.find((one) => one.name === step)?.blocks ?? [])
    if (block.kind === 'tries') {
      const found = block.tries.find(([key]) => key === name);
      if (found) return found[1];
    }
  throw new Error(`no try ${step}.${name}`);
}
