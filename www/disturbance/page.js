/** @typedef {import('../pages.js').PageParts} PageParts */
/** @typedef {import('../pages.js').Page} Page */
/** @typedef {{}} DisturbanceState */

/** @type {DisturbanceState} */
export const firstDisturbance = {};

/** @param {PageParts} parts @returns {Page} */
export function createDisturbancePage(parts) {
  return { name: 'disturbance', draw() {} };
}
