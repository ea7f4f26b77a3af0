/** @typedef {import('../pages.js').PageParts} PageParts */
/** @typedef {import('../pages.js').Page} Page */
/** @typedef {{}} TrainingState */

/** @type {TrainingState} */
export const firstTraining = {};

/** @param {PageParts} parts @returns {Page} */
export function createTrainingPage(parts) {
  return { name: 'training', draw() {} };
}
