// How formulas are put together. A leaf is drawn as its symbol or as its present number; all else is the same in both.
import { mathml, sub as indexed } from './symbols.js';

/** @import { Live } from './page.js' */
/** @import { SymbolName } from './symbols.js' */
/** @typedef {(name: SymbolName) => Element} Leaf */
/**
 * @typedef {object} Formula
 * @property {string} label Its number in the paper.
 * @property {(leaf: Leaf) => Element[]} build
 * @property {(leaf: (name: string) => Element) => Element[]} [filled] What the numbers stand in, where they do not stand in place of the symbols.
 * @property {(live: Live) => Record<string, string>} [numbers] By the leaves' names.
 */

/** @typedef {Element | string} Part A string of letters is a word, of anything else an operator. */

/** @param {Part} part */
function node(part) {
  if (typeof part !== 'string') return part;
  const element = mathml(/^[\p{L}]+$/u.test(part) ? 'mi' : /^\d/.test(part) ? 'mn' : 'mo', part);
  // An index alone would make them taller.
  if (part === '(' || part === ')') element.setAttribute('stretchy', 'false');
  return element;
}

/** @param {Part[]} parts */
export const row = (...parts) => mathml('mrow', ...parts.map(node));
/** What stands for one thing and lights up as one. @param {string} name @param {Part[]} parts */
export const term = (name, ...parts) => {
  const group = row(...parts);
  group.setAttribute('data-term', name);
  group.setAttribute('tabindex', '0');
  return group;
};
/** @param {Part} above @param {Part} below */
export const frac = (above, below) => mathml('mfrac', node(above), node(below));
/** @param {Part} base @param {Part} power */
export const sup = (base, power) => mathml('msup', node(base), node(power));
/** @param {Part} base @param {Part} index */
export const sub = (base, index) => indexed(node(base), node(index));
/** @param {Part} from @param {Part} to */
export const integral = (from, to) => mathml('msubsup', node('∫'), node(from), node(to));
/** @param {Part} of */
export const size = (of) => row('|', of, '|');
/** One line of a formula: what it is, an equals sign, and the rest. @param {Part} left @param {Part[]} right */
export const line = (left, ...right) => relation(left, '=', ...right);
/** The same with another sign. @param {Part} left @param {string} sign @param {Part[]} right */
export const relation = (left, sign, ...right) =>
  mathml('mtr', cell('right', node(left)), cell('left', row(sign, ...right)));
/** The same once more: what the line above comes to. @param {Part[]} right */
export const equally = (...right) => relation(row(), '=', ...right);
/** A line that goes on, its first sign that of a sum. @param {Part[]} right */
export function further(...right) {
  const goesOn = row(...right);
  if (typeof right[0] === 'string') goesOn.firstElementChild?.setAttribute('form', 'infix');
  return mathml('mtr', cell('right'), cell('left', goesOn));
}

/** @param {'left' | 'right'} side @param {Element[]} parts */
function cell(side, ...parts) {
  const element = mathml('mtd', ...parts);
  element.setAttribute('class', side);
  return element;
}

/** @param {string} name */
const ofAngle =
  (name) =>
  (/** @type {Part} */ angle, /** @type {Part | undefined} */ power = undefined) =>
    row(power ? sup(name, power) : name, '\u2061', angle);
export const sin = ofAngle('sin');
export const cos = ofAngle('cos');
export const dot = '·';
/** Between symbols a product needs no sign; between numbers it does. */
export const times = '\u2062';
/** In the place of symbols there are numbers now: their products have a dot. @param {Element} lines */
export function withDots(lines) {
  for (const sign of lines.querySelectorAll('mo')) if (sign.textContent === times) sign.textContent = dot;
}
/** Whether a number there has no sign before it but that of an equation or what encloses it, and no power: below zero it needs no brackets. @param {Element} number @returns {boolean} */
export function isFirst(number) {
  const { parentElement: parent, previousElementSibling: before } = number;
  if (parent?.localName === 'mfrac') return true;
  if (parent?.localName === 'msup') return before !== null;
  if (before) return before.localName === 'mo' && '=<>(|'.includes(before.textContent ?? '');
  return parent?.localName !== 'mrow' || isFirst(parent);
}
