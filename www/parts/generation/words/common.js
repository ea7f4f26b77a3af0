// Of the generation part, what is the same in every language.
/** @import { Anatomy } from '../record.js' */
import { sameDigits } from '../../../kit/steps.js';
import { costText, fixed, powerOfTen, powerText } from '../../../words/numbers.js';

/** Who drives beside the chosen one: so many are drawn of them all, which the chosen one is one of or not; null: nobody can arrive. @typedef {{ drawn: number, all: number, isAmong: boolean, arrived: number | null }} Others */

/** How J is written in a generation: with as many digits as tell most of its individuals apart. @param {Anatomy} anatomy @returns {(cost: number) => string} */
export function costWriter({ all }) {
  const costs = all.map(({ cost }) => cost).sort((a, b) => a - b);
  const spread = costs[Math.floor(costs.length / 2)] - costs[0];
  return costsApart(spread);
}

/** How J is written where a difference of this size is to be seen. @param {number} size @returns {(cost: number) => string} */
export function costsApart(size) {
  const digits = digitsFor(size);
  return (cost) => {
    if (cost < 100 || (digits > 3 && cost < 1e6)) return fixed(cost, digits);
    return cost >= 1e6 && cost < Infinity && size > 0
      ? powerText(cost, countingFor(cost, size))
      : costText(cost);
  };
}

/** As it is written elsewhere, unless two that differ would be the same. @param {number} a @param {number} b @param {(cost: number) => string} write */
export const tellingApart = (a, b, write) => (write(a) === write(b) ? costsApart(Math.abs(a - b)) : write);

/** The digits that count, of a cost that is written with a power of ten. @param {number} cost @param {number} size */
const countingFor = (cost, size) =>
  Math.min(12, Math.max(3, 2 + Math.floor(Math.log10(cost)) - Math.floor(Math.log10(size))));

/** The digits after the point that show a change of this size. @param {number} size */
export const digitsFor = (size) =>
  size > 0 && Number.isFinite(size) ? Math.min(12, Math.max(3, 2 - Math.floor(Math.log10(size)))) : 3;

/** @param {number} value @param {number} [change] The size of what changes it. @param {number} [more] So many digits more than usual. */
export const gainText = (value, change = Math.abs(value), more = 0) =>
  value === 0 || (Math.abs(value) >= 1e-6 && Math.abs(value) < 1e5)
    ? fixed(value, digitsFor(change) + more)
    : powerText(value);

/** A strategy parameter, which may become very small. @param {number} value */
export const sigmaText = (value) => sigmaWith(value, 0);
/** @param {number} value @param {number} more So many digits more than usual. */
export const sigmaWith = (value, more) =>
  value >= 0.001 && value < 1000 ? fixed(value, digitsFor(value) + more) : powerText(value);

/** A draw from N(0, 1), or a rate. @param {number} value @param {number} [more] So many digits more than usual. */
export const drawText = (value, more = 0) => fixed(value, 3 + more);

/**
 * The numbers of an equation, with as many digits as it takes that they come, as written, to what is written behind them.
 * @param {readonly ((more: number) => string)[]} numbers @param {(...values: number[]) => number} come @param {string} result
 */
export function addingUp(numbers, come, result) {
  const digits = result.split('.')[1]?.length ?? 0;
  const told = [0, 1, 2, 3, 4, 5, 6].map((more) => numbers.map((write) => write(more)));
  const isRight = (/** @type {string[]} */ texts) =>
    fixed(come(...texts.map((text) => Number(text.replace('−', '-')))), digits) === result;
  return told.find(isRight) ?? told[0];
}

/** By how many wins chance was kind; as the wins that were expected, and are written beside it, let one reckon. @param {number} expected @param {number} wins */
export function luckSign(expected, wins) {
  const luck = Math.round(10 * (wins - Number(fixed(expected, 1)))) / 10;
  return luck === 0 ? '0' : `${luck < 0 ? '−' : '+'}${fixed(Math.abs(luck), 1)}`;
}

/** What is made of a number that may not be taken as it is. @param {string} from @param {string} to */
export const becomes = (from, to) => (from === to ? from : `${from} → ${to}`);

/** The same where what was made of it stands first. @param {string} to @param {string} from */
export const cameFrom = (to, from) => (to === from ? to : `${to} ← ${from}`);

/** In brackets, if it follows a × and begins with a minus. @param {string} text */
export const bracketed = (text) => (text.startsWith('−') ? `(${text})` : text);

export const costAxis = 'J';
/** Of what its numbers are multiples. @param {number} power */
export const costUnit = (power) => `×${powerOfTen(power, 0)}`;
/** @param {string} cost */
export const aboveText = (cost) => `${cost} ↑`;
export const won = '✓';
export const lost = '✗';
/** As the formulas call what a gain becomes. */
export const newGain = 'k′';
export const formula = {
  gain: { gaussian: 'kᵢ′ = kᵢ + σᵢ Nᵢ', cauchy: 'kᵢ′ = kᵢ + σᵢ Cᵢ' },
  sigma: 'σᵢ′ = σᵢ e',
  exponent: 'τ′N + τN′',
  index: 'i',
};

/** The three others in a trial of differential evolution. */
export const donorNames = ['a', 'b', 'c'];

/** From what others are how far away: whole where it is short, else an ellipsis stands for the rest of its digits. @param {number} value */
export function baseText(value) {
  const [whole] = sameDigits([value]);
  if (whole.length <= 7) return whole;
  return Math.abs(value) < 1e-3 ? powerText(value) : `${fixed(Math.trunc(value * 1e3) / 1e3, 3)}…`;
}

/** How far from a tick that is written out. @param {number} value */
export const awayText = (value) => `+${powerText(value, 2).replace(/^1×/, '')}`;

/** A step or a slope. @param {number} value */
export const signedText = (value) =>
  value < 0 ? `−${sigmaText(-value)}` : value === 0 ? '0' : `+${sigmaText(value)}`;

/** Whether the probes of a slope lie on one point in the picture, which has room for the step that they lead to. @param {Anatomy} anatomy */
export const areProbesOnePoint = ({ record: { next } }) =>
  next.steps?.every((step) => Math.abs(step) > 0.02) ?? false;

/** The place of the gain whose turn it is, one after the other from generation 1 on. @param {number} generation */
export const turnIn = (generation) => (generation - 1) % 3;

/** How many times as wide the one is as the other, in the mean of its axes. @param {{ axes: readonly (readonly number[])[] }} before @param {{ axes: readonly (readonly number[])[] }} after */
export const deviationRatio = (before, after) => {
  const volume = (/** @type {typeof after} */ { axes }) =>
    axes.reduce((product, axis) => product * Math.hypot(...axis), 1);
  const first = volume(before);
  // A point stays one.
  return first > 0 ? Math.cbrt(volume(after) / first) : 1;
};
