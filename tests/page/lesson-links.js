// What a link of the lesson sets up, under Node: so that a claim of the lesson is held by the core itself.
import { openLink } from '../../www/link.js';
import { Evolution, experiment, learningRates, paperGains, seedRuns, simulate, simulateAll } from './core.js';

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

/** The evolution that a link shows, with all its generations. @param {string} link */
export function evolved(link) {
  const { experiment: own, generation } = opened(link);
  const evolution = new Evolution(own);
  for (let i = 0; i < generation; i++) evolution.step();
  return { evolution, generation, experiment: own, costs: costsOf(evolution) };
}

/** The best J of each generation so far. @param {Evolution} evolution */
const costsOf = (evolution) =>
  Array.from({ length: evolution.generation + 1 }, (_, g) => evolution.statistics(g).best.cost);

/** As much of what runs as the answers and values of an evolution need. @param {string} link @returns {import('../../www/lesson/page.js').Live} */
export function liveOf(link) {
  const { evolution, generation, experiment: own } = evolved(link);
  const { view, ...rest } = opened(link);
  const surveys = {
    /** @param {Experiment} from @param {number} generations */
    async evolve(from, generations) {
      const other = new Evolution(from);
      for (let i = 0; i < generations; i++) other.step();
      return other.statistics().best;
    },
    /** @param {Experiment} from @param {{ first: number, count: number, generations: number }} seeds */
    seedRuns: async (from, { first, count, generations }) =>
      seedRuns(from, { seeds: [first, first + count], generations }),
  };
  const history = Array.from({ length: generation + 1 }, (_, g) => evolution.statistics(g));
  const record = (/** @type {number} */ g) => evolution.record(g);
  return /** @type {any} */ ({
    engine: { ...engine, learningRates, record, surveys },
    state: { ...rest, ...view, experiment: own, history, generation },
    scene: { experiment: own },
  });
}

/** A link that a step offers to try. @param {import('../../www/lesson/steps.js').Step} step @param {string} name */
export function tryOf(step, name) {
  for (const block of step.blocks)
    if (block.kind === 'tries') for (const [key, link] of block.tries) if (key === name) return link;
  throw new Error(`${step.name} has no try ${name}`);
}

/** A question that a step asks. @param {import('../../www/lesson/steps.js').Step} step @param {string} name */
export function quizOf(step, name) {
  for (const block of step.blocks) if (block.kind === 'quiz' && block.name === name) return block.quiz;
  throw new Error(`${step.name} has no question ${name}`);
}
