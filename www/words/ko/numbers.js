// How numbers are written in Korean.
import { costTextWith, fixed, groupedBy } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits. */
export const grouped = groupedBy(',');

/** J. */
export const costText = costTextWith(grouped);

/** How long it took. @param {number} milliseconds */
export const tookText = (milliseconds) =>
  milliseconds < 1000 ? `${fixed(milliseconds, 0)} ms` : `${fixed(milliseconds / 1000, 1)}초`;
