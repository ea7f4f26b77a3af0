// The statistics of the contest against brute force: pairs, permutations, steps.
import assert from 'node:assert/strict';
import {
  compareEnds,
  costAt,
  exactTest,
  expectedRunningTime,
  holm,
  rankSums,
  runtimeOf,
  shareAt,
  twoSided,
} from '../../../www/parts/luck/contest-statistics.js';
import { test } from '../harness/once.js';
import { createChance } from '../share/any-drive.js';

const ascending = (/** @type {number} */ a, /** @type {number} */ b) => a - b;

/** @param {readonly number[]} first @param {readonly number[]} others */
function byPairs(first, others) {
  let points = 0;
  for (const a of first) for (const b of others) points += b < a ? 1 : b === a ? 0.5 : 0;
  return points / (first.length * others.length);
}

/** Every choice of so many of the places. @param {number} count @param {number} from @param {number} end @returns {number[][]} */
const choices = (count, from, end) =>
  count === 0
    ? [[]]
    : Array.from({ length: Math.max(0, end - from) }, (_, i) => from + i).flatMap((place) =>
        choices(count - 1, place + 1, end).map((rest) => [place, ...rest]),
      );

/** How often ranks are as uneven when the runs are dealt in every way. @param {readonly number[]} first @param {readonly number[]} others */
function byPermutation(first, others) {
  const all = [...first, ...others];
  const unevenness = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    Math.abs(byPairs(a, b) - 0.5) + 1e-12;
  const own = unevenness([...first], [...others]) - 2e-12;
  const deals = choices(first.length, 0, all.length);
  const uneven = deals.filter((places) => {
    const rest = all.filter((_, i) => !places.includes(i));
    return (
      unevenness(
        places.map((i) => all[i]),
        rest,
      ) >= own
    );
  });
  return uneven.length / deals.length;
}

test('A12 is the share of pairs in which the other one is better, with halves for equals', () => {
  const next = createChance(1);
  for (let round = 0; round < 60; round += 1) {
    // Few values, so that many are equal.
    const some = () => Array.from({ length: 1 + Math.floor(9 * next()) }, () => Math.floor(6 * next()));
    const [first, others] = [some(), some()];
    const { a12 } = rankSums(first, others, ascending);
    assert.ok(Math.abs(a12 - byPairs(first, others)) < 1e-12, `${first} against ${others}`);
    assert.ok(Math.abs(a12 + rankSums(others, first, ascending).a12 - 1) < 1e-12);
  }
});

test('p is near the share of all permutations that are as uneven', () => {
  const next = createChance(2);
  for (const levels of [1e9, 8])
    for (let round = 0; round < 12; round += 1) {
      const some = (/** @type {number} */ count, /** @type {number} */ shift) =>
        Array.from({ length: count }, () => Math.floor(levels * (next() + shift)));
      const [first, others] = [some(7, 0), some(7, 0.1 * round)];
      const { p } = rankSums(first, others, ascending);
      const exact = byPermutation(first, others);
      assert.ok(Math.abs(p - exact) < 0.03, `${first} against ${others}: ${p}, exactly ${exact}`);
    }
});

