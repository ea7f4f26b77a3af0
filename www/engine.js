// The only module that knows the core: everything else receives plain numbers from here.
import init, { Evolution, experiment, paper, randomSeed, simulateAll } from '../pkg/ep_locomotion.js';

/** @typedef {import('../pkg/ep_locomotion.js').Experiment} Experiment */
/** @typedef {import('../pkg/ep_locomotion.js').PartialExperiment} PartialExperiment */
/** @typedef {import('../pkg/ep_locomotion.js').Individual} Individual */
/** @typedef {import('../pkg/ep_locomotion.js').PaperResult} PaperResult */
/** @typedef {import('../pkg/ep_locomotion.js').Posture} Posture */
/** @typedef {import('../pkg/ep_locomotion.js').Preset} Preset */
/** @typedef {import('../pkg/ep_locomotion.js').Run} Run */
/** @typedef {import('../pkg/ep_locomotion.js').Cost} Cost */
/** @typedef {import('../pkg/ep_locomotion.js').Statistics} Statistics */
/** @typedef {readonly [number, number, number]} Triple kx, ky, kθ */

/** @typedef {{ statistics: Statistics, population: Individual[] }} Generation The newest one; its population is best first. */
/** @typedef {Awaited<ReturnType<typeof createEngine>>} Engine */

/** Loads the core. */
export async function createEngine() {
  await init();
  /** @type {Evolution | null} */
  let evolution = null;

  /** @param {Evolution} from @returns {Generation} */
  const newest = (from) => ({
    statistics: from.statistics(),
    population: from.population(),
  });

  return {
    paper,
    randomSeed,

    /** @param {Preset | PartialExperiment} from */
    experiment: (from) => experiment(from),

    /** Starts evolution over; when the core refuses the experiment, the old evolution stays. @param {Experiment} from */
    begin(from) {
      const next = new Evolution(from);
      evolution?.free();
      evolution = next;
      return newest(next);
    },

    /** One generation more. */
    step() {
      if (!evolution) throw new Error('engine: begin an evolution before its first step');
      evolution.step();
      return newest(evolution);
    },

    /** One run for each triple of gains, in one call. @param {Experiment} from @param {readonly Triple[]} gains */
    drive: (from, gains) => simulateAll(from, gains.flat()),
  };
}
