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

/** What may be shown of the result: where the paper is hidden, not what its gains cost. @param {Pick<State, 'slices' | 'exercise' | 'maker'>} state */
export function surveyOf(state) {
  const { result } = luckSlice.of(state);
  return result && hidesPaper(state) ? withoutPaper(result) : result;
}

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper */
export function createSeedRequests(engine, store, paper) {
  const { now: luck, update } = luckSlice.at(store);
  const { begin, cancel } = createAttempts(update);

  return {
    run: () =>
      begin(async ({ signal, onProgress }) => {
        const { experiment } = store.get();
        const { count, generations } = luck();
        const began = performance.now();
        const gains = gainsOf(store.get(), 'paper-ep', paper);
        const seeds = { first: firstSeed, count, generations };
        const [runs, [cost]] = await Promise.all([
          engine.surveys.seedRuns(experiment, seeds, { signal, onProgress }),
          engine.surveys.evaluate(experiment, gains, { signal }),
        ]);
        const result = {
          experiment,
          first: firstSeed,
          generations,
          drives: drivesOf(experiment, generations),
          runs,
          summary: summaryOf(runs),
          // No number where an exercise hides it.
          paper: { gains, cost: hidesPaper(store.get()) ? Number.NaN : cost },
          milliseconds: performance.now() - began,
        };
        return { result, chosen: null, pointed: null };
      }),

    /** Runs them where they were under way when the page was left for another language. */
    follow() {
      if (!luck().seedsWanted) return;
      update({ seedsWanted: false });
      this.run();
    },

    cancel,
  };
}
