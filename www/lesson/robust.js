// From how many starts gains arrive: those of the map, and those of the training.
import { gridAround, tally } from '../parts/robustness/grid.js';
import { fine, isFine } from '../parts/robustness/request.js';
import { testRobots } from '../parts/training/request.js';
import { createSets } from '../parts/training/sets.js';

/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../run/state.js').State} State */
/** @typedef {import('../run/state.js').Triple} Triple */
/** @typedef {import('../parts/training/request.js').Result} Result */
/** @typedef {import('../parts/training/sets.js').SetName} SetName */
/** @typedef {{ count: number, starts: number, share: number }} Share How many of so many starts arrive. */

/** The finished maps of this experiment: of who drives, and of who is compared. @param {State} state */
const mapsOf = ({ experiment, robustness: { survey, rival, half } }) =>
  [survey, rival].flatMap((map) =>
    map && isFine(map) && map.spec.experiment === experiment && map.spec.half === half ? [map] : [],
  );

/** Whether no map is still being computed. @param {State} state */
export const mapsAreDone = (state) =>
  state.page !== 'robustness' || state.robustness.message !== '' || mapsOf(state).length === 2;

/** From the starts of the map; read from there if it has these gains. @param {Engine} engine @param {State} state @param {Triple} gains */
export async function shareOfStarts(engine, state, gains) {
  const map = mapsOf(state).find(({ spec }) => spec.gains.every((gain, i) => gain === gains[i]));
  if (map) return shareOf(map.runs);
  const { experiment, robustness } = state;
  const grid = gridAround(experiment.goal, robustness.half, fine);
  return shareOf(await engine.surveys.robustness(experiment, { ...grid, gains }));
}

/** @param {import('../../pkg/ep_locomotion.js').Robustness} runs @returns {Share} */
function shareOf(runs) {
  const starts = runs.arrived.length;
  const { share } = tally(runs);
  return { count: Math.round(share * starts), starts, share };
}

/** Evolved on sets of starts as in the training, and tested as there. @param {Engine} engine @param {State} state @param {readonly SetName[]} names @returns {Promise<Result[]>} */
export async function trainedOn(engine, { experiment, training }, names) {
  const sets = createSets(engine)(experiment);
  const asked = names.map((name) => ({ ...experiment, starts: sets[name] }));
  const champions = await engine.surveys.evolveAll(asked, training.generations);
  const robots = names.map((name, i) => ({ name, gains: champions[i].gains, starts: sets[name] }));
  const results = await testRobots(engine, sets, experiment, robots);
  return names.map((name) => results[name]);
}
