// The sizes of a figure, the height that it asks for, and the first that it says.
import { isEmbedded, isHeldByElement } from '../kit/host.js';

/** Of the messages between a figure and its host, which messages.js describes. */
export const version = 1;

/** What the dialog offers, in CSS pixels. */
export const sizes = /** @type {const} */ ([
  [400, 300],
  [640, 420],
  [800, 600],
]);

/** No figure is of use in less. */
export const leastHeight = 300;
/** Nor in more. */
export const mostHeight = 5000;

/** @param {unknown} height */
export const isHeight = (height) =>
  Number.isInteger(height) && Number(height) >= leastHeight && Number(height) <= mostHeight;
/** How high a figure looks best for its width, the most that helps it, and the least. @typedef {readonly [share: number, most: number, least?: number]} Shape */
/** @type {Shape} */
const ofLab = [0.64, 620];
/** Its words scroll beside the figure, which stays in sight; on a telephone under it, where some have to be seen. @type {Shape} */
const ofLesson = [1.2, 720, 640];

/** The height that a figure asks its host for. @param {readonly { name: string, figure: Shape }[]} parts @param {string} page @param {number} lesson @param {number} width */
export function wantedHeight(parts, page, lesson, width) {
  const shape = lesson > 0 ? ofLesson : (parts.find(({ name }) => name === page)?.figure ?? ofLab);
  const [share, most, least = leastHeight] = shape;
  return Math.round(Math.min(most, Math.max(least, share * width)));
}

/** Nothing is seen that a figure has not. @param {boolean} [isFigure] */
export const showAsFigure = (isFigure = isEmbedded) => document.body.toggleAttribute('data-embed', isFigure);

/** To the element that holds it: that it is a figure, and on its way, however slow the network is. */
export function sayLoading() {
  if (isHeldByElement && parent !== window) parent.postMessage({ ep: version, type: 'loading' }, '*');
}
