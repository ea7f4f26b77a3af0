// The long jobs: what can be shared is split by index into parts for the pool, and the parts' results are joined in order.
/** @import { Gains, Landscape, Robustness, SeedRun, StartGrid } from '../../pkg/ep_locomotion.js' */
/** @import { Golden } from './checks/check.js' */
/** @import { Jobs } from './jobs.js' */
/** @import { Channel, Pool, Run, RunOptions } from './pool.js' */
import { samplesOfDrive, samplesOfRobot } from './bounds.js';

/** @typedef {import('../../pkg/ep_locomotion.js').Experiment} Experiment */

/** With a channel, the newest request makes the earlier one reject. @typedef {RunOptions & { channel?: Channel }} SurveyOptions */
/** Seeds from `first` on. @typedef {{ first: number, count: number, generations: number }} Seeds */

/** As many samples as a worker drives in 4 to 8 ms: so short that a newer request need not wait. */
const samplesOfPart = 8e5;
/** More would be a burden to the page. So a job without measure has parts without measure, which the core refuses. */
const mostParts = 1024;

/** @param {Pool} pool */
export function createSurveys(pool) {
  /** @type {Run} */
  const run = (job, /** @type {SurveyOptions | undefined} */ options) =>
    (options?.channel ?? pool).run(job, options);
  return {
    /** For the `channel` of options: one for each thing on screen that follows the pointer. */
    channel: pool.channel,
    ...createShared(run, pool.size),
    ...createWhole(run),
  };
}

/** What all workers share. @param {Run} run @param {number} workers */
function createShared(run, workers) {
  return {
    /** J over two gains, row by row. @param {Experiment} experiment @param {Omit<Landscape, 'rows'>} landscape @param {SurveyOptions} [options] */
    async landscape(experiment, landscape, options) {
      const rows = split(landscape.y.count, landscape.x.count * samplesOfRobot(experiment), workers);
      /** @type {[Experiment, Landscape][]} */
      const parts = rows.map((part) => [experiment, { ...landscape, rows: part }]);
      const results = await run({ call: 'landscape', parts }, options);
      return join(Float64Array, results, (costs) => costs);
    },

    /** How one robot fares from every start of a grid. @param {Experiment} experiment @param {Omit<StartGrid, 'part'>} grid @param {SurveyOptions} [options] @returns {Promise<Robustness>} */
    async robustness(experiment, grid, options) {
      const starts = split(grid.x.count * grid.y.count * grid.headings, samplesOfDrive(experiment), workers);
      /** @type {[Experiment, StartGrid][]} */
      const parts = starts.map((part) => [experiment, { ...grid, part }]);
      const results = await run({ call: 'robustness', parts }, options);
      return {
        cost: join(Float64Array, results, (result) => result.cost),
        finalTime: join(Float64Array, results, (result) => result.finalTime),
        arrived: join(Uint8Array, results, (result) => result.arrived),
      };
    },

    /** Evolution with each seed, beside random search; `onRuns` gets those of the first seeds as far as they are. @param {Experiment} experiment @param {Seeds} seeds @param {SurveyOptions & { onRuns?: (runs: SeedRun[]) => void }} [options] */
    async seedRuns(experiment, { first, count, generations }, { onRuns, ...options } = {}) {
      const robots = 2 * experiment.evolution.population * (generations + 1);
      /** @type {[Experiment, import('../../pkg/ep_locomotion.js').SeedRuns][]} */
      const parts = split(count, robots * samplesOfRobot(experiment), workers).map(([from, to]) => [
        experiment,
        { seeds: [first + from, first + to], generations },
      ]);
      const onPart = onRuns && inOrder((/** @type {SeedRun[][]} */ runs) => onRuns(runs.flat()));
      return (await run({ call: 'seedRuns', parts }, { ...options, onPart })).flat();
    },
  };
}

