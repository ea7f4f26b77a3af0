// The state of the luck part, and asking the workers for many seeds.
import { messageOf } from '../../words/errors.js';
import { gainsOf } from '../../run/state.js';
import { summaryOf } from './statistics.js';

/** @typedef {import('../../core/engine.js').Engine} Engine */
/** @typedef {import('../../core/engine.js').Experiment} Experiment */
/** @typedef {import('../../core/engine.js').PaperResult} PaperResult */
/** @typedef {import('../../run/state.js').State} State */
/** @typedef {import('../../run/state.js').Store} Store */
/** @typedef {import('../../../pkg/ep_locomotion.js').SeedRun} SeedRun */

/**
 * @typedef {object} SeedSurvey
 * @property {Experiment} experiment Its own seed does not matter.
 * @property {number} first The first seed; the others follow it.
 * @property {number} generations
 * @property {number} drives Of one seed's evolution, and of its random search.
 * @property {SeedRun[]} runs
 * @property {import('./statistics.js').Summary} summary
 * @property {{ gains: import('../../run/state.js').Triple, cost: number }} paper The gains that evolution found in the paper.
 * @property {number} milliseconds
 */

/**
 * @typedef {object} LuckState
 * @property {number} count How many seeds to run next.
 * @property {number} generations For how many generations.
 * @property {boolean} log Costs are shown as the logarithm of their distance to the lowest.
 * @property {number | null} progress From 0 to 1 while seeds run.
 * @property {SeedSurvey | null} result
 * @property {number | null} chosen The index of a run.
 * @property {number | null} pointed The run under the pointer.
 * @property {boolean} cancelled
 * @property {string} message
 */

/** @type {LuckState} */
export const firstLuck = {
  count: 100,
  generations: 200,
  log: false,
  progress: null,
  result: null,
  chosen: null,
  pointed: null,
  cancelled: false,
  message: '',
};

const firstSeed = 1;

/** @param {Experiment} experiment @param {number} generations */
export const drivesOf = ({ evolution, starts }, generations) =>
  evolution.population * (generations + 1) * starts.length;

/** @param {Store} store @param {Partial<LuckState>} patch */
export const update = (store, patch) => store.update({ luck: { ...store.get().luck, ...patch } });

/** Whether two experiments differ in nothing but the seed. @param {Experiment} a @param {Experiment} b */
export function isSameButSeed(a, b) {
  const [one, other] = [a, b].map((experiment) =>
    JSON.stringify({ ...experiment, evolution: { ...experiment.evolution, seed: 0 } }),
  );
  return one === other;
}

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper */
export function createSeedRequests(engine, store, paper) {
  /** @type {AbortController | null} */
  let running = null;

  return {
    async run() {
      running?.abort();
      const own = new AbortController();
      running = own;
      const { experiment, luck } = store.get();
      const { count, generations } = luck;
      const began = performance.now();
      update(store, { progress: 0, cancelled: false, message: '' });
      try {
        const gains = gainsOf(store.get(), 'paper-ep', paper);
        const seeds = { first: firstSeed, count, generations };
        const { signal } = own;
        const onProgress = (/** @type {number} */ progress) => update(store, { progress });
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
          paper: { gains, cost },
          milliseconds: performance.now() - began,
        };
        update(store, { progress: null, result, chosen: null, pointed: null });
      } catch (error) {
        if (running === own)
          update(store, { progress: null, message: own.signal.aborted ? '' : messageOf(error) });
      } finally {
        if (running === own) running = null;
      }
    },

    /** What was there before stays. */
    cancel() {
      running?.abort();
      update(store, { progress: null, cancelled: true });
    },
  };
}
