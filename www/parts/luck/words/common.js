// Of the luck part, what is the same in every language.
/** @import { SeedSurvey } from '../request.js' */
import { powerOfTen as shortPower } from '../../../words/numbers.js';

/** @typedef {'start' | 'goal' | 'limits' | 'other'} Change */

export const costSymbol = 'J';

/** @param {number} power */
export const powerOfTen = (power) => shortPower(power, -3);

export const gainNames = ['x', 'y', 'θ'].map((index) => `k${index}`);

/** @param {number} value */
export const tick = (value) => String(value).replace('-', '−');

export const gainColumns = ['kx (1/s)', 'ky (1/(m² s))', 'kθ (rad/s)'];

/** @param {SeedSurvey} survey */
export const fileName = ({ first, runs, generations }) =>
  `seeds-${first}-to-${first + runs.length - 1}-${generations}-generations.csv`;
