// How the robot and its errors move, and what becomes of V when the law is put in.
import { lawTerms } from '../../core/rules.js';

/** @import { Triple } from '../../core/engine.js' */
/** @import { Formula } from './notation.js' */

/** (2) @type {Formula} */
export const motionFormula = {
  label: '(2)',
  lines: ["x' = v · cos theta", "y' = v · sin theta", "theta' = w"],
};

/** (4) @type {Formula} */
export const errorRateFormula = {
  label: '(4)',
  lines: ["xe' = ye · wr + vr − v · cos te", "ye' = − xe · wr + v · sin te", "te' = wr − w"],
};

/** V̇ by the chain rule, for a goal at rest. @type {Formula} */
export const chainFormula = {
  label: '',
  lines: [
    "Vdot = {xe · xe'} + {ye · ye'} + {sin te · te'}",
    '= {− xe · v · cos te} + {ye · v · sin te} − {sin te · w}',
  ],
};

/** A term of V̇ with the law (5) put in, its sign before it, and with which other it cancels. @typedef {{ text: string, pair: 'kx' | 'ky' | null, of: 'x' | 'y' | 'theta' }} RateTerm */

const steep = 'ky · {xe · ye^3 · cos te} / sin te';
const cross = 'kx · xe · ye · sin te · cos te';

/** From −x_e v cos θ_e, then from y_e v sin θ_e, then from −sin θ_e ω. @type {readonly RateTerm[]} */
export const rateTerms = [
  { text: '− kx · xe^2 · cos^2 te', pair: null, of: 'x' },
  { text: `+ ${steep}`, pair: 'ky', of: 'y' },
  { text: `+ ${cross}`, pair: 'kx', of: 'x' },
  { text: '− ky · ye^4', pair: null, of: 'y' },
  { text: '− kt · sin^2 te', pair: null, of: 'theta' },
  { text: `− ${steep}`, pair: 'ky', of: 'y' },
  { text: `− ${cross}`, pair: 'kx', of: 'x' },
];

/** What the seven terms come to, where the law guards its division, too. @param {Triple} gains @param {{ x: number, y: number, theta: number }} error */
export function rateAmounts(gains, error) {
  const { x, y, theta } = error;
  const nowhere = rateTerms.map(() => Number.NaN);
  if (![x, y, theta].every(Number.isFinite)) return nowhere;
  const { command, promised } = lawTerms({ law: 'shim-kim' }, gains, error);
  if (!promised) return nowhere;
  const steep = -x * Math.cos(theta) * command.ky.linear;
  const cross = y * Math.sin(theta) * command.kx.linear;
  return [promised.x, steep, cross, promised.y, promised.theta, -steep, -cross];
}
