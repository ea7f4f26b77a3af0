// From how many starts gains arrive: those of the map, and those of the training.
import { robustnessSlice } from '../parts/robustness/state.js';
import { gridAround, tally } from '../parts/robustness/grid.js';
import { fine, isFine } from '../parts/robustness/request.js';
import { trainingSlice } from '../parts/training/state.js';
import { evolvedFor, testRobots } from '../parts/training/request.js';
import { createSets } from '../parts/training/sets.js';

/** @import { Engine, Robustness, Triple } from '../core/engine.js' */
/** @import { Result } from '../parts/training/request.js' */
/** @import { SetName } from '../parts/training/sets.js' */
/** @import { State } from '../run/state.js' */
/** @import { Share } from './words/common.js' */

/** The finished maps of this experiment: of who drives, and of who is compared. @param {State} state */
const mapsOf = (state) => {
  const { survey, rival, half } = robustnessSlice.of(state);
  return [survey, rival].flatMap((map) =>
    map && isFine(map) && map.spec.experiment === state.experiment && map.spec.half === half ? [map] : [],
  );
};

/** Whether no map is still being computed. @param {State} state */
export const mapsAreDone = (state) =>
  state.page !== 'robustness' || robustnessSlice.of(state).message !== '' || mapsOf(state).length === 2;

/** From the starts of the map; read from there if it has these gains. @param {Engine} engine @param {State} state @param {Triple} gains */
export async function shareOfStarts(engine, state, gains) {
  const map = mapsOf(state).find(({ spec }) => spec.gains.every((gain, i) => gain === gains[i]));
  if (map) return shareOf(map.runs);
  const { experiment } = state;
  const grid = gridAround(experiment.goal, robustnessSlice.of(state).half, fine);
  return shareOf(await engine.surveys.robustness(experiment, { ...grid, gains }));
}

/** @param {Robustness} runs @returns {Share} */
function shareOf(runs) {
  const starts = runs.arrived.length;
  const { share } = tally(runs);
  return { count: Math.round(share * starts), starts, share };
}

/** Whether Training has what was asked of it. @param {State} state */
export const trainingIsDone = (state) => {
  const { wanted, progress } = trainingSlice.of(state);
  return !wanted && progress === null;
};

/** Evolved on sets of starts as in the training, and tested as there; read from there if it stands there. @param {Engine} engine @param {State} state @param {readonly SetName[]} names @returns {Promise<Result[]>} */
export async function trainedOn(engine, state, names) {
  const evolved = evolvedFor(state);
  if (evolved) return names.map((name) => evolved.results[name]);
  const { experiment } = state;
  const sets = createSets(engine)(experiment);
  const asked = names.map((name) => ({ ...experiment, starts: sets[name] }));
  const champions = await engine.surveys.evolveAll(asked, trainingSlice.of(state).generations);
  const robots = names.map((name, i) => ({ name, gains: champions[i].gains, starts: sets[name] }));
  const results = await testRobots(engine, sets, experiment, robots);
  return names.map((name) => results[name]);
}
