// Of checking hand-ins, what is the same in every language.

/** @typedef {'number' | 'pin' | 'name' | 'who' | 'cost' | 'met' | 'points' | 'drives' | 'remark' | 'open'} Column */

/** @param {number} value @param {number} [digits] */
export const numberText = (value, digits = 6) =>
  Number.isFinite(value) ? String(Number(value.toFixed(digits))) : '∞';

/** @param {number} index From 0. */
export const rowNumber = (index) => String(index + 1);
