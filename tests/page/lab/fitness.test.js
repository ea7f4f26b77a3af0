// The axis of the fitness curve.
import assert from 'node:assert/strict';
import { createColumns } from '../../../www/lab/columns.js';
import { costRange } from '../../../www/lab/fitness.js';
import { experiment, historyOf } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */

/** @param {Experiment} from @param {number} generations @param {number | null} paper */
function rangeOf(from, generations, paper) {
  const history = historyOf(from, generations);
  const columns = createColumns(['generation', 'best', 'median'])(history);
  const newest = history[generations].best.cost;
  return { newest, range: costRange({ history, columns, generation: generations, paper, theme: 0 }) };
}

test('below the lowest J there is room on the axis, but none below 0, where no J can be', () => {
  const usual = experiment('velocity-limits');
  for (const generations of [1, 30]) {
    const { newest, range } = rangeOf(usual, generations, 7.935);
    assert.ok(range[0] > 0 && range[0] < newest - 0.1, `${range}`);
  }
  const { tolerance, disturbance, evolution } = usual;
  const wild = experiment({
    limits: { speed: null, turnRate: null },
    tolerance: { ...tolerance, speed: 0.1 },
    disturbance: { ...disturbance, kind: 'random', linear: 0.1 },
    evolution: { ...evolution, method: 'finite-differences' },
  });
  const { newest, range } = rangeOf(wild, 7, null);
  assert.ok(newest < range[1] / 100, 'its first J is far above');
  assert.equal(range[0], 0);
  // Who begins at the goal pays nothing, and is at the bottom of an axis.
  const there = rangeOf(experiment({ starts: [usual.goal] }), 1, null);
  assert.equal(there.newest, 0);
  assert.ok(there.range[0] === 0 && there.range[1] > 0, `${there.range}`);
});
