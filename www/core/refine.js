// Asking the workers for a picture: coarse while something moves, finer when it rests.
/**
 * What to ask for next, given what is wanted, what runs and what is done.
 * @template S, R
 * @param {object} job
 * @param {readonly number[]} job.counts How fine, from the coarse one that is short to the last.
 * @param {(spec: S, count: number) => Promise<R>} job.compute Rejects with an AbortError when something newer took its place.
 * @param {(result: R) => void} job.onResult
 * @param {(error: unknown) => void} job.onFailure
 */
export function createRefining({ counts, compute, onResult, onFailure }) {
  const last = counts.length - 1;
  /** @type {{ spec: S, level: number } | null} */
  let running = null;
  /** @type {{ spec: S, level: number } | null} */
  let done = null;
  /** @type {S | null} */
  let failed = null;

  /** @param {S} spec @param {number} level */
  const ask = async (spec, level) => {
    const own = { spec, level };
    running = own;
    try {
      const result = await compute(spec, counts[level]);
      done = own;
      onResult(result);
    } catch (error) {
      if (running !== own || (error instanceof DOMException && error.name === 'AbortError')) return;
      // Asked for no more, until it is retried: the picture stays, and the page says why.
      failed = spec;
      onFailure(error);
    } finally {
      if (running === own) running = null;
    }
  };

  return {
    /** The same object as spec means the same picture. @param {S} spec @param {boolean} moving */
    follow(spec, moving) {
      if (spec === failed) return;
      const level = done?.spec === spec ? done.level + 1 : 0;
      if (level > last || (level > 0 && moving)) return;
      // What is not the last is short and is let end, so that pictures keep coming while the goal is dragged.
      if (running && (running.spec === spec || running.level < last)) return;
      ask(spec, level);
    },

    /** What failed may be asked for once more. */
    retry() {
      failed = null;
    },
  };
}
