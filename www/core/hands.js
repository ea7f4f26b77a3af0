// The workers of a pool: each is hired when there is work for it, and dismissed when it is lost.
/** @import { Task } from './pool.js' */
/** @import { Answer } from './worker.js' */

/** What the pool needs of a Worker. @typedef {Pick<Worker, 'addEventListener' | 'postMessage' | 'terminate'>} WorkerLike */

/** A worker, and the parts of one task that it has been given, in their order. @typedef {{ worker: WorkerLike, task: Task | null, indices: number[], progress: number, begun: boolean, silence: ReturnType<typeof setTimeout> }} Hand `begun`: it has said a word. */

/** What a worker says of its parts. @typedef {Exclude<Answer, { life: string | null }>} Said */

/** A worker has the next short part already when it ends one, for a page that draws may be slow to hear of it. */
const shortPartsAhead = 2;

/** A worker says a word when it begins. One that has not after so many milliseconds is replaced, and the next has twice as long. */
const longestSilence = 10_000;

/**
 * @param {() => WorkerLike} spawn @param {number} size How many there may be.
 * @param {(hand: Hand, said: Said) => void} hear @param {(hand: Hand, reason: string) => void} lose Who is lost is still to be dismissed.
 */
export function createHands(spawn, size, hear, lose) {
  /** @type {Set<Hand>} */
  const hands = new Set();
  let silence = longestSilence;

  function hire() {
    const worker = start(spawn);
    /** @type {Hand} */
    const hand = {
      worker,
      task: null,
      indices: [],
      progress: 0,
      begun: false,
      silence: setTimeout(giveUp, silence),
    };
    worker.addEventListener('message', (/** @type {MessageEvent<Answer>} */ { data }) => {
      clearTimeout(hand.silence);
      hand.begun = true;
      if (!('life' in data)) hear(hand, data);
      else if (data.life !== null)
        navigator.locks.request(data.life, () => lose(hand, 'it was ended')).catch(() => {});
    });
    worker.addEventListener('error', (event) => {
      event.preventDefault();
      // Another page in the place of its file is no script.
      if (event.message && !event.message.includes('SyntaxError')) hand.begun = true;
      lose(hand, event.message ?? '');
    });
    worker.addEventListener('messageerror', () => lose(hand, 'its answer cannot be read'));
    hands.add(hand);
    return hand;

    function giveUp() {
      silence *= 2;
      lose(hand, 'it did not begin');
    }
  }

  /** @param {Task} task */
  const busyWith = (task) => [...hands].filter((hand) => hand.task === task);

  return {
    busyWith,

    /** Who takes the next part of a task, if anybody can. @param {Task} task */
    handFor(task) {
      const idle = [...hands].find((hand) => hand.task === null);
      if (idle) return idle;
      if (hands.size < size) return hire();
      const own = task.urgent ? busyWith(task) : [];
      own.sort((a, b) => a.indices.length - b.indices.length);
      return own.find((hand) => hand.indices.length < shortPartsAhead);
    },

    /** Another is hired in its place when there is work. @param {Hand} hand */
    dismiss(hand) {
      clearTimeout(hand.silence);
      hand.worker.terminate();
      hand.task = null;
      hand.indices = [];
      hands.delete(hand);
    },
  };
}

/** @param {() => WorkerLike} spawn */
function start(spawn) {
  try {
    return spawn();
  } catch (cause) {
    throw notStarted(cause instanceof Error ? cause.message : String(cause), cause);
  }
}

/** @param {string} reason @param {unknown} [cause] */
export const notStarted = (reason, cause) =>
  new Error(
    `No worker can be started${because(reason.replace(/\.$/, ''))}. The server that sends this page, or the frame that holds it, may forbid computing in the background (worker-src, sandbox), be out of reach, or lack the file of it, as after a new version of the page; then reload the page, whose address brings back what is on screen. What needs no worker goes on.`,
    { cause },
  );

/** Browsers give none where a file is not there. @param {string} reason */
export const because = (reason) => reason && `: ${reason}`;
