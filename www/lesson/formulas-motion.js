// How the robot and its errors move, and what becomes of V when the law is put in.
import { cos, dot, equally, frac, line, row, sin, sup } from './notation.js';
import { mathml } from './symbols.js';

/** @import { Formula, Leaf, Part } from './notation.js' */

/** A symbol with the dot of its rate. @param {Element} symbol */
function rate(symbol) {
  const dotted = mathml('mover', symbol, mathml('mo', '˙'));
  dotted.setAttribute('accent', 'true');
  return dotted;
}

/** (2) @type {Formula} */
export const motionFormula = {
  label: '(2)',
  build: (leaf) => [
    line(rate(leaf('x')), leaf('v'), dot, cos(leaf('theta'))),
    line(rate(leaf('y')), leaf('v'), dot, sin(leaf('theta'))),
    line(rate(leaf('theta')), leaf('w')),
  ],
};

/** (4) @type {Formula} */
export const errorRateFormula = {
  label: '(4)',
  build: (leaf) => [
    line(
      rate(leaf('xe')),
      leaf('ye'),
      dot,
      leaf('wr'),
      '+',
      leaf('vr'),
      '−',
      leaf('v'),
      dot,
      cos(leaf('te')),
    ),
    line(rate(leaf('ye')), '−', leaf('xe'), dot, leaf('wr'), '+', leaf('v'), dot, sin(leaf('te'))),
    line(rate(leaf('te')), leaf('wr'), '−', leaf('w')),
  ],
};

/** V̇ by the chain rule, for a goal at rest. @type {Formula} */
export const chainFormula = {
  label: '',
  build: (leaf) => [
    line(
      leaf('Vdot'),
      row(leaf('xe'), dot, rate(leaf('xe'))),
      '+',
      row(leaf('ye'), dot, rate(leaf('ye'))),
      '+',
      row(sin(leaf('te')), dot, rate(leaf('te'))),
    ),
    equally(
      row('−', leaf('xe'), dot, leaf('v'), dot, cos(leaf('te'))),
      '+',
      row(leaf('ye'), dot, leaf('v'), dot, sin(leaf('te'))),
      '−',
      row(sin(leaf('te')), dot, leaf('w')),
    ),
  ],
};

/** A term of V̇ with the law (5) put in, its sign before it, and with which other it cancels. @typedef {{ sign: string, parts: Part[], pair: 'kx' | 'ky' | null, of: 'x' | 'y' | 'theta' }} RateTerm */

/** From −x_e v cos θ_e, then from y_e v sin θ_e, then from −sin θ_e ω. @param {Leaf} leaf @returns {RateTerm[]} */
export const rateTerms = (leaf) => {
  const cross = () => [
    leaf('kx'),
    dot,
    leaf('xe'),
    dot,
    leaf('ye'),
    dot,
    sin(leaf('te')),
    dot,
    cos(leaf('te')),
  ];
  const steep = () => [
    leaf('ky'),
    dot,
    frac(row(leaf('xe'), dot, sup(leaf('ye'), '3'), dot, cos(leaf('te'))), sin(leaf('te'))),
  ];
  return [
    {
      sign: '−',
      parts: [leaf('kx'), dot, sup(leaf('xe'), '2'), dot, cos(leaf('te'), '2')],
      pair: null,
      of: 'x',
    },
    { sign: '+', parts: steep(), pair: 'ky', of: 'y' },
    { sign: '+', parts: cross(), pair: 'kx', of: 'x' },
    { sign: '−', parts: [leaf('ky'), dot, sup(leaf('ye'), '4')], pair: null, of: 'y' },
    { sign: '−', parts: [leaf('kt'), dot, sin(leaf('te'), '2')], pair: null, of: 'theta' },
    { sign: '−', parts: steep(), pair: 'ky', of: 'y' },
    { sign: '−', parts: cross(), pair: 'kx', of: 'x' },
  ];
};

/** What the seven terms come to. @param {readonly [number, number, number]} gains @param {{ x: number, y: number, theta: number }} error */
export function rateAmounts([kx, ky, kt], { x, y, theta }) {
  const [s, c] = [Math.sin(theta), Math.cos(theta)];
  const steep = (ky * x * y ** 3 * c) / s;
  const cross = kx * x * y * s * c;
  return [-kx * x * x * c * c, steep, cross, -ky * y ** 4, -kt * s * s, -steep, -cross];
}