/** What one worker does alone, and many such things at once. @param {Run} run */
function createWhole(run) {
  /** @template {keyof Jobs} K @param {K} call @param {Parameters<Jobs[K]>} args @param {SurveyOptions} [options] */
  const one = async (call, args, options) => (await run({ call, parts: [args] }, options))[0];

  return {
    /** How the search comes down with a few seeds [first, end), drive by drive. @param {Experiment} experiment @param {import('../../pkg/ep_locomotion.js').Trials} trials @param {SurveyOptions} [options] */
    // Not split: who asks does so for few seeds at a time, so that those are kept that were done before a cancel.
    trials: (experiment, trials, options) => one('trials', [experiment, trials], options),

    /** One whole evolution. @param {Experiment} experiment @param {number} generations @param {SurveyOptions & { shown?: number }} [options] */
    evolve: (experiment, generations, { shown, ...options } = {}) =>
      one('evolve', [experiment, generations, shown], options),

    /** Many at once. @param {readonly Experiment[]} experiments @param {number} generations @param {SurveyOptions} [options] */
    evolveAll: (experiments, generations, options) =>
      run({ call: 'evolve', parts: experiments.map((one) => [one, generations]) }, options),

    /** The sizes of the error over time that Theorem 2 bounds, from every start. @param {Experiment} experiment @param {Gains} gains @param {SurveyOptions} [options] */
    // Not split, because the draws of a disturbance go by the number of the start.
    errorParts: (experiment, gains, options) => one('errorParts', [experiment, gains], options),

    /** What remains of them in the last seconds, in each of these experiments. @param {readonly Experiment[]} experiments @param {Gains} gains @param {number} seconds @param {SurveyOptions} [options] */
    remainingErrors: (experiments, gains, seconds, options) =>
      run({ call: 'remainingErrors', parts: experiments.map((one) => [one, gains, seconds]) }, options),

    /** How each robot fares from every start of its experiment. @param {readonly (readonly [Experiment, Gains])[]} robots @param {SurveyOptions} [options] */
    fares: (robots, options) => run({ call: 'fares', parts: robots.map((robot) => [...robot]) }, options),

    /** J of each triple of gains. @param {Experiment} experiment @param {Gains} gains @param {SurveyOptions} [options] */
    // Not split, so that an error counts the gains as they were given.
    evaluate: (experiment, gains, options) => one('evaluate', [experiment, gains], options),

    /** J of one robot after the other, each in an experiment of its own. @param {readonly (readonly [Experiment, Gains])[]} robots @param {SurveyOptions} [options] */
    async costs(robots, options) {
      const costs = await run({ call: 'evaluate', parts: robots.map((robot) => [...robot]) }, options);
      return costs.map(([cost]) => cost);
    },

    /** What a search has come to in a generation: its population, best first, and the statistics. @param {Experiment} experiment @param {number} generation @param {SurveyOptions} [options] */
    generation: (experiment, generation, options) =>
      one('newestGeneration', [experiment, generation], options),

    /** What came of the checks of the core's own numbers: a list for each group. @param {Golden} golden @param {SurveyOptions} [options] */
    // Not split, because every worker more would first have to learn the same code: that takes longer than the checks.
    checks: (golden, options) => one('checks', [golden], options),
  };
}

/**
 * [first, end) of each part, for `count` things of which each drives `samples`.
 * @param {number} count @param {number} samples @param {number} workers
 */
function split(count, samples, workers) {
  const quick = Math.floor(samplesOfPart / samples);
  const shared = Math.floor(count / (2 * workers));
  // What cannot be counted stays in one part, because the core knows best what is wrong with it.
  const each = Math.max(Math.min(quick, shared), Math.ceil(count / mostParts), 1) || count;
  /** @type {[number, number][]} */
  const parts = [];
  let first = 0;
  do {
    parts.push([first, Math.min(first + each, count)]);
    first += each;
  } while (first < count);
  return parts;
}

/** Tells of the results up to the first that is not there yet, whenever there are more of them. @template R @param {(results: R[]) => void} tell */
function inOrder(tell) {
  /** @type {R[]} */
  const results = [];
  let whole = 0;
  return (/** @type {R} */ result, /** @type {number} */ index) => {
    results[index] = result;
    if (index !== whole) return;
    while (whole in results) whole += 1;
    tell(results.slice(0, whole));
  };
}

/**
 * @template R
 * @template {Float64Array | Uint8Array} A
 * @param {new (length: number) => A} TypedArray
 * @param {R[]} results
 * @param {(result: R) => A} arrayOf
 */
function join(TypedArray, results, arrayOf) {
  const arrays = results.map(arrayOf);
  const joined = new TypedArray(arrays.reduce((length, array) => length + array.length, 0));
  let at = 0;
  for (const array of arrays) {
    joined.set(array, at);
    at += array.length;
  }
  return joined;
}
