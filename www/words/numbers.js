// How numbers are written, in every language.
/** @import { Posture } from '../core/engine.js' */

/** Fixed digits and no −0, as it is typed. @param {number} value @param {number} digits */
export const typed = (value, digits) => (Math.abs(value) < 0.5 / 10 ** digits ? 0 : value).toFixed(digits);

/** From here on numbers are written with a power of ten, as wild gains bring them about. */
const huge = 1e15;

/** Beyond all numbers, which a robot may be that is nowhere, too. @param {number} value */
const beyond = (value) => (value < 0 ? '−∞' : '∞');

/** As typed(), as it is printed, with a minus sign. @param {number} value @param {number} digits */
export const fixed = (value, digits) =>
  Math.abs(value) < huge ? typed(value, digits).replace('-', '−') : powerText(value);

/** What is added, or taken away. @param {number} by */
export function changeText(by) {
  const text = fixed(by, 2);
  return by > 0 && text !== '0.00' ? `+${text}` : text;
}

/** So many digits that count, with a power of ten where that is easier to read. @param {number} value @param {number} digits */
const counting = (value, digits) =>
  value === 0 || (Math.abs(value) >= 1e-6 && Math.abs(value) < huge)
    ? String(Number(value.toPrecision(digits))).replace('-', '−')
    : powerText(value, digits);

/** As printed. @param {number} value */
export const threeDigits = (value) => counting(value, 3);

/** As printed. @param {number} value */
export const sixDigits = (value) => counting(value, 6);

/** As an exponent is written. @param {number | string} whole */
const superscript = (whole) =>
  Array.from(String(whole), (letter) => '⁻⁰¹²³⁴⁵⁶⁷⁸⁹'['-0123456789'.indexOf(letter)]).join('');

/** 10 to a power, in full where it is short. @param {number} power @param {number} [least] */
export const powerOfTen = (power, least = -2) =>
  power >= least && power <= 3
    ? fixed(10 ** power, Math.max(0, Math.round(-power)))
    : `10${superscript(power)}`;

/** A number of any size, with a power of ten. @param {number} value @param {number} [digits] Those that count. */
export function powerText(value, digits = 3) {
  if (value === 0) return '0';
  if (!Number.isFinite(value)) return beyond(value);
  const [mantissa, power] = value.toExponential(digits - 1).split('e');
  return `${String(Number(mantissa)).replace('-', '−')}×10${superscript(power.replace('+', ''))}`;
}

/** @param {number} value */
export function costText(value) {
  if (!Number.isFinite(value)) return '∞';
  if (value < 100) return fixed(value, 3);
  return value < 1e6 ? fixed(value, 1) : powerText(value);
}

/** Groups of three digits, by what stands between them. Intl knows it too, but takes tens of milliseconds to begin with. @param {string} mark */
export const groupedBy = (mark) => (/** @type {number} */ whole) =>
  String(whole).replace(/\B(?=(\d{3})+$)/g, mark);

/** costText(), with the digits of what is large in groups. @param {(whole: number) => string} grouped */
export const costTextWith = (grouped) => (/** @type {number} */ value) => {
  const text = costText(value);
  const [whole, part] = text.split('.');
  return value >= 1e4 && value < 1e6 ? `${grouped(Number(whole))}.${part}` : text;
};

/** @param {number} radians */
export const degrees = (radians) => `${fixed((radians * 180) / Math.PI, 0)}°`;

/** @param {Posture} posture */
export const postureText = ({ x, y, theta }) => `${fixed(x, 2)} m, ${fixed(y, 2)} m, ${degrees(theta)}`;

/** A comma before three digits may be a decimal point or not. */
const inGroups = /^[+-]?[1-9]\d{0,2}(,\d{3})+(\.\d*)?$/;

/** Groups of three digits with spaces, as they are written here too; between two numbers there may be one as well. */
const inSpacedGroups = /^[+-]?[1-9]\d{0,2}([ \u00a0\u2009\u202f]\d{3})+([.,]\d*)?$/;
/** As wide as Korean letters. */
const wide = /[！-～]/g;

/** @param {string} text */
export const narrowed = (text) =>
  text.replace(wide, (letter) => String.fromCharCode(letter.charCodeAt(0) - 0xfee0)).trim();

/** With the signs of a keyboard; an en dash is what word processors make of a minus. @param {string} text */
function plainOf(text) {
  const trimmed = narrowed(text).replaceAll(/[−–]/g, '-');
  return inSpacedGroups.test(trimmed) ? trimmed.replaceAll(/\s/g, '') : trimmed;
}

/** Whether its comma may be a decimal point or not. @param {string} text */
export const isUnsure = (text) => inGroups.test(plainOf(text));

/** What somebody has typed; NaN if it is no number, or not sure which. @param {string} text */
export function numberOf(text) {
  const plain = plainOf(text);
  return plain === '' || inGroups.test(plain) ? Number.NaN : Number(plain.replace(',', '.'));
}

/** A number that is below another, with as few digits as show it. @param {number} value @param {number} limit @param {(value: number) => string} usual */
export const textBelow = (value, limit, usual) =>
  [usual, sixDigits].map((write) => write(value)).find((text) => !(Number(text) >= limit)) ?? String(value);

const closer = (/** @type {number} */ value) => (value < 1e6 ? sixDigits(value) : powerText(value, 6));

/** Two numbers, as usual, or else with six digits, or with all, if only those tell them apart. @param {number} a @param {number} b @param {(value: number) => string} usual */
export const textsApart = (a, b, usual) =>
  [usual, closer, String].map((write) => [write(a), write(b)]).find(([one, other]) => one !== other) ?? [
    usual(a),
    usual(b),
  ];

/** A time of a drive: hundredths of a second, finer where it is over sooner. @param {number} time @param {number} finalTime */
export const clockTime = (time, finalTime) =>
  fixed(time, Math.max(2, 1 - Math.floor(Math.log10(finalTime || 1))));

/** With a minus sign where it is below zero, within a formula. @param {number} value @param {number} digits */
export function signed(value, digits) {
  return Math.abs(value) < 1e4 ? fixed(value, digits) : powerText(value, 2);
}

/** @param {number} radians */
export const degreesText = (radians) => `${fixed((radians * 180) / Math.PI, 1)}°`;
