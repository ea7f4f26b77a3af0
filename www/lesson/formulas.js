// The formulas of the paper that more than one step shows.
import { generation as words } from '../words/index.js';
import { degreesText, signed } from '../words/numbers.js';
import { anatomyOf, birthOf, chosenIn } from './anatomy.js';
import { cos, dot, frac, further, line, row, sin, sup, term } from './notation.js';

/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('./notation.js').Formula} Formula */

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

/** (3) @type {Formula} */
export const errorFormula = {
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
};

/** (5) for a goal that stands still. @type {Formula} */
export const lawFormula = {
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
};

/** Step 3 of the paper's procedure, first half: how the gains of a parent become those of its offspring. @type {Formula} */
export const gainFormula = {
  label: '',
  build: (leaf) => [
    line(leaf('newkx'), leaf('kx'), '+', leaf('sx'), dot, leaf('Nx')),
    line(leaf('newky'), leaf('ky'), '+', leaf('sy'), dot, leaf('Ny')),
    line(leaf('newkt'), leaf('kt'), '+', leaf('st'), dot, leaf('Nt')),
  ],
  numbers(live) {
    const anatomy = anatomyOf(live);
    const birth = birthOf(anatomy, chosenIn(live) % anatomy.count);
    if (!birth) return {};
    const { parent, child, draws } = birth;
    return named((i) => ({
      k: words.gainText(parent.gains[i], parent.sigmas[i]),
      s: words.sigmaText(parent.sigmas[i]),
      N: words.bracketed(words.drawText(draws.gains[i])),
      newk: words.gainText(child.gains[i], parent.sigmas[i]),
    }));
  },
};

/** The second half: how the step sizes change. With the numbers of the best ranked parent and its offspring. @type {Formula} */
export const sigmaFormula = {
  label: '',
  build: (leaf) => {
    const grown = (/** @type {Element} */ draw) =>
      sup('e', row(leaf('tau2'), dot, leaf('N'), '+', leaf('tau'), dot, draw));
    return [
      line(leaf('newsx'), leaf('sx'), dot, grown(leaf('Nx'))),
      line(leaf('newsy'), leaf('sy'), dot, grown(leaf('Ny'))),
      line(leaf('newst'), leaf('st'), dot, grown(leaf('Nt'))),
    ];
  },
  numbers(live) {
    const birth = birthOf(anatomyOf(live), 0);
    if (!birth) return {};
    const { parent, child, draws } = birth;
    const rates = live.engine.learningRates();
    const draw = (/** @type {number} */ value) => words.bracketed(words.drawText(value));
    return {
      tau: words.drawText(rates.own),
      tau2: words.drawText(rates.common),
      N: draw(draws.common),
      ...named((i) => ({
        s: words.sigmaText(parent.sigmas[i]),
        N: draw(draws.sigmas[i]),
        news: words.sigmaText(child.sigmas[i]),
      })),
    };
  },
};

/** The measure of the whole error. @type {Formula} */
export const lyapunovFormula = {
  label: '',
  build: (leaf) => [
    line(
      leaf('V'),
      term('xe', frac('1', '2'), sup(leaf('xe'), '2')),
      '+',
      term('ye', frac('1', '2'), sup(leaf('ye'), '2')),
      '+',
      term('te', '(', '1', '−', cos(leaf('te')), ')'),
    ),
  ],
  numbers: (live) => ({ ...lawNumbers(live), V: signed(live.sample.lyapunov, 3) }),
};

/** How fast it falls, as the law promises. @type {Formula} */
export const rateFormula = {
  label: '',
  build: (leaf) => [
    line(
      leaf('Vdot'),
      term('xe', '−', leaf('kx'), dot, sup(leaf('xe'), '2'), dot, sup(cos(leaf('te')), '2')),
    ),
    further(
      term('ye', '−', leaf('ky'), dot, sup(leaf('ye'), '4')),
      term('te', '−', leaf('kt'), dot, sup(sin(leaf('te')), '2')),
    ),
  ],
  numbers: (live) => {
    const { x, y, theta } = live.sample.error;
    const [kx, ky, kt] = live.gains;
    const rate = -kx * (x * Math.cos(theta)) ** 2 - ky * y ** 4 - kt * Math.sin(theta) ** 2;
    return { ...lawNumbers(live), Vdot: signed(rate, 3) };
  },
};

/** The texts of each gain under the names of its symbols. @param {(i: number) => Record<string, string>} textsOf @returns {Record<string, string>} */
const named = (textsOf) =>
  Object.fromEntries(
    ['x', 'y', 't'].flatMap((index, i) =>
      Object.entries(textsOf(i)).map(([letter, text]) => [`${letter}${index}`, text]),
    ),
  );
