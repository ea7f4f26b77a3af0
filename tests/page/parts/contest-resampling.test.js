// What other seeds might have said, against brute force.
import assert from 'node:assert/strict';
import {
  draws,
  factorOf,
  intervalOf,
  resampledTimes,
  someOf,
  toldApart,
} from '../../../www/parts/luck/contest-resampling.js';
import {
  compareEnds,
  expectedRunningTime,
  rankSums,
  shareOfTargets,
} from '../../../www/parts/luck/contest-statistics.js';
import { test } from '../harness/once.js';

/** @param {readonly number[]} runtimes @param {number} budget */
const runningTimeInterval = (runtimes, budget) => intervalOf(resampledTimes(runtimes, budget));

test('the interval is that of every sample one can draw, where these can be counted', () => {
  const runtimes = [10, 40, 100, Infinity];
  const budget = 200;
  /** @type {number[]} */
  const all = [];
  for (const a of runtimes)
    for (const b of runtimes)
      for (const c of runtimes) for (const d of runtimes) all.push(expectedRunningTime([a, b, c, d], budget));
  all.sort((x, y) => x - y);
  // How many of all samples lie below: near 2.5 in 100, and near 97.5.
  const [low, high] = runningTimeInterval(runtimes, budget);
  const below = (/** @type {number} */ value) => all.filter((one) => one < value).length / all.length;
  const upTo = (/** @type {number} */ value) => all.filter((one) => one <= value).length / all.length;
  assert.ok(below(low) <= 0.035 && upTo(low) >= 0.015, `${low}: ${below(low)} to ${upTo(low)}`);
  assert.ok(below(high) <= 0.985 && upTo(high) >= 0.965, `${high}: ${below(high)} to ${upTo(high)}`);
});

test('what is certain has no interval, and what was never reached none that ends', () => {
  assert.deepEqual(runningTimeInterval([7, 7, 7], 100), [7, 7]);
  assert.deepEqual(runningTimeInterval([Infinity, Infinity], 100), [Infinity, Infinity]);
  assert.equal(runningTimeInterval([5, Infinity, Infinity, Infinity], 100)[1], Infinity);
});

test('a factor is told where seed by seed it is sure, and not where it may be none or has no end', () => {
  const slow = Array.from({ length: 20 }, (_, i) => 100 + ((37 * i) % 90));
  const halves = slow.map((time) => time / 2);
  const [more, fewer] = [slow, halves].map((runtimes) => resampledTimes(runtimes, 1000));
  // With the same seeds the one takes twice as long as the other, whichever are drawn.
  assert.deepEqual(factorOf(more, fewer, 2), { times: 2, between: [2, 2] });
  const others = resampledTimes([...slow].reverse(), 1000);
  assert.equal(factorOf(more, others, 1.01), null);
  const rare = resampledTimes([150, ...slow.slice(1).fill(Infinity)], 1000);
  assert.equal(factorOf(rare, fewer, 100), null);
});

test('the first draw is of the first seeds; in others each seed is as often, and none twice', () => {
  const seeds = Array.from({ length: 20 }, (_, i) => i + 1);
  assert.deepEqual(someOf(seeds, 5, 0), [1, 2, 3, 4, 5]);
  assert.deepEqual(someOf(seeds, 20, 7), seeds);
  const counts = new Map(seeds.map((seed) => [seed, 0]));
  const times = 2000;
  for (let draw = 1; draw <= times; draw += 1) {
    const drawn = someOf(seeds, 5, draw);
    assert.equal(new Set(drawn).size, 5);
    for (const seed of drawn) counts.set(seed, (counts.get(seed) ?? 0) + 1);
  }
  // Each in a quarter of the draws, within five deviations.
  for (const [seed, count] of counts)
    assert.ok(Math.abs(count - times / 4) < 5 * Math.sqrt((times * 3) / 16), `${seed}: ${count}`);
});

test('how often fewer seeds tell is counted draw by draw', () => {
  const endsOf = (/** @type {(seed: number) => number} */ runtimeOf) =>
    new Map(Array.from({ length: 30 }, (_, i) => [i + 1, { runtime: runtimeOf(i + 1), cost: 1 }]));
  const first = endsOf((seed) => 100 + ((37 * seed) % 60));
  const other = endsOf((seed) => 80 + ((53 * seed) % 60));
  let told = 0;
  for (let draw = 1; draw <= draws; draw += 1) {
    const drawn = someOf([...first.keys()], 8, draw);
    const pick = (/** @type {typeof first} */ ends) =>
      drawn.map((seed) => /** @type {{ runtime: number, cost: number }} */ (ends.get(seed)));
    told += Number(rankSums(pick(first), pick(other), compareEnds).p < 0.05);
  }
  assert.ok(told > 5 && told < 95, `${told}`);
  assert.deepEqual(toldApart(first, [other], 8), [told]);
  // With a second line p is Holm's: it is told no more often.
  assert.ok(toldApart(first, [other, first], 8)[0] <= told);
  assert.equal(toldApart(first, [first], 8)[0], 0);
});

test('the share of many targets is that of all pairs of a run and a target', () => {
  const runs = [
    { drives: [1, 4, 9], costs: [10, 5, 1] },
    { drives: [2, 3], costs: [8, 4] },
  ];
  const targets = [9, 6, 4, 2];
  for (let drive = 0; drive <= 10; drive += 1) {
    const pairs = runs.flatMap(({ drives, costs }) =>
      targets.map((target) => drives.some((when, i) => when <= drive && costs[i] <= target)),
    );
    assert.equal(
      shareOfTargets(runs, targets, drive),
      pairs.filter(Boolean).length / pairs.length,
      `${drive}`,
    );
  }
});
