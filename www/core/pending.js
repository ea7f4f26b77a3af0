// What a worker still computes: whoever asks for it is told so by a throw, and asks again once it is there.

/** Thrown before anything is changed. */
export class Pending extends Error {
  /** @param {Promise<unknown>} arrival Settles, without an error, when asking again is worth it. @param {() => number | null} share What is done, from 0 to 1, if that is known. */
  constructor(arrival, share = () => null) {
    super('this is still being computed');
    this.arrival = arrival;
    this.share = share;
  }
}

/**
 * Asks for all of it before it says that something is missing.
 * @template {readonly unknown[]} T
 * @param {readonly [...{ [K in keyof T]: () => T[K] }]} asked
 * @returns {T}
 */
export function together(asked) {
  /** @type {Pending[]} */
  const missing = [];
  const found = asked.map((ask) => {
    try {
      return ask();
    } catch (error) {
      if (!(error instanceof Pending)) throw error;
      missing.push(error);
      return null;
    }
  });
  if (missing.length > 0)
    throw new Pending(Promise.all(missing.map(({ arrival }) => arrival)), missing[0].share);
  return /** @type {any} */ (found);
}

/** Does it if all that it asks for is there; else it comes to null, and it is said when it can be tried again. @template T @param {() => T} act @param {() => void} onArrival */
export function tryNow(act, onArrival) {
  try {
    return act();
  } catch (error) {
    if (!(error instanceof Pending)) throw error;
    error.arrival.then(onArrival);
    return null;
  }
}

/** Does it now, or once what it asks for is there, if it is still wanted then. @param {() => void} act @param {() => boolean} isWanted */
export const whenThere = (act, isWanted) =>
  tryNow(act, () => {
    if (isWanted()) whenThere(act, isWanted);
  });
