// Of the Lyapunov function, what is the same in every language.
/** @import { Experiment } from '../../../../core/engine.js' */
import { fixed, powerOfTen, powerText, threeDigits } from '../../../../words/numbers.js';

/** @typedef {'lyapunov' | 'rate' | 'promised' | 'x' | 'y' | 'theta'} Term */

/**
 * What stands over each number, by the law; every second piece is a subscript.
 * @param {Record<'rate' | 'promised', readonly string[]>} words
 * @returns {Readonly<Record<Experiment['law'], Readonly<Record<Term, readonly string[]>>>>}
 */
export const termsOf = (words) => ({
  'shim-kim': {
    lyapunov: ['V'],
    ...words,
    x: ['−k', 'x', ' x', 'e', '² cos² θ', 'e'],
    y: ['− k', 'y', ' y', 'e', '⁴'],
    theta: ['− k', 'θ', ' sin² θ', 'e'],
  },
  kanayama: {
    lyapunov: ['V'],
    ...words,
    x: ['−k', 'x', ' x²'],
    y: ['+ 0'],
    theta: ['− v', 'r', ' k', 'θ', '/k', 'y', ' sin² θ', 'e'],
  },
});

export const gainNames = ['kx', 'ky', 'kθ'];
export const errorNames = ['xₑ', 'yₑ', 'θₑ'];

export const lyapunovSymbol = 'V';
/** What makes V̇/V of V̇. */
export const relative = '/V';

/** V as it is written on its axis. @param {Experiment['law']} law @param {boolean} isPromised */
export const lyapunovFormula = (law, isPromised) =>
  `V = ½ xₑ² + ½ yₑ² + (1 − cos θₑ)${law === 'kanayama' && isPromised ? '/ky' : ''}`;

/** Numbers that belong together, with the same digits after the point, so that one sees them add up. @param {readonly number[]} values */
export function amounts(values) {
  const most = Math.max(0, ...values.map(Math.abs).filter(Number.isFinite));
  const digits = most >= 1000 ? 0 : most >= 100 ? 1 : most >= 1 ? 2 : most >= 0.1 ? 3 : 4;
  return values.map((value) =>
    Number.isFinite(value) && Math.abs(value) < 1e5 ? fixed(value, digits) : amount(value),
  );
}

/** A number of any size. @param {number} value */
export function amount(value) {
  if (Number.isNaN(value)) return '–';
  if (!Number.isFinite(value)) return value > 0 ? '∞' : '−∞';
  const size = Math.abs(value);
  return size === 0 || (size >= 1e-3 && size < 1e5) ? threeDigits(value) : powerText(value);
}

/** @param {number} value @param {boolean} isLog */
export const tickText = (value, isLog) => {
  const size = Math.abs(value);
  const exponent = Math.round(Math.log10(size));
  if (isLog && Math.abs(value / 10 ** exponent - 1) < 1e-9) return powerOfTen(exponent);
  if (size === 0 || (size >= 1e-3 && size < 1e5)) return threeDigits(value);
  return powerText(value);
};

/** @param {number} radians */
export const angleText = (radians) => fixed((radians * 180) / Math.PI, 2);
export { timeText } from '../../words/common.js';
