// Templates without a browser.

/** What a template says. @param {any} part @returns {string} */
export const written = (part) =>
  typeof part === 'string' || typeof part === 'number'
    ? String(part)
    : Array.isArray(part)
      ? part.map(written).join('')
      : (part?.strings ?? [])
          .map((/** @type {string} */ text, /** @type {number} */ i) => text + written(part.values[i]))
          .join('');
