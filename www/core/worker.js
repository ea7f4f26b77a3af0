// A worker of the pool: an instance of the core of its own, which does one part of a job after another.
/** @import { Jobs } from './jobs.js' */
import { initSync } from '../../pkg/ep_locomotion.js';
import { createJobs } from './jobs.js';

/** The first message. @typedef {{ core: WebAssembly.Module }} Outfit */
/** Every other message. @typedef {{ call: keyof Jobs, args: unknown[] }} Part */
/** To each part one answer, after any number of progresses; at first, that it has begun, and the name of a lock that is held as long as the worker lives, if it has one. @typedef {{ life: string | null } | { progress: number } | { result: unknown } | { error: string, lost: boolean }} Answer */

/** @param {Answer} message @param {ArrayBuffer[]} [transfer] */
const send = (message, transfer) => postMessage(message, { transfer });

const jobs = createJobs((progress) => send({ progress }));

addEventListener('message', (/** @type {MessageEvent<Outfit | Part>} */ { data }) => {
  if ('core' in data) initSync({ module: data.core });
  else alive.then(() => answer(data));
});

addEventListener('messageerror', () => {
  throw new Error('a message to it cannot be read');
});

/** In milliseconds. A lock of which nobody else knows the name is granted at once, if at all. */
const longestLock = 1000;

/** A worker that is ended from elsewhere says nothing, but its lock becomes free. Work waits for it, because none is granted while work goes on. */
const alive = new Promise((resolve) => {
  // Where there are no locks, or they are forbidden, or none is granted, it works all the same.
  const without = () => {
    send({ life: null });
    resolve(null);
  };
  if (!globalThis.navigator?.locks) return without();
  const life = crypto.randomUUID();
  const late = setTimeout(without, longestLock);
  const hold = () => {
    clearTimeout(late);
    send({ life });
    resolve(null);
    return new Promise(() => {});
  };
  navigator.locks.request(life, hold).catch(without);
});

/** @param {Part} part */
function answer({ call, args }) {
  try {
    const result = /** @type {(...args: any[]) => unknown} */ (jobs[call])(...args);
    send({ result }, buffersOf(result));
  } catch (error) {
    const { name, message } = error instanceof Error ? error : new Error(String(error));
    // Only bad input, which the core refuses by a plain Error, leaves the instance as it was.
    const lost = name !== 'Error' || message.includes('internal error');
    if (lost) console.error(error);
    send({ error: lost ? 'A worker was lost: an error in the core' : message, lost });
  }
}

/** The memory of all typed arrays in a result, so that it goes over without a copy. @param {unknown} value @returns {ArrayBuffer[]} */
function buffersOf(value) {
  if (ArrayBuffer.isView(value)) return [/** @type {ArrayBuffer} */ (value.buffer)];
  return value !== null && typeof value === 'object' ? Object.values(value).flatMap(buffersOf) : [];
}
