// How numbers are written in English.
import { costTextWith, groupedBy } from '../numbers.js';

export * from '../numbers.js';

/** Groups of three digits; thin spaces, because a comma could be read as a decimal point. */
export const grouped = groupedBy('\u202f');

/** J. */
export const costText = costTextWith(grouped);
