// How numbers are written in Korean.
import { costTextWith } from '../numbers.js';

export * from '../numbers.js';

const groups = new Intl.NumberFormat('ko');

/** Groups of three digits. @param {number} whole */
export const grouped = (whole) => groups.format(whole);

/** J. */
export const costText = costTextWith(grouped);
