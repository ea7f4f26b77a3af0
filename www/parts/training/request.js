// Asking the workers: to evolve gains on each set of starts, and to drive all gains from starts that no evolution sees.
/** @import { Engine, Experiment, PaperResult, Posture, Triple } from '../../core/engine.js' */
/** @import { SurveyOptions } from '../../core/surveys.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { SetName } from './sets.js' */
import { trainingSlice } from './state.js';
import { createRefining } from '../../core/refine.js';
import { once, remember } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';
import { messageAround } from '../around.js';
import { createAttempts } from '../attempt.js';
import { changesOf } from '../changes.js';
import { createSets, setNames, testOn } from './sets.js';
import { evolveSeeds } from './spread.js';

/** @typedef {SetName | 'paper-ep' | 'paper-arbitrary' | 'hand'} RowName */
/** How gains fare from a set of starts; J is the mean over all of them. @typedef {{ starts: Posture[], arrived: Uint8Array, count: number, cost: number }} Fares */
/** @typedef {{ gains: Triple, training: Fares, unseen: Fares, own: number }} Result `own` is J from the experiment's own start. */
/** @typedef {{ name: RowName, gains: Triple, starts: Posture[] }} Robot */
/** @typedef {{ experiment: Experiment, generations: number, drives: number, milliseconds: number, results: Record<SetName, Result> }} Evolved */
/** @typedef {{ experiment: Experiment, robots: Robot[] }} Spec */

/** The gains by hand that are not those of an evolved row, of now or of before. @param {Pick<State, 'handGains' | 'found' | 'slices'>} state */
export function handOf(state) {
  const { evolved, byHand } = trainingSlice.of(state);
  // A link may bring such gains, before anything is evolved here.
  return evolved && state.found === 'training' ? byHand : state.handGains;
}

/**
 * How robots fare from their own starts, from those that no evolution sees, and from the experiment's own.
 * @param {Engine} engine @param {import('./sets.js').Sets} sets @param {Experiment} experiment @param {Robot[]} robots @param {SurveyOptions} [options]
 * @returns {Promise<Record<string, Result>>}
 */
export async function testRobots(engine, { one, unseen }, experiment, robots, options) {
  const drives = robots.flatMap(({ gains, starts }) =>
    [starts, unseen, one].map((from) => /** @type {const} */ ([testOn(experiment, from), gains])),
  );
  const all = await engine.surveys.fares(drives, options);
  const fares = all.map(({ arrived, cost }, i) => ({
    starts: drives[i][0].starts,
    arrived,
    count: arrived.reduce((sum, one) => sum + one, 0),
    cost: cost.reduce((sum, one) => sum + one, 0) / cost.length,
  }));
  return Object.fromEntries(
    robots.map(({ name, gains }, i) => {
      const [training, apart, own] = fares.slice(3 * i, 3 * i + 3);
      return [name, { gains, training, unseen: apart, own: own.cost }];
    }),
  );
}

/** What a state asks for; the same object while nothing that matters has changed. */
const specOf = remember(
  /** @param {Experiment} experiment @param {Triple} ep @param {Triple} arbitrary @param {Triple | null} hand @returns {Spec} */
  (experiment, ep, arbitrary, hand) => {
    const { starts } = experiment;
    const robot = (/** @type {RowName} */ name, /** @type {Triple} */ gains) => ({ name, gains, starts });
    return {
      experiment,
      robots: [
        robot('paper-ep', ep),
        robot('paper-arbitrary', arbitrary),
        ...(hand ? [robot('hand', hand)] : []),
      ],
    };
  },
);

/**
 * On each set of starts, side by side, and then tested.
 * @param {Engine} engine @param {import('./sets.js').Sets} sets @param {Experiment} experiment @param {number} generations
 * @param {{ signal: AbortSignal, onProgress: (share: number) => void }} options @returns {Promise<Evolved>}
 */
async function evolveAll(engine, sets, experiment, generations, { signal, onProgress }) {
  const began = performance.now();
  const total = setNames.reduce((sum, name) => sum + sets[name].length, 0);
  const done = setNames.map(() => 0);
  const champions = await Promise.all(
    setNames.map((name, i) =>
      engine.surveys.evolve({ ...experiment, starts: sets[name] }, generations, {
        signal,
        onProgress(part) {
          // Work goes by the number of starts.
          done[i] = (part * sets[name].length) / total;
          onProgress(done.reduce((sum, one) => sum + one, 0));
        },
      }),
    ),
  );
  const robots = setNames.map((name, i) => ({ name, gains: champions[i].gains, starts: sets[name] }));
  const results = /** @type {Record<SetName, Result>} */ (
    await testRobots(engine, sets, experiment, robots, { signal })
  );
  return {
    experiment,
    generations,
    drives: champions.reduce((sum, { evaluations }) => sum + evaluations, 0),
    milliseconds: performance.now() - began,
    results,
  };
}

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper */
export function createTraining(engine, store, paper) {
  const setsOf = createSets(engine);
  const { now, update } = trainingSlice.at(store);
  const attempts = createAttempts(update);
  /** @param {import('./state.js').Work} begun @param {Parameters<typeof attempts.begin>[0]} work */
  const begin = (begun, work) => {
    given.retry();
    update({ begun });
    return attempts.begin(work);
  };
  const channel = once(() => engine.surveys.channel());

  const given = createRefining({
    counts: [1],
    compute: async (/** @type {Spec} */ spec) => {
      const { experiment, robots } = spec;
      const options = { channel: channel() };
      return { spec, results: await testRobots(engine, setsOf(experiment), experiment, robots, options) };
    },
    onResult: (result) => update({ given: result, message: '' }),
    onFailure: (error) => update({ message: messageAround(error) }),
  });

  return {
    setsOf,

    retry: given.retry,

    /** @param {State} state */
    follow(state) {
      const [ep, arbitrary] = /** @type {const} */ (['paper-ep', 'paper-arbitrary']).map((driver) =>
        gainsOf(state, driver, paper),
      );
      given.follow(specOf(state.experiment, ep, arbitrary, handOf(state)), state.dragging);
    },

    /** On each set of starts, with the experiment's own seed and settings. */
    evolve: () =>
      begin('evolved', async (options) => {
        const { experiment } = store.get();
        const { generations } = now();
        const evolved = await evolveAll(engine, setsOf(experiment), experiment, generations, options);
        return { evolved, spread: null, byHand: handOf(store.get()) };
      }),

    /** What was evolved, with other seeds. */
    spread: () =>
      begin('spread', async (options) => {
        const { evolved } = now();
        return evolved
          ? { spread: await evolveSeeds(engine, setsOf(evolved.experiment), evolved, options) }
          : {};
      }),

    cancel: attempts.cancel,
  };
}

/** The row that arrives from the most unseen starts; of those that arrive from as many, that of the lowest mean J. @param {Evolved['results']} results */
export const furthestOf = (results) =>
  setNames.reduce((best, name) => {
    const [one, other] = [results[best].unseen, results[name].unseen];
    return other.count > one.count || (other.count === one.count && other.cost < one.cost) ? name : best;
  });

/** What has been evolved, unless that was for something else. @param {State} state @returns {Evolved | null} */
export function evolvedFor(state) {
  const { evolved, generations } = trainingSlice.of(state);
  const isSame =
    evolved?.generations === generations && changesOf(evolved.experiment, state.experiment).length === 0;
  return isSame ? evolved : null;
}
