// What the page has written down of each method is what the core does; σ, drives and idle settings have tests of their own.
import assert from 'node:assert/strict';
import { methods } from '../../../www/core/methods.js';
import { Evolution, experiment, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../../../www/core/methods.js').Method} Method */

const base = experiment('velocity-limits');
const names = /** @type {readonly Method[]} */ (
  wordFields().find(({ path }) => path === 'evolution.method')?.words
);

/** Of generations 1 to 40. @param {Method} method */
function recordsOf(method) {
  const evolution = new Evolution({ ...base, evolution: { ...base.evolution, method } });
  return Array.from({ length: 40 }, (_, i) => {
    evolution.step();
    return evolution.record(i + 1);
  });
}

test('every method of the core has its row', () => {
  assert.deepEqual(Object.keys(methods).sort(), [...names].sort());
});

test('a method forgets where only what is new stays, and has pairs where as many are new as may stay', () => {
  for (const method of names) {
    const records = recordsOf(method);
    const { forgets, pairs } = methods[method];
    const isNew = records.every(({ parents, survivors }) => survivors.every((one) => one >= parents.length));
    const areAsMany = records.every(({ parents, offspring }) => parents.length === offspring.length);
    assert.equal(forgets, isNew, method);
    assert.equal(pairs, areAsMany && !isNew, method);
  }
});

test('a better one falls beside a worse that stays just in a population that is kept, and where not all have met', () => {
  for (const method of names) {
    const { trials, forgets, upsets } = methods[method];
    const isUpset = recordsOf(method).some(({ parents, offspring, survivors }) => {
      const costs = [...parents, ...offspring].map(({ cost }) => cost);
      const worst = Math.max(...survivors.map((one) => costs[one]));
      return costs.some((cost, i) => cost < worst && !survivors.includes(i));
    });
    assert.equal(upsets, trials === 'population' && !forgets && isUpset, method);
  }
});
