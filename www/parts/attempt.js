// Long work that can be cancelled, and what the slice of a part says of it.
import { messageOf } from '../words/errors.js';

/**
 * @typedef {object} Attempted
 * @property {number | null} progress From 0 to 1; null: nothing is under way.
 * @property {boolean} cancelled
 * @property {string} message
 */

/** @template {Attempted} S @param {(patch: Partial<S>) => void} update Of the slice. */
export function createAttempts(update) {
  /** @type {AbortController | null} */
  let running = null;
  const say = (/** @type {Partial<Attempted>} */ patch) => update(/** @type {Partial<S>} */ (patch));

  return {
    /** What is under way is given up for it. Whether it came to its end. @param {(options: { signal: AbortSignal, onProgress: (share: number) => void }) => Promise<Partial<S>>} work */
    async begin(work) {
      running?.abort();
      const own = new AbortController();
      running = own;
      say({ progress: 0, cancelled: false, message: '' });
      try {
        const found = await work({
          signal: own.signal,
          onProgress(progress) {
            if (running === own) say({ progress });
          },
        });
        // It may have been done just as it was given up.
        own.signal.throwIfAborted();
        update({ ...found, progress: null });
        return true;
      } catch (error) {
        if (running === own) say({ progress: null, message: messageOf(error) });
        own.abort();
        return false;
      } finally {
        if (running === own) running = null;
      }
    },

    /** What was there before stays. */
    cancel() {
      running?.abort();
      running = null;
      say({ progress: null, cancelled: true });
    },
  };
}
