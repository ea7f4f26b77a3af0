// The long jobs, part by part, on whatever thread this is loaded.
/** @import { PartialExperiment } from '../../pkg/ep_locomotion.js' */
import {
  Evolution,
  Simulation,
  errorParts,
  evaluate,
  experiment,
  fares,
  landscape,
  learningRates,
  paper,
  remainingErrors,
  robustness,
  seedRuns,
  simulate,
  simulateAll,
  stability,
  trials,
} from '../../pkg/ep_locomotion.js';
import { groupNames } from './checks/check.js';
import { resultsOf } from './checks/checks.js';
import { createHistory } from './history.js';
import { columnsOf } from './samples.js';

/** @typedef {ReturnType<typeof createJobs>} Jobs */

/** Milliseconds from one progress to the next. */
const progressPeriod = 100;

/** @param {(done: number) => void} tell Gets the part of a job that is done, from 0 to 1. */
export const createJobs = (tell) => ({
  errorParts,
  evaluate,
  fares,
  landscape,
  remainingErrors,
  robustness,
  seedRuns,
  simulateAll,
  stability,
  trials,
  ...createHistory(tell),

  /** All samples of a run. @param {import('../../pkg/ep_locomotion.js').Experiment} experiment @param {import('../../pkg/ep_locomotion.js').Gains} gains */
  samples: (experiment, gains) =>
    columnsOf(new Simulation(experiment, gains), Math.ceil(experiment.horizon / experiment.sampleTime) + 2),

  /** A whole evolution: its champion, best and median J of each generation from 0, and who leads in the one that is asked for. @param {PartialExperiment} experiment @param {number} generations @param {number} [shown] */
  evolve(experiment, generations, shown) {
    if (!Number.isSafeInteger(generations) || generations < 0)
      throw new Error(`generations must be a whole number from 0, but was ${generations}`);
    const evolution = new Evolution(experiment);
    const history = { best: new Float64Array(generations + 1), median: new Float64Array(generations + 1) };
    let newest = evolution.statistics();
    let told = performance.now();
    for (;;) {
      history.best[newest.generation] = newest.best.cost;
      history.median[newest.generation] = newest.median;
      if (newest.generation === generations) break;
      if (performance.now() - told >= progressPeriod) {
        told = performance.now();
        tell(newest.generation / generations);
      }
      newest = evolution.step();
    }
    const hash = evolution.hash();
    const led = shown === undefined ? {} : { leader: evolution.population(shown)[0] };
    evolution.free();
    return { ...newest.best, ...led, history, evaluations: newest.evaluations, hash };
  },

  /** The checks of the core's own numbers, by group. @param {import('./checks/check.js').Golden} golden */
  checks(golden) {
    const core = {
      Evolution,
      Simulation,
      evaluate,
      experiment,
      fares,
      landscape,
      learningRates,
      paper,
      simulate,
      simulateAll,
    };
    return groupNames.map((group, i) =>
      resultsOf(core, group, golden, (done) => tell((i + done) / groupNames.length)),
    );
  },
});
