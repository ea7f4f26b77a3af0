// The formulas of the paper that more than one step shows.
import { lawTerms } from '../core/rules.js';
import { birthOf, grownSigma, movedGain, ratesOf } from '../parts/generation/birth.js';
import words from '../parts/generation/words/index.js';
import { lab } from '../words/index.js';
import { degreesText, signed } from '../words/numbers.js';
import { anatomyOf, chosenIn } from './anatomy.js';
import {
  cos,
  dot,
  frac,
  further,
  integral,
  line,
  relation,
  row,
  sin,
  size,
  sub,
  sup,
  term,
  times,
} from './notation.js';

/** @import { Cost } from '../core/engine.js' */
/** @import { Formula, Leaf, Part } from './notation.js' */
/** @import { Live } from './page.js' */

/** The numbers that the law works with. @param {Pick<Live, 'sample' | 'gains'>} live */
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
      row(cos(leaf('tr')), times, '(', leaf('xr'), '−', leaf('xc'), ')'),
      '+',
      row(sin(leaf('tr')), times, '(', leaf('yr'), '−', leaf('yc'), ')'),
    ),
    line(
      leaf('ye'),
      '−',
      row(sin(leaf('tr')), times, '(', leaf('xr'), '−', leaf('xc'), ')'),
      '+',
      row(cos(leaf('tr')), times, '(', leaf('yr'), '−', leaf('yc'), ')'),
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

/**
 * What the terms of (5) are made of, by the gain that each has in it; of v, then of ω.
 * @param {Leaf} leaf
 */
export const partsOfLaw = (leaf) => ({
  linear: {
    kx: [leaf('kx'), dot, leaf('xe'), dot, cos(leaf('te'))],
    ky: [leaf('ky'), dot, frac(sup(leaf('ye'), '3'), sin(leaf('te')))],
  },
  angular: {
    kt: [leaf('kt'), dot, sin(leaf('te'))],
    ky: [
      leaf('ky'),
      dot,
      frac(row(leaf('xe'), times, sup(leaf('ye'), '3'), times, cos(leaf('te'))), sin(leaf('te'), '2')),
    ],
    kx: [leaf('kx'), dot, leaf('xe'), dot, leaf('ye'), dot, cos(leaf('te'))],
  },
});

/** (5) for a goal that stands still. @type {Formula} */
export const lawFormula = {
  label: '(5)',
  build(leaf) {
    const { linear, angular } = partsOfLaw(leaf);
    return [
      line(leaf('v'), term('kx', ...linear.kx), '−', term('ky', ...linear.ky)),
      line(leaf('w'), term('kt', ...angular.kt), '+', term('ky', ...angular.ky)),
      further('+', term('kx', ...angular.kx)),
    ];
  },
  numbers: ({ decided, gains }) => lawNumbers({ sample: decided, gains }),
};

/** A part of J, in its colour of the bar. @param {Exclude<keyof Cost, 'total'>} name @param {Part[]} parts */
const costPart = (name, ...parts) => {
  const group = term(name, ...parts);
  group.setAttribute('class', `part-${name}`);
  return group;
};
const transposed = (/** @type {Part} */ of) => sup(of, 'T');

/** (9); its parts in the order of the paper. @type {Formula} */
export const costFormula = {
  label: '(9)',
  build(leaf) {
    const gap = (/** @type {Part[]} */ ...at) => row('(', leaf('p'), ...at, '−', leaf('pr'), ')');
    return [
      line(
        leaf('J'),
        costPart('time', leaf('tf')),
        '+',
        costPart('finalError', transposed(gap('(', leaf('tf'), ')')), leaf('W'), gap('(', leaf('tf'), ')')),
      ),
      further(
        '+',
        frac('1', '2'),
        integral('0', leaf('tf')),
        row(
          '(',
          costPart('path', transposed(gap()), gap()),
          '+',
          costPart('energy', transposed(leaf('q')), leaf('R'), leaf('q')),
          ')',
        ),
        'd',
        leaf('t'),
      ),
      further(
        '+',
        costPart('penalty', leaf('kappa'), sub('∑', 'i'), 'max', '(', '0', ',', '−', leaf('ki'), ')'),
      ),
    ];
  },
  filled: (leaf) => [
    line(
      leaf('J'),
      costPart('time', leaf('time')),
      '+',
      costPart('finalError', leaf('finalError')),
      '+',
      costPart('path', leaf('path')),
      '+',
      costPart('energy', leaf('energy')),
      '+',
      costPart('penalty', leaf('penalty')),
    ),
  ],
  numbers({ scene }) {
    const { cost } = scene.driving;
    return {
      J: lab.costText(cost.total),
      ...Object.fromEntries(lab.costParts.map(([part]) => [part, lab.costText(cost[part])])),
    };
  },
};

/** (6) to (8), Theorem 2. @type {Formula} */
export const robustFormula = {
  label: '(6)–(8)',
  build: (leaf) => [
    relation(leaf('kx'), '>', frac(leaf('e1'), size(row(leaf('xe'), dot, cos(leaf('te')))))),
    relation(leaf('ky'), '>', frac(row(leaf('e1'), dot, size(sin(leaf('te')))), sup(size(leaf('ye')), '3'))),
    relation(leaf('kt'), '>', frac(leaf('e2'), size(sin(leaf('te'))))),
  ],
  numbers({ sample, gains, scene }) {
    const { linear, angular } = scene.experiment.disturbance;
    return {
      kx: signed(gains[0], 3),
      ky: signed(gains[1], 3),
      kt: signed(gains[2], 3),
      e1: signed(Math.abs(linear), 3),
      e2: signed(Math.abs(angular), 3),
      xe: signed(sample.error.x, 3),
      ye: signed(sample.error.y, 3),
      te: degreesText(sample.error.theta),
    };
  },
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
    const { base, child, draws } = birth;
    return named((i) => {
      const write = (/** @type {number} */ gain) => words.gainText(gain, base.sigmas[i]);
      return {
        k: write(base.gains[i]),
        s: words.sigmaText(base.sigmas[i]),
        N: words.drawText(draws.gains[i]),
        newk: words.cameFrom(write(child.gains[i]), write(movedGain(birth, i))),
      };
    });
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
    const { base, child, draws } = birth;
    const rates = ratesOf(live.engine.learningRates(), live.state.experiment.evolution.adaptation);
    return {
      tau: words.drawText(rates.own),
      tau2: words.drawText(rates.common),
      N: words.drawText(draws.common),
      ...named((i) => ({
        s: words.sigmaText(base.sigmas[i]),
        N: words.drawText(draws.sigmas[i]),
        news: words.cameFrom(words.sigmaText(child.sigmas[i]), words.sigmaText(grownSigma(birth, i, rates))),
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
      term('xe', frac('1', '2'), times, sup(leaf('xe'), '2')),
      '+',
      term('ye', frac('1', '2'), times, sup(leaf('ye'), '2')),
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
      '−',
      term('xe', leaf('kx'), dot, sup(leaf('xe'), '2'), dot, cos(leaf('te'), '2')),
      '−',
      term('ye', leaf('ky'), dot, sup(leaf('ye'), '4')),
    ),
    further('−', term('te', leaf('kt'), dot, sin(leaf('te'), '2'))),
  ],
  numbers: (live) => {
    const { error } = live.sample;
    const isSomewhere = [error.x, error.y, error.theta].every(Number.isFinite);
    const { promised } = isSomewhere ? lawTerms({ law: 'shim-kim' }, live.gains, error) : { promised: null };
    const rate = promised ? promised.x + promised.y + promised.theta : Number.NaN;
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
