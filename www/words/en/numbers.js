// How numbers are written in English.
import { costTextWith, fixed, groupedBy } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits; thin spaces, because a comma could be read as a decimal point. */
export const grouped = groupedBy('\u202f');

/** J. */
export const costText = costTextWith(grouped);

/** How long it took. @param {number} milliseconds */
export const tookText = (milliseconds) =>
  milliseconds < 1000 ? `${fixed(milliseconds, 0)} ms` : `${fixed(milliseconds / 1000, 1)} s`;
