// What the core is asked for. What takes little is done at once, on this thread; what takes long a worker does, and as long as
// that is under way, whoever asks gets a Pending thrown. Both ways come to the same bits.
/** @import { Experiment, Generation, GenerationRecord, Individual, PartialExperiment, Preset, Sample, Triple } from './engine.js' */
/** @import { Pool } from './pool.js' */
/** @import { Samples } from './samples.js' */
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
import { createAnswers } from './answers.js';
import { isLongDrive, isLongEvolution, isLongRecord, isLongReplay } from './bounds.js';
import { unpacked } from './history.js';
import { once } from './once.js';
import { driveOn, samplesOf } from './samples.js';
import { fromFirst, withStartsInOne } from './starts.js';
import { createSurveys } from './surveys.js';

/**
 * An evolution here, or, where there is no such object, in a worker.
 * @typedef {{ experiment: Experiment, here: Evolution | null, newest: number, hash: () => string, population: Individual[] }} Run
 */

/** The core is there. @param {{ pool: () => Pool, lone: () => Pool }} workers Which are started when they are needed; `lone` has one, which keeps an evolution. */
export function engineOf({ pool, lone }) {
  const ask = createAnswers();
  const shared = once(pool);
  const surveys = once(() => createSurveys(shared()));
  /** Of each, only the newest question is worth an answer. */
  const evolving = once(() => {
    const own = lone();
    return { steps: own.channel(), replays: own.channel(), records: own.channel() };
  });
  const evolution = createEvolution(ask, evolving);

  return {
    fields,
    wordFields,
    paper,
    randomSeed,
    version,
    learningRates,
    startsOnCircle,

    /** @param {Preset | PartialExperiment} from */
    experiment: (from) => experiment(typeof from === 'string' ? from : withStartsInOne(from)),

    /** What of a preset these fields make, whatever they were copied from. @param {Preset} preset @param {PartialExperiment} changes */
    changed: (preset, changes) => experiment(preset, withStartsInOne(changes)),

    ...evolution,

    /** An evolution beside the run, on this thread: for what takes little. @param {Experiment} from @returns {{ statistics: () => Generation['statistics'], population: () => Individual[], step: () => Generation['statistics'], free: () => void }} */
    apart: (from) => new Evolution(from),

    /** The hash of an evolution of its own, on this thread. @param {Experiment} from @param {number} generations */
    hashOf(from, generations) {
      const own = new Evolution(from);
      for (let i = 0; i < generations; i++) own.step();
      const hash = own.hash();
      own.free();
      return hash;
    },

    /** Throws if the core does not drive with these gains. @param {Experiment} from @param {Triple} gains */
    check(from, gains) {
      new Simulation(fromFirst(from), gains).free();
    },

    /** One run for each triple of gains, in one call. @param {Experiment} from @param {readonly Triple[]} gains */
    drive: (from, gains) =>
      isLongDrive(from, gains.length)
        ? ask(shared().soon, 'simulateAll', fromFirst(from), gains.flat())
        : simulateAll(fromFirst(from), gains.flat()),

    /** All that a robot sees, is told and does, sample by sample. @param {Experiment} from @param {Triple} gains @returns {Samples} */
    samples(from, gains) {
      if (isLongDrive(from)) return samplesOf(ask(shared().soon, 'samples', fromFirst(from), gains));
      /** @type {Sample[]} */
      const samples = [];
      driveOn(new Simulation(fromFirst(from), gains), (sample) => samples.push(sample));
      return /** @type {Samples} */ (samples);
    },

    /** The Lyapunov function of a run. @param {Experiment} from @param {Triple} gains */
    stability: (from, gains) =>
      isLongDrive(from)
        ? ask(shared().soon, 'stability', fromFirst(from), gains)
        : stability(fromFirst(from), gains),

    /** Long jobs, which workers do; they are started at the first one. */
    get surveys() {
      return surveys();
    },
  };
}

/** @param {ReturnType<typeof createAnswers>} ask @param {() => Record<'steps' | 'replays' | 'records', import('./pool.js').Channel>} evolving */
function createEvolution(ask, evolving) {
  /** @type {Run | null} */
  let run = null;

  const current = () => {
    if (!run) throw new Error('engine: begin an evolution first');
    return run;
  };

  /** @param {Run} next @returns {Generation} */
  const take = (next, /** @type {Generation['statistics']} */ statistics) => {
    run?.here?.free();
    run = next;
    return { statistics, population: next.population };
  };

  /** How many generations are computed again for a recorded one. @param {Evolution} here @param {number} generation */
  const againFor = (here, generation) =>
    generation === here.generation ? 0 : generation % here.mostDrivenAgain;

  return {
    /** Starts evolution over; when the core refuses the experiment, the old evolution stays. @param {Experiment} from */
    begin(from) {
      if (isLongEvolution(from)) {
        // What is refused is refused at once.
        experiment(withStartsInOne(from));
        const { statistics, population, hash } = ask(evolving().steps.run, 'newestGeneration', from, 0);
        // The answer may have been given before, and this is another evolution.
        const own = { ...statistics };
        return take({ experiment: from, here: null, newest: 0, hash: () => hash, population }, own);
      }
      const here = new Evolution(withStartsInOne(from));
      const population = here.population();
      const begun = { experiment: from, here, newest: 0, hash: () => here.hash(), population };
      return take(begun, here.statistics());
    },

    /** One generation more. */
    step() {
      const own = current();
      if (own.here) {
        const statistics = own.here.step();
        own.newest += 1;
        return statistics;
      }
      const next = ask(evolving().steps.run, 'newestGeneration', own.experiment, own.newest + 1);
      Object.assign(own, { newest: own.newest + 1, hash: () => next.hash, population: next.population });
      return next.statistics;
    },

    /** The population that a generation left, best first. @param {number} generation */
    population(generation) {
      const { experiment, here, newest, population } = current();
      if (here && !isLongReplay(experiment, againFor(here, generation))) return here.population(generation);
      if (!here && generation === newest) return population;
      return ask(evolving().replays.run, 'population', experiment, generation);
    },

    /** All that happened in a generation. @param {number} generation @param {Experiment} [of] Of the run if nobody says: what is still seen may be of the one before. @returns {GenerationRecord} */
    record(generation, of = current().experiment) {
      const { experiment, here } = current();
      const isHere = here !== null && of === experiment && generation <= here.generation;
      if (isHere && !isLongRecord(experiment, againFor(here, Math.max(0, generation - 1))))
        return here.record(generation);
      return unpacked(ask(evolving().records.run, 'record', of, generation));
    },

    /** Digits over the numbers that decide the history, the same wherever it ran. */
    hash: () => current().hash(),
  };
}
