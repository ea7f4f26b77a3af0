// The state of the luck part, and asking the workers for many seeds.
/** @import { Engine, Experiment, PaperResult, SeedRun } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
import { luckSlice } from './state.js';
import { methods } from '../../core/methods.js';
import { gainsOf } from '../../run/drivers.js';
import { rememberEach } from '../../kit/memo.js';
import { hidesPaper } from '../../run/exercise.js';
import { createAttempts } from '../attempt.js';
import { summaryOf } from './statistics.js';

/**
 * @typedef {object} SeedSurvey
 * @property {Experiment} experiment Its own seed does not matter.
 * @property {number} first The first seed; the others follow it.
 * @property {number} generations
 * @property {number | null} drives Of one seed's search, and of random search beside it; null where each seed has a number of its own.
 * @property {number} count How many seeds were asked for.
 * @property {SeedRun[]} runs
 * @property {import('./statistics.js').Summary} summary
 * @property {{ gains: import('../../core/engine.js').Triple, cost: number }} paper The gains that evolution found in the paper.
 * @property {number} milliseconds
 */

const firstSeed = 1;

/** Of a search with one seed; null where it is another number with each. @param {Experiment} experiment @param {number} generations */
export function drivesOf({ evolution, starts }, generations) {
  const { trials: own } = methods[evolution.method];
  const trials = own === 'population' ? evolution.population : own;
  return trials && trials * (generations + 1) * starts.length;
}

const withoutPaper = rememberEach((/** @type {SeedSurvey} */ survey) => ({
  ...survey,
  paper: { ...survey.paper, cost: Number.NaN },
}));

/** What may be shown of the seeds that have run, else of the result: where the paper is hidden, not what its gains cost. @param {Pick<State, 'slices' | 'exercise' | 'maker'>} state */
export function surveyOf(state) {
  const { soFar, result } = luckSlice.of(state);
  const survey = soFar ?? result;
  return survey && hidesPaper(state) ? withoutPaper(survey) : survey;
}

/** While seeds run the picture grows so often: to sum up hundreds of runs takes a while. */
const sights = 50;

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper */
export function createSeedRequests(engine, store, paper) {
  const { now: luck, update } = luckSlice.at(store);
  const { begin, cancel } = createAttempts(update);

  /** @param {Pick<SeedSurvey, 'experiment' | 'count' | 'generations'>} asked @param {{ signal: AbortSignal, onProgress: (share: number) => void }} options */
  async function surveyFor({ experiment, count, generations }, options) {
    const began = performance.now();
    const { signal } = options;
    const gains = gainsOf(store.get(), 'paper-ep', paper);
    /** @param {SeedRun[]} runs @param {number} cost @returns {SeedSurvey} */
    const surveyed = (runs, cost) => ({
      experiment,
      first: firstSeed,
      count,
      generations,
      drives: drivesOf(experiment, generations),
      runs,
      summary: summaryOf(runs),
      // No number where an exercise hides it.
      paper: { gains, cost: hidesPaper(store.get()) ? Number.NaN : cost },
      milliseconds: performance.now() - began,
    });
    let cost = Number.NaN;
    let next = 1;
    const onRuns = (/** @type {SeedRun[]} */ runs) => {
      if (runs.length < next || runs.length === count) return;
      next = runs.length + count / sights;
      update({ soFar: surveyed(runs, cost) });
    };
    // What is asked for first is known long before all seeds have run.
    const [, runs] = await Promise.all([
      engine.surveys.evaluate(experiment, gains, { signal }).then((costs) => {
        [cost] = costs;
      }),
      engine.surveys.seedRuns(experiment, { first: firstSeed, count, generations }, { ...options, onRuns }),
    ]);
    return surveyed(runs, cost);
  }

  return {
    async run() {
      const { count, generations } = luck();
      const asked = { experiment: store.get().experiment, count, generations };
      update({ asked });
      await begin(async (options) => ({
        result: await surveyFor(asked, options),
        chosen: null,
        pointed: null,
      }));
      // However it has ended.
      update({ soFar: null });
    },

    /** Runs them where they were under way when the page was left for another language. */
    follow() {
      if (!luck().seedsWanted) return;
      update({ seedsWanted: false });
      this.run();
    },

    cancel,
  };
}
