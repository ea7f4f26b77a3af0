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

/** In percent. All is more than nearly all, and none less than one. @param {number} part @param {number} count */
export const shareOf = (part, count) => {
  const few = Math.min(part, count - part) / count;
  return fixed((100 * part) / count, few > 0 && few <= 0.005 ? 1 : 0);
};
