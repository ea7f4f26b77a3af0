// Of the landscape, what is the same in every language.
import { threeDigits } from '../../../words/numbers.js';

/** @param {string} name @param {number} value */
export const gainText = (name, value) => `${name} ${threeDigits(value)}`;

export const legendLow = 'J';
