// Of the training part, what is the same in every language.
/** @import { RowName } from '../request.js' */
import { costText, fixed } from '../../../words/numbers.js';

/** @param {RowName} name */
export const isEvolved = (name) => name === 'one' || name === 'circle' || name === 'grid';

/** @param {number} value */
export const cost = (value) => (value < 100 ? fixed(value, 2) : costText(value));

/** @param {number} gain */
export const gain = (gain) => fixed(gain, 2);

export const none = '–';
