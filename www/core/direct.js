// What the core does at once, on this thread, for everything but the workers.
import {
  Evolution,
  experiment,
  fields,
  wordFields,
  learningRates,
  paper,
  randomSeed,
  Simulation,
  simulateAll,
  stability,
  startsOnCircle,
  version,
} from '../../pkg/ep_locomotion.js';

/** @typedef {import('./engine.js').Experiment} Experiment */
/** @typedef {import('./engine.js').Generation} Generation */
/** @typedef {import('./engine.js').PartialExperiment} PartialExperiment */
/** @typedef {import('./engine.js').Preset} Preset */
/** @typedef {import('./engine.js').Sample} Sample */
/** @typedef {import('./engine.js').Triple} Triple */
/** @typedef {import('./surveys.js').Surveys} Surveys */

/** The core is there. @param {() => Surveys} createSurveys Asked once, at the first long job. */
export function engineOf(createSurveys) {
  /** @type {Evolution | null} */
  let evolution = null;

  /** @type {Surveys | null} */
  let surveys = null;

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
    wordFields,
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
      surveys ??= createSurveys();
      return surveys;
    },
  };
}
