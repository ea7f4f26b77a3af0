// The text that puts a figure into another page, and the height that a figure asks for.

/** @typedef {import('../run/state.js').PageName} PageName */

/** Of the messages between a figure and its host, which messages.js describes. */
export const version = 1;

/** A frame of this name holds a figure even if its address does not say ?embed, as that of a Blob cannot. */
export const frameName = 'ep-locomotion figure';

/** What the dialog offers, in CSS pixels. */
export const sizes = /** @type {const} */ ([
  [400, 300],
  [640, 420],
  [800, 600],
]);

/** No figure is of use in less. */
export const leastHeight = 300;
/** How high a figure looks best for its width, and the most that helps it. */
const shapes = /** @type {const} */ ({
  lab: [0.64, 620],
  generation: [0.72, 620],
  curves: [0.72, 700],
  landscape: [0.64, 620],
  robustness: [0.64, 620],
  training: [0.7, 640],
  disturbance: [0.75, 680],
  luck: [0.7, 640],
  // Its words scroll beside the figure, which stays in sight.
  lesson: [1.2, 720],
});

/** The height that a figure asks its host for. @param {PageName} page @param {number} lesson @param {number} width */
export function wantedHeight(page, lesson, width) {
  const [share, most] = shapes[lesson > 0 ? 'lesson' : page];
  return Math.round(Math.min(most, Math.max(leastHeight, share * width)));
}

/** What begins and ends a value in HTML is written otherwise. @param {string} text */
const quoted = (text) => text.replaceAll('&', '&amp;').replaceAll('"', '&quot;').replaceAll('<', '&lt;');

/** The iframe, to be pasted into a page. @param {{ address: string, title: string, width: number, height: number }} frame */
export const frameText = ({ address, title, width, height }) =>
  `<iframe src="${quoted(address)}" title="${quoted(title)}" width="${width}" height="${height}" style="border: 0; max-width: 100%" loading="lazy" allow="fullscreen"></iframe>`;
