// Every word of a figure in another page's frame, and of the dialog that writes the frame.
export * from '../common/embed.js';

export const texts = {
  embedTitle: 'Embed',
  embedHelp:
    'Puts this view into another page, as it is now: a course page, a blog, slides. It stands still until someone uses it.',
  embedText: 'The text to paste',
  embedCopy: 'Copy',
  embedDisk: 'This page was opened from a disk: put its file beside the page into which you paste this.',
};

export const sizeLegend = 'Size of the frame';

export const copied = 'The text is copied.';
export const notCopied = 'This browser lets no page copy: the text is selected, copy it by the keyboard.';

/** What a screen reader says of the frame. @param {string} part */
export const frameTitle = (part) => `Evolving a robot’s controller: ${part}`;

export const openFull = 'Open the full page';
export const fullScreen = 'Full screen';
export const leaveFullScreen = 'Leave full screen';

/** @param {string} found @param {number} own */
export const otherVersion = (found, own) => `this is version ${own} of the messages, not ${found}`;

/** @param {string} found @param {readonly string[]} known */
export const unknownType = (found, known) => `type must be one of ${known.join(', ')}, not ${found}`;

export const linkOrExperiment =
  'set needs either a link, which is a text, or an experiment, which is an object';

/** @param {string} field @param {number} least @param {number} most @param {string} found */
export const wholeNumber = (field, least, most, found) =>
  `${field} must be a whole number from ${least} to ${most}, not ${found}`;

/** @param {string} found */
export const threeGains = (found) => `gains must be three numbers kx, ky, kθ, not ${found}`;
