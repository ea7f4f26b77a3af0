// What the field says of searches that were run with many seeds, in drives (function evaluations).
//
// Fixed target, ERT and the ECDF of runtimes: N. Hansen, A. Auger, D. Brockhoff, T. Tušar, “Anytime performance assessment in
// blackbox optimization benchmarking”, IEEE Transactions on Evolutionary Computation 26(6), 2022; N. Hansen et al., “COCO: a
// platform for comparing continuous optimizers in a black-box setting”, Optimization Methods and Software 36(1), 2021.
// A12: A. Vargha, H. D. Delaney, “A critique and improvement of the CL common language effect size statistics of McGraw and
// Wong”, Journal of Educational and Behavioral Statistics 25(2), 2000.
// Rank sums: H. B. Mann, D. R. Whitney, Annals of Mathematical Statistics 18(1), 1947; their variance with ties and the correction
// for continuity as in E. L. Lehmann, “Nonparametrics”, 1975, section 1.4. Two shares: R. A. Fisher, “Statistical methods for research
// workers”, 1934, section 21.02. Many lines: S. Holm, Scandinavian Journal of Statistics 6(2), 1979.
import { bisectRight } from 'd3-array';

/** How a search came down: at which drives its best J fell, and to what. @typedef {{ drives: ArrayLike<number>, costs: ArrayLike<number> }} Descent */
/** A run as the ranks see it. @typedef {{ runtime: number, cost: number }} End */

/** The best J of the first so many drives; infinite before any was finite. @param {Descent} descent @param {number} drive */
export function costAt({ drives, costs }, drive) {
  const count = bisectRight(drives, drive);
  return count === 0 ? Infinity : costs[count - 1];
}

/** The runtime: the first drive whose J is at or below the target; infinite if there is none up to the budget. @param {Descent} descent @param {number} target @param {number} [budget] */
export function runtimeOf({ drives, costs }, target, budget = Infinity) {
  for (let i = 0; i < costs.length && drives[i] <= budget; i += 1) if (costs[i] <= target) return drives[i];
  return Infinity;
}

/**
 * The expected running time of COCO: how many drives it costs on average until the target is reached, if a run that has not
 * reached it by the budget is begun again with another seed. The drives of all runs, each until its target or the budget, by
 * the number of those that reached it; infinite if none did.
 * @param {Iterable<number>} runtimes @param {number} budget
 */
export function expectedRunningTime(runtimes, budget) {
  let [reached, spent] = [0, 0];
  for (const runtime of runtimes) {
    if (runtime <= budget) reached += 1;
    spent += Math.min(runtime, budget);
  }
  return reached === 0 ? Infinity : spent / reached;
}

/** The share of the runs that have reached the target after so many drives. @param {readonly number[]} runtimes @param {number} drive */
export const shareAt = (runtimes, drive) =>
  runtimes.filter((runtime) => runtime <= drive).length / runtimes.length;

/**
 * The share of all pairs of a run and a target that are reached after so many drives: the ECDF of COCO over many targets.
 * @param {readonly Descent[]} descents @param {readonly number[]} targets From the highest to the lowest. @param {number} drive
 */
export function shareOfTargets(descents, targets, drive) {
  const lowest = [...targets].reverse();
  const reached = descents.reduce((sum, descent) => {
    const cost = costAt(descent, drive);
    const first = lowest.findIndex((target) => target >= cost);
    return sum + (first < 0 ? 0 : lowest.length - first);
  }, 0);
  return reached / (descents.length * targets.length);
}

/**
 * Which of two runs is better, as COCO's rank-sum test has it: the one that reached the target sooner; of two that did not, the
 * one with the lower J at the budget. Below zero if the first is.
 * @param {End} a @param {End} b
 */
export function compareEnds(a, b) {
  if (a.runtime !== b.runtime) return a.runtime < b.runtime ? -1 : 1;
  if (a.runtime !== Infinity || a.cost === b.cost) return 0;
  return a.cost < b.cost ? -1 : 1;
}

