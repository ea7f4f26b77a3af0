// Runs long jobs part by part in plain Web Workers. Which worker does a part, and when, never shows in the result.
/** @import { Hand, Said, WorkerLike } from './hands.js' */
/** @import { Jobs } from './jobs.js' */
import { because, createHands, notStarted } from './hands.js';

/**
 * One call for each part, which is the list of its arguments.
 * @template {keyof Jobs} K
 * @typedef {{ call: K, parts: Parameters<Jobs[K]>[] }} Job
 */

/**
 * @typedef {object} RunOptions
 * @property {(done: number) => void} [onProgress] Gets the part that is done, from 0 to 1, which never falls.
 * @property {(result: any, index: number) => void} [onPart] Gets the result of each part as it comes, in whatever order.
 * @property {AbortSignal} [signal]
 */

/**
 * Resolves to the results in the order of the parts. Rejects with the core's own error, with an AbortError once the job
 * is aborted or superseded, or with an error that says what became of the worker.
 * @typedef {<K extends keyof Jobs>(job: Job<K>, options?: RunOptions) => Promise<ReturnType<Jobs[K]>[]>} Run
 */

/** @typedef {{ run: Run }} Channel */
/** `soon`: before all that is not as urgent, such as what is to be seen. @typedef {{ size: number, run: Run, soon: Run, channel: () => Channel }} Pool */

/**
 * A job under way.
 * @typedef {object} Task
 * @property {keyof Jobs} call
 * @property {unknown[][]} parts
 * @property {boolean} urgent Goes before all that is not. Its parts are not terminated: most are short, and one that is not, as the page's own checks, goes on to its end.
 * @property {number} next The first part that no worker has taken.
 * @property {number[]} again Parts that are to be done again, because their worker was lost.
 * @property {Set<number>} lost All parts whose worker was lost once.
 * @property {number} finished
 * @property {boolean} ended Before its time.
 * @property {number} done As it was told last, from 0 to 1.
 * @property {unknown[]} results
 * @property {RunOptions['onProgress']} onProgress
 * @property {RunOptions['onPart']} onPart
 * @property {(results: any[]) => void} resolve
 * @property {(error: unknown) => void} reject
 * @property {() => void} forget Stops to listen for an abort.
 */

/** A worker whose job was aborted has so many milliseconds to answer before it is terminated. */
const grace = 100;

/** @param {string} reason */
const abortError = (reason) => new DOMException(reason, 'AbortError');

/** @param {{ spawn: () => WorkerLike, size?: number }} options `spawn` starts a worker that has the core already. @returns {Pool} */
export function createPool({ spawn, size = Math.min(navigator.hardwareConcurrency || 2, 8) }) {
  const { add, fail } = createQueue(spawn, size);

  /** @template {keyof Jobs} K @param {Job<K>} job @param {RunOptions} options @param {boolean} urgent */
  function begin({ call, parts }, { onProgress, onPart, signal }, urgent) {
    const abort = () => fail(task, abortError('The job was aborted'));
    /** @type {Task} */
    const task = {
      call,
      parts,
      urgent,
      next: 0,
      again: [],
      lost: new Set(),
      finished: 0,
      ended: false,
      done: 0,
      results: [],
      onProgress,
      onPart,
      resolve() {},
      reject() {},
      forget: () => signal?.removeEventListener('abort', abort),
    };
    /** @type {Promise<ReturnType<Jobs[K]>[]>} */
    const results = new Promise((resolve, reject) => Object.assign(task, { resolve, reject }));
    if (signal?.aborted) abort();
    else if (parts.length === 0) task.resolve([]);
    else {
      signal?.addEventListener('abort', abort);
      add(task);
    }
    return { results, supersede: () => fail(task, abortError('A newer request took its place')) };
  }

  return {
    size,

    run: (job, options = {}) => begin(job, options, false).results,

    soon: (job, options = {}) => begin(job, options, true).results,

    /** Runs only the newest of its jobs, before all others of the pool. */
    channel() {
      let supersede = () => {};
      return {
        run(job, options = {}) {
          supersede();
          const begun = begin(job, options, true);
          supersede = begun.supersede;
          return begun.results;
        },
      };
    },
  };
}

/** The tasks under way, and who does which part of them. @param {() => WorkerLike} spawn @param {number} size */
function createQueue(spawn, size) {
  const hands = createHands(spawn, size, hear, lose);
  /** The tasks with parts that no worker has taken, oldest first. @type {Set<Task>} */
  const waiting = new Set();

  /** Gives parts to idle workers while there are both. */
  function assign() {
    for (;;) {
      const tasks = [...waiting];
      const task = tasks.find(({ urgent }) => urgent) ?? tasks[0];
      if (!task) return;
      try {
        const hand = hands.handFor(task);
        if (!hand) return;
        give(hand, task);
        if (task.next === task.parts.length && task.again.length === 0) waiting.delete(task);
      } catch (error) {
        fail(task, error);
      }
    }
  }

  /** @param {Hand} hand @param {Said} said */
  function hear(hand, said) {
    const { task } = hand;
    // What a terminated worker had sent before its end.
    if (!task) return;
    if ('progress' in said) hand.progress = said.progress;
    else {
      const index = /** @type {number} */ (hand.indices.shift());
      hand.progress = 0;
      if (hand.indices.length === 0) hand.task = null;
      if ('error' in said) {
        if (said.lost) hands.dismiss(hand);
        fail(task, new Error(said.error));
      } else keep(task, index, said.result);
      assign();
    }
    report(task, hands.busyWith(task));
  }

  /** Ends a task before its time. @param {Task} task @param {unknown} error */
  function fail(task, error) {
    waiting.delete(task);
    task.ended = true;
    task.forget();
    task.onProgress = undefined;
    task.onPart = undefined;
    task.reject(error);
    const busy = hands.busyWith(task);
    if (task.urgent || busy.length === 0) return;
    setTimeout(() => {
      for (const hand of busy) if (hand.task === task) hands.dismiss(hand);
      assign();
    }, grace);
  }

  /** Another does what a lost worker had to do. What is lost twice takes its task with it, and only that. @param {Hand} hand @param {string} reason */
  function lose(hand, reason) {
    const { task, indices } = hand;
    hands.dismiss(hand);
    if (task && indices.some((index) => task.lost.has(index)))
      fail(task, hand.begun ? new Error(`A worker was lost${because(reason)}`) : notStarted(reason));
    else if (task && !task.ended) {
      for (const index of indices) task.lost.add(index);
      task.again.push(...indices);
      waiting.add(task);
    }
    assign();
  }

  return {
    fail,

    /** @param {Task} task */
    add(task) {
      waiting.add(task);
      assign();
    },
  };
}

/** The next part. Throws when an argument is nothing that can be sent. @param {Hand} hand @param {Task} task */
function give(hand, task) {
  const index = task.again[0] ?? task.next;
  hand.worker.postMessage({ call: task.call, args: task.parts[index] });
  hand.task = task;
  hand.indices.push(index);
  if (index === task.again[0]) task.again.shift();
  else task.next += 1;
}

/** @param {Task} task @param {number} index @param {unknown} result */
function keep(task, index, result) {
  task.results[index] = result;
  task.finished += 1;
  task.onPart?.(result, index);
  if (task.finished < task.parts.length) return;
  task.forget();
  task.resolve(task.results);
}

/** @param {Task} task @param {Hand[]} busy */
function report(task, busy) {
  const done = busy.reduce((sum, hand) => sum + hand.progress, task.finished);
  // What a lost worker had done falls away.
  task.done = Math.max(task.done, done / task.parts.length);
  task.onProgress?.(task.done);
}
