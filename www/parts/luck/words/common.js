// Of the luck part, what is the same in every language.
/** @import { SeedSurvey } from '../request.js' */
import { sameDigits } from '../../../kit/steps.js';
import { fixed, powerOfTen as shortPower, sixDigits } from '../../../words/numbers.js';

/** @typedef {'start' | 'goal' | 'limits' | 'settings'} Change */

/** Random search, beside which there is none. @param {SeedSurvey['experiment']} experiment */
export const isRandom = ({ evolution }) => evolution.method === 'random';

export const costSymbol = 'J';

/** @param {number} power */
export const powerOfTen = (power) => shortPower(power, -3);

export const gainNames = ['x', 'y', 'θ'].map((index) => `k${index}`);

/** @param {readonly number[]} ticks */
export const ticks = (ticks) =>
  ticks.some((tick) => Math.abs(tick) >= 1e4)
    ? sameDigits(ticks)
    : ticks.map((tick) => String(tick).replace('-', '−'));

/** @param {number} gain */
export const medianGain = (gain) => (Math.abs(gain) < 1000 ? fixed(gain, 3) : sixDigits(gain));

/** @type {Readonly<Record<SeedSurvey['experiment']['law'], readonly string[]>>} */
export const gainColumns = {
  'shim-kim': ['kx (1/s)', 'ky (1/(m² s))', 'kθ (rad/s)'],
  kanayama: ['kx (1/s)', 'ky (rad/m²)', 'kθ (rad/m)'],
};

/** @param {SeedSurvey} survey */
export const fileName = ({ first, runs, generations }) =>
  `seeds-${first}-to-${first + runs.length - 1}-${generations}-generations.csv`;

/** Digits enough to see the target move: four after the point, fewer where seven count. @param {number} target */
export const targetText = (target) =>
  fixed(target, Math.max(0, Math.min(4, 6 - Math.floor(Math.log10(Math.abs(target) || 1)))));

/** @param {{ seeds: number, budget: number }} contest */
export const contestFile = ({ seeds, budget }) => `contest-${seeds}-seeds-${budget}-drives.csv`;

/** In whole per cent; all, or none, only where it is. @param {number} part */
export const wholePercent = (part) =>
  part < 1 && part >= 0.995 ? '>99' : part > 0 && part < 0.005 ? '<1' : String(Math.round(100 * part));
/** @param {number} part */
export const percent = (part) => `${wholePercent(part)} %`;
/** A12, likewise. @param {number} part */
export const pairsText = (part) =>
  part < 1 && part >= 0.995 ? '>0.99' : part > 0 && part < 0.005 ? '<0.01' : part.toFixed(2);

/** As papers print it. @param {number} p */
export const probability = (p) => (p < 0.001 ? '< 0.001' : fixed(p, 3));

/** @param {number} times */
export const timesText = (times) => (times < 10 ? fixed(times, 1) : fixed(times, 0));
