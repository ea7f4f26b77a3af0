// How numbers are written in English.
import { costTextWith } from '../numbers.js';

export * from '../numbers.js';

const groups = new Intl.NumberFormat('en');

/** Groups of three digits; thin spaces, because a comma could be read as a decimal point. @param {number} whole */
export const grouped = (whole) => groups.format(whole).replaceAll(',', '\u202f');

/** J. */
export const costText = costTextWith(grouped);
