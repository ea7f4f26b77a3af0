// The symbols of the model as MathML: one symbol, one colour, one name of its term.

/** @typedef {keyof typeof symbols} SymbolName */

/** Letter with its prime, index, colour (a class). */
const symbols = /** @type {const} */ ({
  x: ['x', '', 'x'],
  y: ['y', '', 'y'],
  theta: ['θ', '', 'theta'],
  xe: ['x', 'e', 'x'],
  ye: ['y', 'e', 'y'],
  te: ['θ', 'e', 'theta'],
  xr: ['x', 'r', 'x'],
  yr: ['y', 'r', 'y'],
  tr: ['θ', 'r', 'theta'],
  xc: ['x', 'c', 'x'],
  yc: ['y', 'c', 'y'],
  tc: ['θ', 'c', 'theta'],
  kx: ['k', 'x', 'x'],
  ky: ['k', 'y', 'y'],
  kt: ['k', 'θ', 'theta'],
  v: ['v', '', 'energy'],
  w: ['ω', '', 'omega'],
  vr: ['v', 'r', 'energy'],
  wr: ['ω', 'r', 'omega'],
  V: ['V', '', ''],
  Vdot: ['V̇', '', ''],
  J: ['J', '', ''],
  W: ['W', '', ''],
  R: ['R', '', ''],
  Rv: ['R', 'v', 'energy'],
  Rw: ['R', 'ω', 'omega'],
  kappa: ['κ', '', ''],
  t: ['t', '', ''],
  tf: ['t', 'f', ''],
  p: ['p', '', ''],
  pr: ['p', 'r', ''],
  q: ['q', '', ''],
  qm: ['q', 'm', ''],
  delta: ['δ', '', ''],
  k: ['k', '', ''],
  ki: ['k', 'i', ''],
  kj: ['k', 'j', ''],
  s: ['σ', '', ''],
  sj: ['σ', 'j', ''],
  tau: ['τ', '', ''],
  tau2: ['τ′', '', ''],
  N: ['N', '', ''],
  Ni: ['N', 'i', ''],
  Nj: ['N', 'j', ''],
  n: ['n', '', ''],
  e1: ['ε', '1', 'energy'],
  e2: ['ε', '2', 'omega'],
  d1: ['δ', '1', 'energy'],
  d2: ['δ', '2', 'omega'],
  sx: ['σ', 'x', 'x'],
  sy: ['σ', 'y', 'y'],
  st: ['σ', 'θ', 'theta'],
  newkx: ['k′', 'x', 'x'],
  newky: ['k′', 'y', 'y'],
  newkt: ['k′', 'θ', 'theta'],
  newsx: ['σ′', 'x', 'x'],
  newsy: ['σ′', 'y', 'y'],
  newst: ['σ′', 'θ', 'theta'],
  Nx: ['N', 'x', 'x'],
  Ny: ['N', 'y', 'y'],
  Nt: ['N', 'θ', 'theta'],
  N2x: ['N′', 'x', 'x'],
  N2y: ['N′', 'y', 'y'],
  N2t: ['N′', 'θ', 'theta'],
});

/** @param {string} name @returns {name is SymbolName} */
export const isSymbol = (name) => Object.hasOwn(symbols, name);

const namespace = 'http://www.w3.org/1998/Math/MathML';

/** A MathML element. @param {string} tag @param {(Node | string)[]} children */
export function mathml(tag, ...children) {
  const element = document.createElementNS(namespace, tag);
  element.append(...children);
  // A browser that translates the page would take its letters for words.
  if (tag === 'math') element.setAttribute('translate', 'no');
  return element;
}

/** @param {SymbolName} name */
export function symbol(name) {
  const [letter, index, colour] = symbols[name];
  const element = withIndex(letter, index);
  if (colour) element.setAttribute('class', `of-${colour}`);
  element.setAttribute('data-term', name);
  return element;
}

/** A letter with its prime and its index, if it has them. The prime stands in line, where it has its size in every font. @param {string} letter @param {string} index */
function withIndex(letter, index) {
  // With its dot in one piece the letter would count as a word, and stand upright.
  const bare = mathml('mi', letter.replace('′', '').replace('\u0307', ''));
  const plain = letter.endsWith('\u0307') ? dotted(bare) : bare;
  const base = letter.endsWith('′') ? mathml('mrow', plain, mathml('mo', '′')) : plain;
  return index ? sub(base, mathml(/\d/.test(index) ? 'mn' : 'mi', index)) : base;
}

/** A letter with the dot of a rate. @param {Element} letter */
export function dotted(letter) {
  // Its sign stands high above the base line: WebKit would put all of that between it and the letter.
  const dot = mathml('mpadded', mathml('mo', '˙'));
  for (const [name, value] of [
    ['height', '0.2em'],
    ['depth', '0'],
    ['voffset', '-0.5em'],
  ])
    dot.setAttribute(name, value);
  const over = mathml('mover', letter, dot);
  over.setAttribute('accent', 'true');
  return over;
}

/** Every base reaches as far down as a y, so that all indices stand on one line: without a mathematical font an index hangs from its letter. @param {Element} base @param {Element} index */
export function sub(base, index) {
  const strut = mathml('mspace');
  strut.setAttribute('depth', '0.22em');
  return mathml('msub', mathml('mrow', base, strut), index);
}

/** A symbol within text. @param {SymbolName} name */
export function symbolInText(name) {
  const math = mathml('math', symbol(name));
  // Not every reader of screens has a name for what MathML holds.
  math.setAttribute('role', 'math');
  // Its letters are Latin in every language, and drawn in a font that has them so.
  math.setAttribute('lang', 'en');
  math.setAttribute('aria-label', symbols[name].slice(0, 2).join(' ').trim());
  return math;
}
