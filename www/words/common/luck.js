// Of the luck part, what is the same in every language.
import { fixed, superscript } from '../numbers.js';

/** @typedef {import('../../parts/luck/request.js').SeedSurvey} SeedSurvey */
/** @typedef {'start' | 'goal' | 'limits' | 'other'} Change */

export const costSymbol = 'J';

/** 10 to a power. @param {number} power */
export const powerOfTen = (power) =>
  power >= -3 && power <= 3 ? fixed(10 ** power, Math.max(0, Math.round(-power))) : `10${superscript(power)}`;

export const gainNames = ['x', 'y', 'θ'].map((index) => `k${index}`);

/** @param {number} value */
export const tick = (value) => String(value).replace('-', '−');

export const gainColumns = ['kx (1/s)', 'ky (1/(m² s))', 'kθ (rad/s)'];

/** @param {SeedSurvey} survey */
export const fileName = ({ first, runs, generations }) =>
  `seeds-${first}-to-${first + runs.length - 1}-${generations}-generations.csv`;
