// Of σ over the generations, what is the same in every language.
import { powerText, threeDigits } from '../numbers.js';

export { powerOfTen } from '../numbers.js';

/** @param {number} value */
export const sigmaText = (value) => (value >= 0.001 ? threeDigits(value) : powerText(value, 2));