/**
 * The ranks of all from 1 on, the best first; those that are equal share the mean of theirs. @template T
 * @param {readonly T[]} values @param {(a: T, b: T) => number} compare
 */
function ranksOf(values, compare) {
  const order = values.map((_, i) => i).sort((a, b) => compare(values[a], values[b]));
  const ranks = new Float64Array(values.length);
  /** How many share each rank. @type {number[]} */
  const ties = [];
  for (let from = 0; from < order.length; ) {
    let end = from + 1;
    while (end < order.length && compare(values[order[from]], values[order[end]]) === 0) end += 1;
    for (let i = from; i < end; i += 1) ranks[order[i]] = (from + 1 + end) / 2;
    ties.push(end - from);
    from = end;
  }
  return { ranks, ties };
}

/**
 * A12, how probable it is that a run of `others` is better than one of `first` (half of it if they are equal), and the
 * two-sided p of Mann and Whitney: how probable so uneven ranks are when both are the same search.
 * @template T
 * @param {readonly T[]} first @param {readonly T[]} others @param {(a: T, b: T) => number} compare
 */
export function rankSums(first, others, compare) {
  const [m, n] = [first.length, others.length];
  const { ranks, ties } = ranksOf([...first, ...others], compare);
  const sum = ranks.subarray(0, m).reduce((total, rank) => total + rank, 0);
  // Pairs in which the run of `others` is better.
  const u = sum - (m * (m + 1)) / 2;
  const all = m + n;
  const tied = ties.reduce((total, count) => total + count ** 3 - count, 0);
  const variance = ((m * n) / 12) * (all + 1 - tied / (all * (all - 1)));
  const away = Math.max(0, Math.abs(u - (m * n) / 2) - 0.5);
  return { a12: u / (m * n), p: variance > 0 ? twoSided(away / Math.sqrt(variance)) : 1 };
}

/**
 * How probable it is that a normal variable is so many standard deviations or more away from its mean, on either side: the series
 * of Φ near it (G. Marsaglia, Journal of Statistical Software 11(4), 2004), far away the continued fraction of Laplace.
 * @param {number} z From 0.
 */
export function twoSided(z) {
  const density = Math.exp((-z * z) / 2) / Math.sqrt(2 * Math.PI);
  if (z > 3) {
    let fraction = z;
    for (let i = 60; i > 0; i -= 1) fraction = z + i / fraction;
    return (2 * density) / fraction;
  }
  let [term, sum] = [z, z];
  for (let i = 3; term > 1e-18; i += 2) {
    term *= (z * z) / i;
    sum += term;
  }
  return 1 - 2 * density * sum;
}

/**
 * Fisher's exact test, two-sided: how probable shares are that are no likelier than these, when both are the same and as many of all
 * runs get there. Up to some 500 runs each.
 * @param {number} reached Of the first. @param {number} count @param {number} others Of the other. @param {number} otherCount
 */
export function exactTest(reached, count, others, otherCount) {
  const all = reached + others;
  const [least, most] = [Math.max(0, all - otherCount), Math.min(all, count)];
  // How likely each number of the first is, next to the least.
  const weights = [1];
  for (let n = least; n < most; n += 1)
    weights.push((weights[n - least] * (count - n) * (all - n)) / ((n + 1) * (otherCount - all + n + 1)));
  const sum = (/** @type {readonly number[]} */ some) => some.reduce((total, one) => total + one, 0);
  // Those that are equal are so up to rounding.
  const own = weights[reached - least] * (1 + 1e-9);
  return sum(weights.filter((weight) => weight <= own)) / sum(weights);
}

/** What becomes of several p, so that with all of them together one is below a level as seldom by chance as with one. @param {readonly number[]} ps */
export function holm(ps) {
  const order = ps.map((_, i) => i).sort((a, b) => ps[a] - ps[b]);
  const adjusted = new Array(ps.length).fill(1);
  let least = 0;
  for (const [rank, i] of order.entries()) {
    least = Math.max(least, Math.min(1, (ps.length - rank) * ps[i]));
    adjusted[i] = least;
  }
  return adjusted;
}
