// Of the robustness part, what is the same in every language.
/** @import { Quantity } from '../request.js' */
import { fixed } from '../../../words/numbers.js';

/** @typedef {{ x: number, y: number }} Place */
/** @typedef {{ heading: number, outcome: string, cost: number }} Drive */

export const none = '–';
/** In the place of a number that is not there yet. */
export const waits = '…';

/** In percent. All is more than nearly all, and none less than a few. @param {number} share */
export const shareText = (share) =>
  share < 1 && share >= 0.9995 ? '>99.9' : share > 0 && share < 0.0005 ? '<0.1' : fixed(100 * share, 1);

/** @param {number} half */
export const extent = (half) => `±${half} m`;

/** @param {Quantity} quantity @param {number} tick @param {number} digits */
export const tickText = (quantity, tick, digits) =>
  quantity === 'share' ? fixed(100 * tick, 0) : fixed(tick, digits);

/** @param {string} number */
export const metres = (number) => `${number} m`;

/** @param {Place} place */
export const placeText = ({ x, y }) => `x ${fixed(x, 2)} m, y ${fixed(y, 2)} m`;
