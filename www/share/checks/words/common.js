// Of the page's checks, what is the same in every language.
/** @import { Outcome } from '../../../core/checks/check.js' */
import { powerText } from '../../../words/numbers.js';

/** A number of a check: as many digits as it is checked for. @param {number | string} value @param {number} tolerance */
function valueText(value, tolerance) {
  if (typeof value === 'string') return value;
  if (!Number.isFinite(value)) return String(value);
  if (value !== 0 && Math.abs(value) < 1e-5) return powerText(value, 2).replace(/^1×/, '');
  const digits = tolerance > 0 ? 1 - Math.round(Math.log10(tolerance)) : 7;
  return String(Number(value.toPrecision(Math.min(digits, 15)))).replace('-', '−');
}

/** @param {Outcome['found']} values @param {Outcome} outcome */
export const valuesText = (values, { units, tolerance }) =>
  values
    .map((value, i) => [valueText(value, tolerance), units[i]].filter((text) => text).join('\u00a0'))
    .join(', ');

/** @param {string} version @param {string} browser */
export const about = (version, browser) => `ep-locomotion ${version} · ${browser}`;
