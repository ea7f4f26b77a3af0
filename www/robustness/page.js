/** @typedef {import('../pages.js').PageParts} PageParts */
/** @typedef {import('../pages.js').Page} Page */
/** @typedef {{}} RobustnessState */

/** @type {RobustnessState} */
export const firstRobustness = {};

/** @param {PageParts} parts @returns {Page} */
export function createRobustnessPage(parts) {
  return { name: 'robustness', draw() {} };
}
