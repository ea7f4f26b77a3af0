/** @typedef {import('../pages.js').PageParts} PageParts */
/** @typedef {import('../pages.js').Page} Page */
/** @typedef {{}} LuckState */

/** @type {LuckState} */
export const firstLuck = {};

/** @param {PageParts} parts @returns {Page} */
export function createLuckPage(parts) {
  return { name: 'luck', draw() {} };
}
