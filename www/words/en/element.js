// What the element <ep-locomotion> says to the author of a page that has it wrong.

export const label = 'Evolving a robot’s controller';

/** @param {string} src */
export const noAddress = (src) => `src must be the address of the page, not “${src}”`;

/** @param {string} address */
export const silent = (address) =>
  `no figure answers at ${address}: the files of dist/ must be there, and the policy of this page must allow the frame (frame-src, Cross-Origin-Embedder-Policy)`;

/** @param {number} found @param {number} own */
export const otherVersion = (found, own) =>
  `the figure speaks version ${found} of the messages, this element version ${own}: take embed.js and the page from one copy of dist/`;

/** @param {number} least @param {number} most @param {string} found */
export const noHeight = (least, most, found) =>
  `height must be a whole number of pixels from ${least} to ${most}, not “${found}”`;

export const gone = 'the figure was taken from the page';
export const replaced = 'src was set: the figure that was asked has given way to another';
