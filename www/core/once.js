/** Made when it is asked for first. @template {unknown[]} A @template T @param {(...args: A) => T} make */
export function once(make) {
  /** @type {{ value: T } | null} */
  let made = null;
  return (/** @type {A} */ ...args) => {
    made ??= { value: make(...args) };
    return made.value;
  };
}
