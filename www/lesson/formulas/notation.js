// Formulas are written as one reads them. A symbol is drawn as itself or as its present number; all else is the same in both.
//
// kx, newsx           a symbol, by its name
// xe'                 its rate
// ye^3, ∑_i, ∫_0^tf   a power, an index, bounds
// e1 / |ye|           a fraction, a size
// sin te, cos^2 te    of the one piece that follows
// *                   a product: a dot between numbers, nothing between symbols
// { … }               what stands together as one
// [kx: … ]            a term, which lights up as one
import { lab } from '../../words/index.js';
import { dotted, isSymbol, mathml, sub, symbol } from './symbols.js';

/** @import { Live } from '../page.js' */
/** @import { SymbolName } from './symbols.js' */
/** @typedef {(name: SymbolName) => Element} Leaf */
/**
 * @typedef {object} Formula
 * @property {string} label Its number in the paper.
 * @property {readonly string[]} lines As `lineOf` reads them.
 * @property {readonly string[]} [filled] What the numbers stand in, where they do not stand in place of the symbols.
 * @property {(live: Live) => Record<string, string>} [numbers] By the names of the symbols, or of the parts of J.
 */

const dot = '·';
/** What `*` stands for between symbols. */
const times = '\u2062';
const plainWords = ['T', 'd', 'e', 'i', 'max', 'sin', 'cos'];
/** They have the colours of the bar of J, and can stand for their numbers. */
const partsOfCost = ['time', 'finalError', 'path', 'energy', 'penalty'];

/** What is no symbol: a word, a number or a sign. @param {string} text */
function plain(text) {
  const isWord = plainWords.includes(text);
  if (/^\p{L}/u.test(text) && !isWord) throw new Error(`lesson: ${text} is no symbol`);
  const element = mathml(isWord ? 'mi' : /^\d/.test(text) ? 'mn' : 'mo', text);
  // An index alone would make them taller.
  if (text === '(' || text === ')') element.setAttribute('stretchy', 'false');
  return element;
}

/** @param {Element[]} pieces */
const row = (...pieces) => mathml('mrow', ...pieces);

/** A part of J has a word, all else its letters. @param {string} name */
const nameOf = (name) =>
  lab.costParts.find(([part]) => part === name)?.[1] ??
  symbol(/** @type {SymbolName} */ (name)).textContent ??
  name;

/** What stands for one thing and lights up as one. @param {string} name @param {Element[]} pieces */
function term(name, pieces) {
  const group = row(...pieces);
  group.setAttribute('data-term', name);
  group.setAttribute('role', 'group');
  group.setAttribute('aria-label', nameOf(name));
  if (partsOfCost.includes(name)) group.setAttribute('class', `part-${name}`);
  return group;
}

/** A symbol with the dot of its rate, over the letter alone: over letter and index it would read as a prime. @param {Element} of */
function rate(of) {
  const letter = of.localName === 'msub' ? of.querySelector('mi') : null;
  if (!letter) return dotted(of);
  letter.replaceWith(dotted(/** @type {Element} */ (letter.cloneNode(true))));
  return of;
}

/** The pieces that a text is read as. @param {string} text @param {Leaf} leaf */
export function piecesOf(text, leaf) {
  const tokens = text.match(/[\p{L}\d]+|\S/gu) ?? [];
  const take = () => tokens.shift() ?? '';
  const takes = (/** @type {string} */ sign) => tokens[0] === sign && take() === sign;
  const until = (/** @type {string} */ end) => {
    const pieces = [];
    while (tokens.length > 0 && !takes(end)) pieces.push(piece());
    return pieces;
  };
  /** @returns {Element} */
  const base = () => {
    const token = take();
    if (token === '{') return row(...until('}'));
    if (token === '|') return row(plain(token), piece(), plain(take()));
    if (token === '*') return plain(times);
    if (token === '[') {
      const [name] = [take(), take()];
      return term(name, until(']'));
    }
    if (token === 'sin' || token === 'cos') {
      const name = takes('^') ? mathml('msup', plain(token), base()) : plain(token);
      return row(name, plain('\u2061'), base());
    }
    const isLeaf = isSymbol(token) || partsOfCost.includes(token);
    return isLeaf ? leaf(/** @type {SymbolName} */ (token)) : plain(token);
  };
  /** @returns {Element} */
  const piece = () => {
    let whole = base();
    if (takes("'")) whole = rate(whole);
    if (takes('_')) {
      const index = base();
      whole = takes('^') ? mathml('msubsup', whole, index, base()) : sub(whole, index);
    } else if (takes('^')) whole = mathml('msup', whole, base());
    return takes('/') ? mathml('mfrac', whole, piece()) : whole;
  };
  return until('');
}

/** A line: what it is, a sign, and the rest; `= …`, what the line above comes to; or `+ …`, the same sum going on. @param {string} text @param {Leaf} leaf */
export function lineOf(text, leaf) {
  const right = piecesOf(text, leaf);
  if (/^[+−]/.test(text)) {
    right[0].setAttribute('form', 'infix');
    return mathml('mtr', cell('right'), cell('left', row(...right)));
  }
  const left = text.startsWith('=') ? row() : /** @type {Element} */ (right.shift());
  return mathml('mtr', cell('right', left), cell('left', row(...right)));
}

/** @param {'left' | 'right'} side @param {Element[]} parts */
function cell(side, ...parts) {
  const element = mathml('mtd', ...parts);
  element.setAttribute('class', side);
  return element;
}

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
