// What a link of the lesson sets up, under Node: so that a claim of the lesson is held by the core itself.
import { openedBy } from '../../../www/lesson/headless.js';
import { createEngine, Evolution, paperGains, simulate } from '../harness/core.js';

/** @typedef {import('../../../www/lesson/steps.js').Step} Step */

/** The page's engine. */
export const engine = createEngine();
/** @param {Parameters<typeof engine.samples>} given */
export const samples = (...given) => engine.samples(...given).map((one) => one);

/** The link of a try or a question. @param {Step} step @param {string} name */
export function linkOf({ blocks }, name) {
  for (const block of blocks) {
    const found = block.kind === 'tries' && block.tries.find(([key]) => key === name);
    if (found) return found[1];
    if (block.kind === 'quiz' && block.name === name && block.quiz.shows) return block.quiz.shows;
  }
  throw new Error(`no ${name}`);
}

/** What comes out of a question. @param {Step} step @param {string} name @param {Partial<import('../../../www/lesson/page.js').Live>} live */
export async function answerOf({ blocks }, name, live) {
  for (const block of blocks)
    if (block.kind === 'quiz' && block.name === name) return block.quiz.answer(/** @type {any} */ (live));
  throw new Error(`no question ${name}`);
}

/** What a link asks for; it must not have anything wrong. @param {string} link */
export const opened = (link) => openedBy(link, engine);

/** What a link says of a part of the page. @template {object} S @param {string} link @param {import('../../../www/run/store.js').Slice<S>} slice @returns {S} */
export const shownIn = (link, slice) =>
  /** @type {S} */ ({ ...slice.first, ...opened(link).parts[slice.name] });

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
