// How numbers are written in Korean.
import { costTextWith, groupedBy } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits. */
export const grouped = groupedBy(',');

/** J. */
export const costText = costTextWith(grouped);
