// What other seeds might have said: intervals by the bootstrap, and how often fewer seeds tell two searches apart. The draws are the
// same every time.
//
// Bootstrap: B. Efron, R. J. Tibshirani, “An Introduction to the Bootstrap”, 1993, chapter 13 (percentile interval).
/** @import { End } from './contest-statistics.js' */
import { spread } from '../../kit/hash.js';
import { remember } from '../../kit/memo.js';
import { compareEnds, exactTest, expectedRunningTime, holm, rankSums } from './contest-statistics.js';

const resamples = 1000;
const sure = 0.95;
/** So many draws of fewer seeds. */
export const draws = 100;
/** What can be told is less probable by chance. */
export const level = 0.05;

/** Numbers from 0 to 1 that look random: the finaliser of MurmurHash3 on a counter. @param {number} seed */
function numbers(seed) {
  let count = Math.imul(seed, 0x9e3779b9);
  return () => {
    count = (count + 0x6d2b79f5) | 0;
    return spread(count) / 2 ** 32;
  };
}

/** Which of so many are drawn, one set after the other. */
const drawnOf = remember((/** @type {number} */ count) => {
  const next = numbers(0);
  return Uint32Array.from({ length: resamples * count }, () => next() * count);
});

/**
 * The expected running times of sets of runs that are drawn from these with replacement; of two searches with the same seeds the same
 * ones are drawn.
 * @param {readonly number[]} runtimes @param {number} budget
 */
export function resampledTimes(runtimes, budget) {
  const drawn = drawnOf(runtimes.length);
  const set = new Float64Array(runtimes.length);
  return Float64Array.from({ length: resamples }, (_, i) => {
    for (let k = 0; k < set.length; k += 1) set[k] = runtimes[drawn[i * set.length + k]];
    return expectedRunningTime(set, budget);
  });
}

/** The 95 % confidence interval of what was drawn so (percentile bootstrap). @param {Float64Array} values @returns {[low: number, high: number]} */
export function intervalOf(values) {
  const sorted = values.slice().sort();
  const at = (/** @type {number} */ part) => sorted[Math.round(part * (values.length - 1))];
  return [at((1 - sure) / 2), at((1 + sure) / 2)];
}

/**
 * By what factor the one needs more drives than the other, with its interval; null where that does not end, or may be 1.
 * @param {Float64Array} more Resampled. @param {Float64Array} fewer @param {number} times
 */
export function factorOf(more, fewer, times) {
  const [low, high] = intervalOf(more.map((time, i) => time / fewer[i]));
  return low > 1 && high < Infinity ? { times, between: /** @type {const} */ ([low, high]) } : null;
}

/** So many of the seeds: with draw 0 the first ones, with each other draw others. @param {readonly number[]} seeds @param {number} count @param {number} draw */
export function someOf(seeds, count, draw) {
  if (draw === 0 || count >= seeds.length) return seeds.slice(0, count);
  const next = numbers(draw);
  const left = [...seeds];
  const taken = Array.from({ length: count }, () => {
    const [one] = left.splice(Math.floor(next() * left.length), 1);
    return one;
  });
  return taken.sort((a, b) => a - b);
}

/**
 * Against the first: `a12` is how probable it is that a run of this one is the better one, `p` that of the ranks, and `share` that of how
 * many get there. What one asks of several is Holm's; `alone` is the p of the ranks without. `side`: above 0 where it is better beyond
 * chance, in pairs or else in how often it gets there; below 0 where worse.
 * @typedef {{ a12: number, p: number, share: number, alone: number, side: number }} Comparison
 */

/** @param {readonly End[]} ends */
const reachedOf = (ends) => ends.filter(({ runtime }) => runtime < Infinity).length;

/** @param {{ a12: number, p: number, share: number }} found @param {number} more How much oftener it gets there. */
function sideOf({ a12, p, share }, more) {
  if (p < level) return Math.sign(a12 - 0.5);
  return share < level ? Math.sign(more) : 0;
}

/** Each of the others against the first. @param {readonly End[]} first @param {readonly (readonly End[])[]} others @returns {Comparison[]} */
export function comparisonsOf(first, others) {
  const ranks = others.map((ends) => rankSums(first, ends, compareEnds));
  const ps = holm(ranks.map(({ p }) => p));
  const own = reachedOf(first);
  const reached = others.map(reachedOf);
  const shares = holm(others.map((ends, i) => exactTest(own, first.length, reached[i], ends.length)));
  return ranks.map(({ a12, p }, i) => {
    const found = { a12, p: ps[i], share: shares[i], alone: p };
    return { ...found, side: sideOf(found, reached[i] / others[i].length - own / first.length) };
  });
}

/** @typedef {ReadonlyMap<number, End>} EndsBySeed */

/**
 * In how many of 100 draws of so many seeds each search is told apart from the first, by the same rule as with all.
 * @param {EndsBySeed} first @param {readonly EndsBySeed[]} others @param {number} count @returns {number[]}
 */
export function toldApart(first, others, count) {
  const seeds = [...first.keys()];
  const told = others.map(() => 0);
  for (let draw = 1; draw <= draws; draw += 1) {
    const drawn = someOf(seeds, count, draw);
    const endsOf = (/** @type {EndsBySeed} */ ends) => drawn.flatMap((seed) => ends.get(seed) ?? []);
    const compared = comparisonsOf(endsOf(first), others.map(endsOf));
    for (const [i, { side }] of compared.entries()) told[i] += Number(side !== 0);
  }
  return told;
}
