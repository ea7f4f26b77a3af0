// What long runs are drawn from is made ready step by step, so that nothing holds the page.
import { Pending } from '../../core/pending.js';
import { breathe } from '../../kit/loop.js';

/** Samples: of so many a picture is made at once. */
const long = 10_000;

/**
 * Throws a Pending as long as one of the runs is not ready.
 * @template {{ time: Float64Array }} R
 * @param {(run: R) => Iterable<() => unknown>} stepsOf What is made of a run, and kept.
 * @returns {(runs: readonly R[]) => void}
 */
export function createReady(stepsOf) {
  /** Until when it is under way; null: it is ready. @type {WeakMap<R, Promise<void> | null>} */
  const known = new WeakMap();
  const make = async (/** @type {R} */ run) => {
    for (const step of stepsOf(run)) {
      await breathe();
      step();
    }
    known.set(run, null);
  };
  return (runs) => {
    const missing = runs.flatMap((run) => {
      if (run.time.length <= long) return [];
      if (!known.has(run)) known.set(run, make(run));
      return known.get(run) ?? [];
    });
    if (missing.length > 0) throw new Pending(Promise.all(missing));
  };
}