const known = /** @type {const} */ ([
  [[1, 2, 3, 4, 5, 6, 7], [4, 5, 6, 7, 8, 9, 10, 11], 0.02352559867843019],
  [[1, 1, 2, 2, 3, 3, 3, 5], [2, 3, 3, 4, 4, 5, 5, 5, 6], 0.03036834144289301],
  [
    [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1],
    [2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
    0.0001241544606016335,
  ],
]);

test('p of known samples is what SciPy 1.17.1 says (mannwhitneyu, method="asymptotic")', () => {
  for (const [first, others, expected] of known) {
    const { p } = rankSums([...first], [...others], ascending);
    assert.ok(Math.abs(p / expected - 1) < 1e-12, `${p} is not ${expected}`);
  }
});

test('what is equal cannot be told apart', () => {
  assert.deepEqual(rankSums([3, 3, 3], [3, 3], ascending), { a12: 0.5, p: 1 });
  assert.deepEqual(rankSums([1], [2], ascending), { a12: 0, p: 1 });
});

test('the normal tails are those of the tables, near and far', () => {
  for (const [z, p] of [
    [0, 1],
    [1.959963984540054, 0.05],
    [2.9999, 0.00270068256590985],
    [3.0001, 0.0026989098265214344],
    [6, 1.973175290075389e-9],
  ])
    assert.ok(Math.abs(twoSided(z) / p - 1) < 1e-12, `${z}: ${twoSided(z)}`);
});

test('Fisher’s p is the share of all ways to deal out who gets there that are no likelier', () => {
  const near = (/** @type {number} */ found, /** @type {number} */ expected) =>
    assert.ok(Math.abs(found - expected) < 1e-9, `${found} is not ${expected}`);
  const [count, otherCount] = [5, 6];
  const ones = (/** @type {number} */ set) => [...set.toString(2)].filter((bit) => bit === '1').length;
  // Of each set of eleven runs that are there: how many of them are among the first five.
  const sets = Array.from({ length: 2 ** (count + otherCount) }, (_, set) => [
    ones(set),
    ones(set % 2 ** count),
  ]);
  for (let reached = 0; reached <= count; reached += 1)
    for (let others = 0; others <= otherCount; others += 1) {
      const ways = new Array(count + 1).fill(0);
      for (const [all, first] of sets) if (all === reached + others) ways[first] += 1;
      const all = ways.reduce((sum, one) => sum + one, 0);
      const likely = ways.filter((one) => one <= ways[reached]).reduce((sum, one) => sum + one, 0);
      near(exactTest(reached, count, others, otherCount), likely / all);
    }
  // SciPy 1.17.1, fisher_exact.
  near(exactTest(1, 10, 11, 14), 0.0027594561852200836);
  near(exactTest(3, 4, 1, 4), 0.48571428571428565);
});

test('Holm multiplies the least p most, and never turns the order', () => {
  const near = (/** @type {number[]} */ found, /** @type {number[]} */ expected) =>
    assert.ok(
      found.every((p, i) => Math.abs(p - expected[i]) < 1e-12),
      `${found}`,
    );
  near(holm([0.01, 0.04, 0.03]), [0.03, 0.06, 0.06]);
  near(holm([0.5, 0.6]), [1, 1]);
  near(holm([0.02]), [0.02]);
  assert.deepEqual(holm([]), []);
});

/** A run that comes down by chance. @param {() => number} next @param {number} budget */
function wildRun(next, budget) {
  /** @type {{ drives: number[], costs: number[] }} */
  const run = { drives: [], costs: [] };
  let best = Infinity;
  const all = Array.from({ length: budget }, () => Math.floor(1000 * next()));
  for (const [i, cost] of all.entries())
    if (cost < best) {
      best = cost;
      run.drives.push(i + 1);
      run.costs.push(cost);
    }
  return { run, all };
}

test('J, runtimes, their shares and the expected running time are counted drive by drive', () => {
  const next = createChance(3);
  const [budget, target] = [60, 20];
  const runs = Array.from({ length: 30 }, () => wildRun(next, budget));
  for (const { run, all } of runs)
    for (let drive = 0; drive <= budget; drive += 1)
      assert.equal(costAt(run, drive), Math.min(...all.slice(0, drive)));
  let [spent, reached] = [0, 0];
  const arrivals = new Array(budget + 1).fill(0);
  for (const { all } of runs)
    for (const [i, cost] of all.entries()) {
      spent += 1;
      if (cost > target) continue;
      reached += 1;
      arrivals[i + 1] += 1;
      break;
    }
  assert.ok(reached > 5 && reached < 30, 'some are there, some are not');
  const runtimes = runs.map(({ run }) => runtimeOf(run, target));
  for (const { run } of runs)
    for (let most = 0; most <= budget; most += 1) {
      const own = runtimeOf(run, target);
      assert.equal(runtimeOf(run, target, most), own <= most ? own : Infinity);
    }
  assert.equal(expectedRunningTime(runtimes, budget), spent / reached);
  let there = 0;
  for (let drive = 0; drive <= budget; drive += 1) {
    there += arrivals[drive];
    assert.equal(shareAt(runtimes, drive), there / runs.length);
  }
  assert.equal(expectedRunningTime([Infinity, Infinity], budget), Infinity);
});

test('the sooner run is better; of two that are not there, the lower', () => {
  const ends = [
    { runtime: 5, cost: 9 },
    { runtime: 7, cost: 1 },
    { runtime: Infinity, cost: 10 },
    { runtime: Infinity, cost: 11 },
    { runtime: Infinity, cost: Infinity },
  ];
  for (const [i, a] of ends.entries())
    for (const [j, b] of ends.entries()) assert.equal(Math.sign(compareEnds(a, b)), Math.sign(i - j));
  // At the target it is the drives that count.
  assert.equal(compareEnds({ runtime: 5, cost: 1 }, { runtime: 5, cost: 2 }), 0);
});
