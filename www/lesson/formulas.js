// The formulas of the paper. A leaf is drawn as its symbol or as its present number; all else is the same in both.
import { degreesText, signed } from '../words/numbers.js';
import { mathml } from './symbols.js';

/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('./symbols.js').SymbolName} SymbolName */
/** @typedef {(name: SymbolName) => Element} Leaf */
/** @typedef {{ label: string, build: (leaf: Leaf) => Element[], numbers?: (live: Live) => Record<string, string> }} Formula */

/** @typedef {Element | string} Part A string of letters is a word, of anything else an operator. */

/** @param {Part} part */
const node = (part) =>
  typeof part !== 'string'
    ? part
    : mathml(/^[\p{L}]+$/u.test(part) ? 'mi' : /^\d/.test(part) ? 'mn' : 'mo', part);

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
/** @param {Part} inside */
export const root = (inside) => mathml('msqrt', node(inside));
/** One line of a formula: what it is, an equals sign, and the rest. @param {Part} left @param {Part[]} right */
export const line = (left, ...right) =>
  mathml('mtr', cell('right', node(left)), cell('left', row('=', ...right)));
/** A line that goes on. @param {Part[]} right */
export const further = (...right) => mathml('mtr', cell('right'), cell('left', row(...right)));

/** @param {'left' | 'right'} side @param {Element[]} parts */
function cell(side, ...parts) {
  const element = mathml('mtd', ...parts);
  element.setAttribute('class', side);
  return element;
}

const sin = (/** @type {Part} */ of) => row('sin', '\u2061', of);
const cos = (/** @type {Part} */ of) => row('cos', '\u2061', of);
const dot = '·';

/** The numbers that the law works with, at the time of the robot's clock. @param {Live} live */
function lawNumbers({ sample, gains }) {
  const { x, y, theta } = sample.error;
  const [kx, ky, kt] = gains;
  return {
    xe: signed(x, 2),
    ye: signed(y, 2),
    te: degreesText(theta),
    kx: signed(kx, 2),
    ky: signed(ky, 2),
    kt: signed(kt, 2),
    v: signed(sample.command.linear, 2),
    w: signed(sample.command.angular, 2),
  };
}

/** @satisfies {Record<string, Formula>} */
export const formulas = {
  /** (3) */
  error: {
    label: '(3)',
    build: (leaf) => [
      line(
        leaf('xe'),
        row(cos(leaf('tr')), '(', leaf('xr'), '−', leaf('xc'), ')'),
        '+',
        row(sin(leaf('tr')), '(', leaf('yr'), '−', leaf('yc'), ')'),
      ),
      line(
        leaf('ye'),
        '−',
        row(sin(leaf('tr')), '(', leaf('xr'), '−', leaf('xc'), ')'),
        '+',
        row(cos(leaf('tr')), '(', leaf('yr'), '−', leaf('yc'), ')'),
      ),
      line(leaf('te'), leaf('tr'), '−', leaf('tc')),
    ],
    numbers: ({ sample }) => ({
      xe: signed(sample.error.x, 2),
      ye: signed(sample.error.y, 2),
      te: degreesText(sample.error.theta),
      xr: signed(sample.reference.x, 2),
      yr: signed(sample.reference.y, 2),
      tr: degreesText(sample.reference.theta),
      xc: signed(sample.posture.x, 2),
      yc: signed(sample.posture.y, 2),
      tc: degreesText(sample.posture.theta),
    }),
  },
  /** (5) for a goal that stands still */
  law: {
    label: '(5)',
    build: (leaf) => [
      line(
        leaf('v'),
        term('kx', leaf('kx'), dot, leaf('xe'), dot, cos(leaf('te'))),
        '−',
        term('ky', leaf('ky'), dot, frac(sup(leaf('ye'), '3'), sin(leaf('te')))),
      ),
      line(
        leaf('w'),
        term('kt', leaf('kt'), dot, sin(leaf('te'))),
        '+',
        term(
          'ky',
          leaf('ky'),
          dot,
          frac(row(leaf('xe'), sup(leaf('ye'), '3'), cos(leaf('te'))), sup(sin(leaf('te')), '2')),
        ),
      ),
      further('+', term('kx', leaf('kx'), dot, leaf('xe'), dot, leaf('ye'), dot, cos(leaf('te')))),
    ],
    numbers: lawNumbers,
  },
};
