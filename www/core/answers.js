// The answers of workers to single questions, kept as long as they may be asked for again.
/** @import { Jobs } from './jobs.js' */
/** @import { Run } from './pool.js' */
import { Pending } from './pending.js';

/** @typedef {{ value: unknown } | { error: unknown } | { arrival: Promise<unknown>, share: () => number | null }} Answer */

/** More than the page asks for at once. */
const mostAnswers = 24;

export function createAnswers() {
  /** The one asked for last is the last. @type {Map<string, Answer>} */
  const answers = new Map();
  /** The arrival of what was asked last. @type {Map<Run, Promise<unknown>>} */
  const newest = new Map();

  /** @param {string} key @param {Answer} answer */
  function keep(key, answer) {
    answers.delete(key);
    answers.set(key, answer);
    for (const [old, one] of answers) {
      if (answers.size <= mostAnswers) break;
      // What nobody has come back for, too.
      if (old !== key && !('arrival' in one)) answers.delete(old);
    }
  }

  /**
   * The answer, or the core's error; a Pending is thrown as long as there is none.
   * @template {keyof Jobs} K
   * @param {Run} run @param {K} call @param {Parameters<Jobs[K]>} args
   * @returns {ReturnType<Jobs[K]>}
   */
  return function ask(run, call, ...args) {
    const key = JSON.stringify([call, args]);
    let answer = answers.get(key);
    if (!answer) {
      let done = /** @type {number | null} */ (null);
      const arrival = run({ call, parts: [args] }, { onProgress: (part) => (done = part) }).then(
        ([value]) => keep(key, { value }),
        (error) => {
          if (!(error instanceof DOMException && error.name === 'AbortError')) {
            answers.set(key, { error });
            return;
          }
          // What a newer question took the place of may be asked again, once that has its answer: two that are asked in
          // turn would never have one.
          answers.delete(key);
          return newest.get(run);
        },
      );
      newest.set(run, arrival);
      answer = { arrival, share: () => done };
      answers.set(key, answer);
    }
    if ('arrival' in answer) throw new Pending(answer.arrival, answer.share);
    if ('error' in answer) {
      answers.delete(key);
      throw answer.error;
    }
    keep(key, answer);
    return /** @type {ReturnType<Jobs[K]>} */ (answer.value);
  };
}
