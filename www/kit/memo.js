// What is computed or drawn anew only when something has changed.

/**
 * The same function, computed anew only when an argument is another one.
 * @template {unknown[]} A @template R
 * @param {(...args: A) => R} compute
 * @param {number} [kept] Of how many arguments it knows the result, the latest first.
 * @returns {(...args: A) => R}
 */
export function remember(compute, kept = 1) {
  /** @type {{ args: A, value: R }[]} */
  let known = [];
  return (...args) => {
    const one = known.find((other) => args.every((arg, i) => arg === other.args[i])) ?? {
      args,
      value: compute(...args),
    };
    if (one !== known[0]) known = [one, ...known.filter((other) => other !== one)].slice(0, kept);
    return one.value;
  };
}

/**
 * The same function of an object, computed once for each.
 * @template {object} K @template R
 * @param {(key: K) => R} compute
 * @returns {(key: K) => R}
 */
export function rememberEach(compute) {
  /** @type {WeakMap<K, R>} */
  const known = new WeakMap();
  return (key) => {
    if (!known.has(key)) known.set(key, compute(key));
    return /** @type {R} */ (known.get(key));
  };
}

/**
 * True when it is called with other arguments than the last time.
 * @returns {(...args: unknown[]) => boolean}
 */
export function watch() {
  /** @type {unknown[] | null} */
  let last = null;
  return (...args) => {
    const changed = !last || args.some((arg, i) => arg !== last?.[i]);
    last = args;
    return changed;
  };
}

/** Made when it is asked for first. @template R @param {() => R} make @returns {() => R} */
export const once = (make) => remember(make);

/** The same; where it cannot be made that is said at every time, and it is not tried again. @template R @param {() => R} make @returns {() => R} */
export function onceAtMost(make) {
  const made = once(() => {
    try {
      return { result: make() };
    } catch (error) {
      return { error };
    }
  });
  return () => {
    const outcome = made();
    if ('error' in outcome) throw outcome.error;
    return outcome.result;
  };
}
