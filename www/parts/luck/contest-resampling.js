// What other seeds might have said: intervals by the bootstrap, and how often fewer seeds tell two searches apart. The draws are the
// same every time.
//
// Bootstrap: B. Efron, R. J. Tibshirani, “An Introduction to the Bootstrap”, 1993, chapter 13 (percentile interval).
/** @import { End } from './contest-statistics.js' */
import { spread } from '../../kit/hash.js';
import { compareEnds, expectedRunningTime, holm, rankSums } from './contest-statistics.js';

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

/**
 * The 95 % confidence interval of the expected running time (percentile bootstrap): between which values it lies in 95 of 100 sets of
 * runs that are drawn from these with replacement.
 * @param {readonly number[]} runtimes @param {number} budget @returns {[low: number, high: number]}
 */
export function runningTimeInterval(runtimes, budget) {
  const next = numbers(0);
  const times = Float64Array.from({ length: resamples }, () => {
    const drawn = runtimes.map(() => runtimes[Math.floor(next() * runtimes.length)]);
    return expectedRunningTime(drawn, budget);
  }).sort();
  const at = (/** @type {number} */ part) => times[Math.round(part * (resamples - 1))];
  return [at((1 - sure) / 2), at((1 + sure) / 2)];
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
    const own = endsOf(first);
    const ps = holm(others.map((ends) => rankSums(own, endsOf(ends), compareEnds).p));
    for (const [i, p] of ps.entries()) told[i] += Number(p < level);
  }
  return told;
}
