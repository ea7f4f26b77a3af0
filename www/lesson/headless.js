// The lesson without a page, under Node: what a link of it sets up, and what runs then.
import { createEngine } from '../core/headless.js';
import { openLink } from '../link/link.js';
import { firstDisturbance } from '../parts/disturbance/request.js';
import { createAnatomy, createChosenDrives, firstGeneration } from '../parts/generation/record.js';
import { firstLandscape } from '../parts/landscape/request.js';
import { firstRobustness } from '../parts/robustness/request.js';
import { firstTraining } from '../parts/training/request.js';
import { createScene, gainsOf } from '../run/state.js';
import { noTally } from './tally.js';

/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {import('./page.js').Live} Live */

/** What a link asks for; it must not have anything wrong. @param {string} link @param {Engine} [engine] */
export function openedBy(link, engine = createEngine()) {
  const { opened, problems } = openLink(link, engine);
  if (problems.length > 0) throw new Error(problems.join(' '));
  return opened;
}

/** What the page knows once a link is opened, its evolution is there, and the robots stand at the start; no part of the page computes. @param {string} link @returns {Live} */
export function liveOf(link) {
  const engine = createEngine();
  const run = openedBy(link, engine);
  const history = [engine.begin(run.experiment).statistics];
  while (history.length <= run.generation) history.push(engine.step());
  const state = stateOf(run, history, engine.population(run.generation));
  const paper = engine.paper();
  const chosenDrives = createChosenDrives(createAnatomy(engine.record));
  const scene = createScene(engine.drive, paper, chosenDrives)(state);
  const [sample] = engine.samples(scene.experiment, scene.gains);
  const gains = gainsOf(state, state.driver, paper);
  return { engine, state, scene, paper, gains, sample, decided: sample };
}

/** As much of the state as there is without a page. @param {ReturnType<typeof openedBy>} run @param {Statistics[]} history @param {Live['state']['population']} population */
function stateOf({ view, ...run }, history, population) {
  /** @type {Partial<Live['state']>} */
  const known = {
    ...run,
    page: 'lab',
    history,
    population,
    progress: { answers: {}, tally: noTally, duel: null },
    anatomy: { ...firstGeneration, ...view.anatomy },
    landscape: { ...firstLandscape, ...view.landscape },
    robustness: { ...firstRobustness, ...view.robustness },
    training: firstTraining,
    disturbance: firstDisturbance,
  };
  return /** @type {Live['state']} */ (known);
}
