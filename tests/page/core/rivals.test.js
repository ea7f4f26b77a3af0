// The core's searches beside published programs on the same J: what pycma and SciPy came to stands in tests/rivals/reference.json.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { trials } from '../../../pkg/ep_locomotion.js';
import { compareEnds, rankSums, runtimeOf } from '../../../www/parts/luck/contest-statistics.js';
import { Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment['evolution']} Settings */
/** @typedef {import('../../../www/parts/luck/contest-statistics.js').End} End */

/** @type {Record<string, { ends: number, runtimes: (number | null)[] }[]> & { simplex: number[][] }} */
const reference = JSON.parse(readFileSync(new URL('../../rivals/reference.json', import.meta.url), 'utf8'));
const base = experiment('velocity-limits');
const targets = [1.05, 1.01, 1.002].map((factor) => factor * 7.7012);

/** @typedef {ReturnType<typeof trials>} Trials */

/** The core's own trials of 51 seeds, each kind of them made once. @type {Map<string, Trials>} */
const made = new Map();

/** @param {Partial<Settings>} change @returns {Trials} */
function own(change) {
  const key = JSON.stringify(change);
  const evolution = { ...base.evolution, ...change };
  const found = made.get(key) ?? trials({ ...base, evolution }, { seeds: [1, 52], drives: 4000 });
  made.set(key, found);
  return found;
}

/** Their ends at one of the targets. @param {Partial<Settings>} change @param {number} target @returns {End[]} */
const endsOf = (change, target) =>
  own(change).map((trial) => ({ runtime: runtimeOf(trial, target), cost: trial.champion.cost }));

/** @param {string} name @param {number} index Of the target. @returns {End[]} */
const theirs = (name, index) =>
  reference[name].map(({ ends, runtimes }) => ({ runtime: runtimes[index] ?? Infinity, cost: ends }));

const pairs = /** @type {readonly (readonly [string, Partial<Settings>])[]} */ ([
  ['EP, from the paper', {}],
  ['EP, crossover 0.5 of gains and σ', { crossover: 0.5 }],
  ['EP, crossover 1 of gains and σ', { crossover: 1 }],
  ['DE rand/1/bin, F 0.5, CR 0.9 (SciPy)', { method: 'de' }],
  ['CMA-ES, 20 (pycma)', { method: 'cma-es' }],
  ['CMA-ES, 20, mirrored (pycma)', { method: 'cma-es', belowZero: 'mirror' }],
  ['CMA-ES, 7 (pycma)', { method: 'cma-es', population: 7 }],
  ['CMA-ES, 7, mirrored (pycma)', { method: 'cma-es', population: 7, belowZero: 'mirror' }],
  ['Nelder-Mead, begun anew (SciPy)', { method: 'nelder-mead' }],
  ['one at a time', { method: 'one-at-a-time' }],
  ['one at a time, mirrored', { method: 'one-at-a-time', belowZero: 'mirror' }],
  ['one at a time, clamped at 0', { method: 'one-at-a-time', belowZero: 'clamp' }],
]);

for (const [name, change] of pairs)
  test(`51 runs cannot tell the core from ${name}`, () => {
    for (const [i, target] of targets.entries()) {
      const { a12, p } = rankSums(endsOf(change, target), theirs(name, i), compareEnds);
      // The least of 36 such p is below this once in twenty by chance.
      assert.ok(p > 0.05 / (pairs.length * targets.length), `at ${target}: A12 ${a12}, p ${p}`);
    }
  });

test('what is not the same can be told apart: the comparison would see it', () => {
  for (const [name, change] of /** @type {readonly (readonly [string, Partial<Settings>])[]} */ ([
    ['DE rand/1/bin, F 0.5, CR 0.9 (SciPy)', {}],
    ['one at a time, clamped at 0', { method: 'one-at-a-time' }],
    ['EP, crossover 1 of gains and σ', { crossover: 0 }],
    ['CMA-ES, 20 (pycma)', { method: 'cma-es', population: 7 }],
  ])) {
    const ps = targets.map((target, i) => rankSums(endsOf(change, target), theirs(name, i), compareEnds).p);
    assert.ok(Math.min(...ps) < 1e-4, `${name}: ${ps}`);
  }
});

test('the simplex goes the way of SciPy’s, trial by trial', () => {
  const evolution = new Evolution({
    ...base,
    evolution: { ...base.evolution, method: 'nelder-mead', initialRange: [4, 4 + 1e-12] },
  });
  const tried = evolution.record(0).parents.map(({ gains }) => [...gains]);
  while (tried.length < reference.simplex.length) {
    evolution.step();
    tried.push(...evolution.record(evolution.generation).offspring.map(({ gains }) => [...gains]));
  }
  for (const [i, expected] of reference.simplex.entries())
    for (const [j, gain] of expected.entries())
      assert.ok(Math.abs(gain - tried[i][j]) < 1e-6, `drive ${i + 1}: ${tried[i]}, not ${expected}`);
});
