// The formulas of the paper that more than one step shows.
import { lawTerms } from '../../core/rules.js';
import { birthOf, grownSigma, movedGain, ratesOf } from '../../parts/generation/birth.js';
import words from '../../parts/generation/words/index.js';
import { lab } from '../../words/index.js';
import { degreesText, signed } from '../../words/numbers.js';
import { anatomyOf, chosenIn } from '../anatomy.js';
/** @import { Sample, Triple } from '../../core/engine.js' */
/** @import { Formula } from './notation.js' */
/** @import { Live } from '../page.js' */

/** @param {Pick<Sample, 'error'>} sample @param {number} digits */
export const errorNumbers = ({ error: { x, y, theta } }, digits) => ({
  xe: signed(x, digits),
  ye: signed(y, digits),
  te: degreesText(theta),
});

/** @param {Triple} gains @param {number} digits */
const gainNumbers = (gains, digits) => named((i) => ({ k: signed(gains[i], digits) }));

/** Another rule may drive, of which these formulas say nothing. @param {Pick<Live, 'state'>} live */
const isTheLaw = ({ state }) => state.experiment.law === 'shim-kim';

/** The numbers that the law works with. @param {Pick<Live, 'sample' | 'gains' | 'state'>} live */
function lawNumbers({ sample, gains, state }) {
  const { linear, angular } = sample.command;
  return {
    ...errorNumbers(sample, 2),
    ...gainNumbers(gains, 2),
    ...(isTheLaw({ state }) && { v: signed(linear, 2), w: signed(angular, 2) }),
  };
}

/** (3) @type {Formula} */
export const errorFormula = {
  label: '(3)',
  lines: [
    'xe = {cos tr * (xr − xc)} + {sin tr * (yr − yc)}',
    'ye = − {sin tr * (xr − xc)} + {cos tr * (yr − yc)}',
    'te = tr − tc',
  ],
  numbers: ({ sample }) => ({
    ...errorNumbers(sample, 2),
    xr: signed(sample.reference.x, 2),
    yr: signed(sample.reference.y, 2),
    tr: degreesText(sample.reference.theta),
    xc: signed(sample.posture.x, 2),
    yc: signed(sample.posture.y, 2),
    tc: degreesText(sample.posture.theta),
  }),
};

/** The terms of (5), by the gain that each has in it; of v, then of ω. */
export const termsOfLaw = {
  linear: { kx: 'kx · xe · cos te', ky: 'ky · ye^3 / sin te' },
  angular: {
    kt: 'kt · sin te',
    ky: 'ky · {xe * ye^3 * cos te} / sin^2 te',
    kx: 'kx · xe · ye · cos te',
  },
};
const { linear, angular } = termsOfLaw;

/** (5) for a goal that stands still. @type {Formula} */
export const lawFormula = {
  label: '(5)',
  lines: [
    `v = [kx: ${linear.kx}] − [ky: ${linear.ky}]`,
    `w = [kt: ${angular.kt}] + [ky: ${angular.ky}]`,
    `+ [kx: ${angular.kx}]`,
  ],
  numbers: (live) => lawNumbers({ ...live, sample: live.decided }),
};

/** (9); its parts in the order of the paper. @type {Formula} */
export const costFormula = {
  label: '(9)',
  lines: [
    'J = [time: tf] + [finalError: {(p(tf) − pr)}^T W {(p(tf) − pr)}]',
    '+ 1/2 ∫_0^tf {([path: {(p − pr)}^T {(p − pr)}] + [energy: q^T R q])} d t',
    '+ [penalty: kappa ∑_i max(0, − ki)]',
  ],
  filled: [
    'J = [time: time] + [finalError: finalError] + [path: path] + [energy: energy] + [penalty: penalty]',
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
  lines: ['kx > e1 / |{xe · cos te}|', 'ky > {e1 · |sin te|} / |ye|^3', 'kt > e2 / |sin te|'],
  numbers({ sample, gains, scene }) {
    const { kind, linear, angular } = scene.experiment.disturbance;
    const bound = (/** @type {number} */ push) => signed(kind === 'none' ? 0 : Math.abs(push), 3);
    return {
      ...gainNumbers(gains, 3),
      e1: bound(linear),
      e2: bound(angular),
      ...errorNumbers(sample, 3),
    };
  },
};

/** Step 3 of the paper's procedure, first half: how the gains of a parent become those of its offspring. @type {Formula} */
export const gainFormula = {
  label: '',
  lines: ['newkx = kx + sx · Nx', 'newky = ky + sy · Ny', 'newkt = kt + st · Nt'],
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
  lines: [
    'newsx = sx · e^{tau2 · N + tau · N2x}',
    'newsy = sy · e^{tau2 · N + tau · N2y}',
    'newst = st · e^{tau2 · N + tau · N2t}',
  ],
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
        N2: words.drawText(draws.sigmas[i]),
        news: words.cameFrom(words.sigmaText(child.sigmas[i]), words.sigmaText(grownSigma(birth, i, rates))),
      })),
    };
  },
};

/** The measure of the whole error. @type {Formula} */
export const lyapunovFormula = {
  label: '',
  lines: ['V = [xe: 1/2 * xe^2] + [ye: 1/2 * ye^2] + [te: (1 − cos te)]'],
  numbers: (live) => ({ ...lawNumbers(live), V: signed(live.sample.lyapunov, 3) }),
};

/** How fast it falls, as the law promises. @type {Formula} */
export const rateFormula = {
  label: '',
  lines: ['Vdot = − [xe: kx · xe^2 · cos^2 te] − [ye: ky · ye^4]', '− [te: kt · sin^2 te]'],
  numbers: (live) => {
    const { error } = live.sample;
    if (!isTheLaw(live)) return lawNumbers(live);
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
