// How numbers are written in English.
import { beginningOf } from '../../kit/text.js';
import { costTextWith, fixed, groupedBy, isUnsure } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits; thin spaces, because a comma could be read as a decimal point. */
export const grouped = groupedBy('\u202f');

/** J. */
export const costText = costTextWith(grouped);

/** How long it took. @param {number} milliseconds */
export const tookText = (milliseconds) =>
  milliseconds < 1000 ? `${fixed(milliseconds, 0)} ms` : `${fixed(milliseconds / 1000, 1)} s`;

/** What was typed and is no number, or none that can be. @param {string} text */
export const wasText = (text) =>
  `it was “${beginningOf(text)}”.${isUnsure(text) ? ' A comma before three digits may mean thousands: write a point, or no comma.' : ''}`;
