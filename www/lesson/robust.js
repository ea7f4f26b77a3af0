// From how many starts gains arrive: those of the map, and those of the training.
import { gridAround, tally } from '../robustness/grid.js';
import { fine } from '../robustness/request.js';
import { testRobots } from '../training/request.js';
import { createSets } from '../training/sets.js';

/** @typedef {import('../engine.js').Engine} Engine */
/** @typedef {import('../state.js').State} State */
/** @typedef {import('../state.js').Triple} Triple */
/** @typedef {import('../training/request.js').Result} Result */
/** @typedef {import('../training/sets.js').SetName} SetName */
/** @typedef {{ count: number, starts: number, share: number }} Share How many of so many starts arrive. */

/** What was driven already: more than one question asks for it. @type {Map<string, Promise<Share>>} */
const known = new Map();

/** From the very starts of the map. @param {Engine} engine @param {State} state @param {Triple} gains */
export function shareOfStarts(engine, { experiment, robustness }, gains) {
  const { half } = robustness;
  const key = JSON.stringify([experiment, half, gains]);
  const share = known.get(key) ?? drive();
  known.set(key, share);
  share.catch(() => known.delete(key));
  return share;

  async function drive() {
    const grid = gridAround(experiment.goal, half, fine);
    const runs = await engine.surveys.robustness(experiment, { ...grid, gains });
    const starts = runs.arrived.length;
    const { share } = tally(runs);
    return { count: Math.round(share * starts), starts, share };
  }
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
