// Every word of a figure in another page’s frame.
export const openFull = 'Open the full page';
/** It leads out of an exercise. */
export const openFree = 'Open the page without the task';
export const fullScreen = 'Full screen';
export const leaveFullScreen = 'Leave full screen';

export const givenUp = 'it was given up before it was there';

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) => `this is version ${own} of the messages, not ${found}`;

/** @param {string} found @param {readonly string[]} known */
export const unknownType = (found, known) => `type must be one of ${known.join(', ')}, not ${found}`;

/** @param {string} type @param {string} found @param {readonly string[]} known */
export const unknownField = (type, found, known) =>
  `a field of ${type} must be one of ${known.join(', ')}, not ${found}`;

/** @param {number} length */
export const aList = (length) => `an array of ${length}`;
export const anObject = 'an object';

export const linkOrExperiment =
  'set needs either a link, which is a text, or an experiment, which is an object';

/** @param {string} field @param {number} least @param {number} most @param {string} found */
export const wholeNumber = (field, least, most, found) =>
  `${field} must be a whole number from ${least} to ${most}, not ${found}`;

/** @param {string} found */
export const threeGains = (found) => `gains must be three numbers kx, ky, kθ, not ${found}`;
