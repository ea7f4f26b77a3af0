// A worker of the pool: an instance of the core of its own, which does one part of a job after another.
import {
  Evolution,
  Simulation,
  errorParts,
  evaluate,
  experiment,
  fares,
  initSync,
  landscape,
  learningRates,
  paper,
  remainingErrors,
  robustness,
  seedRuns,
  simulate,
  simulateAll,
} from '../../pkg/ep_locomotion.js';
import { groupNames } from './checks/check.js';
import { resultsOf } from './checks/checks.js';

/** @typedef {import('../../pkg/ep_locomotion.js').PartialExperiment} PartialExperiment */

/** @typedef {typeof calls} Calls */
/** The first message. @typedef {{ core: WebAssembly.Module }} Outfit */
/** Every other message. @typedef {{ call: keyof Calls, args: unknown[] }} Part */
/** To each part one answer, after any number of progresses; at first the name of a lock that is held as long as the worker lives. @typedef {{ life: string } | { progress: number } | { result: unknown } | { error: string, lost: boolean }} Answer */

const calls = {
  checks,
  errorParts,
  evaluate,
  evolve,
  fares,
  landscape,
  remainingErrors,
  robustness,
  seedRuns,
};

/** Milliseconds from one progress to the next. */
const progressPeriod = 100;

addEventListener('message', (/** @type {MessageEvent<Outfit | Part>} */ { data }) => {
  if ('core' in data) initSync({ module: data.core });
  else alive.then(() => answer(data));
});

addEventListener('messageerror', () => {
  throw new Error('a message to it cannot be read');
});

/** A worker that is ended from elsewhere says nothing, but its lock becomes free. Work waits for it, because none is granted while work goes on. */
const alive = new Promise((resolve) => {
  // Where there are no locks, or they are forbidden, it works all the same.
  if (!globalThis.navigator?.locks) return resolve(null);
  const life = crypto.randomUUID();
  const hold = () => {
    send({ life });
    resolve(null);
    return new Promise(() => {});
  };
  navigator.locks.request(life, hold).catch(resolve);
});

/** @param {Part} part */
function answer({ call, args }) {
  try {
    const result = /** @type {(...args: any[]) => unknown} */ (calls[call])(...args);
    send({ result }, buffersOf(result));
  } catch (error) {
    const { name, message } = error instanceof Error ? error : new Error(String(error));
    // Only bad input, which the core refuses by a plain Error, leaves the instance as it was.
    const lost = name !== 'Error' || message.includes('internal error');
    if (lost) console.error(error);
    send({ error: lost ? 'A worker was lost: an error in the core' : message, lost });
  }
}

/** @param {Answer} message @param {ArrayBuffer[]} [transfer] */
const send = (message, transfer) => postMessage(message, { transfer });

/** The memory of all typed arrays in a result, so that it goes over without a copy. @param {unknown} value @returns {ArrayBuffer[]} */
function buffersOf(value) {
  if (ArrayBuffer.isView(value)) return [/** @type {ArrayBuffer} */ (value.buffer)];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(buffersOf) : [];
}

/** A whole evolution: its champion, and best and median J of each generation from 0. @param {PartialExperiment} experiment @param {number} generations */
function evolve(experiment, generations) {
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
      send({ progress: newest.generation / generations });
    }
    newest = evolution.step();
  }
  const hash = evolution.hash();
  evolution.free();
  return { ...newest.best, history, evaluations: newest.evaluations, hash };
}

/** The checks of the core's own numbers, by group. @param {import('./checks/check.js').Golden} golden */
function checks(golden) {
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
    resultsOf(core, group, golden, (done) => send({ progress: (i + done) / groupNames.length })),
  );
}
