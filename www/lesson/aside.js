// What a step tells of its own run while another is open: computed aside, once.
import { Pending } from '../core/pending.js';

/** Asked for when it is needed first; throws a Pending as long as it is on its way. @template T @param {() => Promise<T>} ask @returns {() => T} */
export function aside(ask) {
  /** @type {{ value: T } | null} */
  let found = null;
  /** @type {Promise<void> | null} */
  let arrival = null;
  return () => {
    arrival ??= ask().then(
      (value) => {
        found = { value };
      },
      // Without workers: to ask again is never worth it.
      () => new Promise(() => {}),
    );
    if (!found) throw new Pending(arrival);
    return found.value;
  };
}

/** Whether both say the same. @param {unknown} one @param {unknown} other */
export const isSame = (one, other) => JSON.stringify(one) === JSON.stringify(other);
