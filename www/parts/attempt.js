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
  let newest = new AbortController();
  const say = (/** @type {Partial<Attempted>} */ patch) => update(/** @type {Partial<S>} */ (patch));

  return {
    /** What is under way is given up for it. Whether it came to its end. @param {(options: { signal: AbortSignal, onProgress: (share: number) => void }) => Promise<Partial<S>>} work */
    async begin(work) {
      newest.abort();
      const own = new AbortController();
      newest = own;
      const { signal } = own;
      say({ progress: 0, cancelled: false, message: '' });
      try {
        const found = await work({
          signal,
          onProgress(progress) {
            if (!signal.aborted) say({ progress });
          },
        });
        // It may have been done just as it was given up.
        signal.throwIfAborted();
        update({ ...found, progress: null });
        return true;
      } catch (error) {
        if (!signal.aborted) say({ progress: null, message: messageOf(error) });
        own.abort();
        return false;
      }
    },

    /** What was there before stays. */
    cancel() {
      newest.abort();
      say({ progress: null, cancelled: true });
    },
  };
}
