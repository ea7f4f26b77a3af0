// The only module, with its workers, that knows the core: everything else receives plain numbers from here.
import {
  Evolution,
  experiment,
  fields,
  initSync,
  learningRates,
  paper,
  randomSeed,
  Simulation,
  simulateAll,
  stability,
  startsOnCircle,
  version,
} from '../../pkg/ep_locomotion.js';
import { createPool } from './pool.js';
import { createSurveys } from './surveys.js';
import SurveyWorker from './worker.js?worker';

/** @typedef {import('../../pkg/ep_locomotion.js').ErrorParts} ErrorParts */
/** @typedef {import('../../pkg/ep_locomotion.js').Range} Range */
/** @typedef {import('../../pkg/ep_locomotion.js').RemainingErrors} RemainingErrors */
/** @typedef {import('../../pkg/ep_locomotion.js').Robustness} Robustness */
/** @typedef {import('../../pkg/ep_locomotion.js').SeedRun} SeedRun */
/** @typedef {import('../../pkg/ep_locomotion.js').Experiment} Experiment */
/** @typedef {import('../../pkg/ep_locomotion.js').PartialExperiment} PartialExperiment */
/** @typedef {import('../../pkg/ep_locomotion.js').Field} Field */
/** @typedef {import('../../pkg/ep_locomotion.js').Individual} Individual */
/** @typedef {import('../../pkg/ep_locomotion.js').PaperResult} PaperResult */
/** @typedef {import('../../pkg/ep_locomotion.js').Posture} Posture */
/** @typedef {import('../../pkg/ep_locomotion.js').Preset} Preset */
/** @typedef {import('../../pkg/ep_locomotion.js').Run} Run */
/** @typedef {import('../../pkg/ep_locomotion.js').Stability} Stability */
/** @typedef {import('../../pkg/ep_locomotion.js').Cost} Cost */
/** @typedef {import('../../pkg/ep_locomotion.js').GenerationRecord} GenerationRecord */
/** @typedef {import('../../pkg/ep_locomotion.js').Sample} Sample */
/** @typedef {import('../../pkg/ep_locomotion.js').Statistics} Statistics */
/** @typedef {readonly [number, number, number]} Triple kx, ky, kθ */

/** @typedef {{ statistics: Statistics, population: Individual[] }} Generation The newest one; its population is best first. */
/** @typedef {Awaited<ReturnType<typeof createEngine>>} Engine */

/** Loads the core. */
export async function createEngine() {
  const module = await compileCore();
  initSync({ module });
  /** @type {Evolution | null} */
  let evolution = null;

  /** @type {import('./surveys.js').Surveys | null} */
  let surveys = null;

  /** A worker makes no request of its own: it gets the core from here. */
  function spawn() {
    const worker = new SurveyWorker();
    worker.postMessage({ core: module });
    return worker;
  }

  const current = () => {
    if (!evolution) throw new Error('engine: begin an evolution first');
    return evolution;
  };

  /** @param {Evolution} from @returns {Generation} */
  const newest = (from) => ({
    statistics: from.statistics(),
    population: from.population(),
  });

  return {
    fields,
    paper,
    randomSeed,
    version,
    learningRates,
    startsOnCircle,

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
    step: () => current().step(),

    /** The population that a generation left, best first. @param {number} generation */
    population: (generation) => current().population(generation),

    /** All that happened in a generation. @param {number} generation */
    record: (generation) => current().record(generation),

    /** Digits over every number of the history, the same wherever it ran. */
    hash: () => current().hash(),

    /** The hash of an evolution of its own, on this thread. @param {Experiment} from @param {number} generations */
    hashOf(from, generations) {
      const own = new Evolution(from);
      for (let i = 0; i < generations; i++) own.step();
      const hash = own.hash();
      own.free();
      return hash;
    },

    /** One run for each triple of gains, in one call. @param {Experiment} from @param {readonly Triple[]} gains */
    drive: (from, gains) => simulateAll(from, gains.flat()),

    /** All that a robot sees, is told and does, sample by sample. @param {Experiment} from @param {Triple} gains @returns {Sample[]} */
    samples(from, gains) {
      const robot = new Simulation(from, Float64Array.from(gains));
      const samples = [];
      do samples.push(robot.step());
      while (samples[samples.length - 1].outcome === null);
      robot.free();
      return samples;
    },

    /** The Lyapunov function of a run. @param {Experiment} from @param {Triple} gains */
    stability: (from, gains) => stability(from, gains),

    /** Long jobs, which workers do; they are started at the first one. */
    get surveys() {
      surveys ??= createSurveys(createPool({ spawn }));
      return surveys;
    },
  };
}

/** Compiled once, for the page and its workers. */
async function compileCore() {
  const response = await fetch(new URL('../../pkg/ep_locomotion_bg.wasm', import.meta.url));
  if (!response.ok) throw new Error(`the core is missing: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
