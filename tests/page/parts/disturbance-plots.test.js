// The lines of Disturbance: the largest of each 0.2 s, and the set of y as it is.
import assert from 'node:assert/strict';
import { crests, edgeOf } from '../../../www/parts/disturbance/plots.js';
import { errorParts, experiment, paperGains } from '../harness/core.js';
import { test } from '../harness/once.js';

test('what trembles evenly stays as high up to the last sample, and so does what is left of the end', () => {
  for (const samples of [1001, 1011, 12]) {
    const times = Float64Array.from({ length: samples }, (_, i) => i / 100);
    // One in ten is 1, the last is none of them.
    const sizes = Float64Array.from(times, (_, i) => (i % 10 === 5 ? 1 : 0.1));
    const [crestTimes, crestSizes] = crests(times, sizes);
    assert.equal(crestTimes[crestTimes.length - 1], times[samples - 1]);
    assert.deepEqual(
      crestSizes,
      crestSizes.map(() => 1),
      String(samples),
    );
  }
});

/** @typedef {import('../harness/core.js').Experiment['disturbance']} Disturbance */

/** What Disturbance measures of the paper's best robot, and the edge that it draws. @param {Partial<Disturbance>} disturbance */
function measured(disturbance) {
  const gains = paperGains('velocity-limits', 'ep');
  const calm = experiment({ ...experiment('velocity-limits'), tolerance: { position: 0, heading: 0 } });
  const own = experiment({ ...calm, disturbance });
  const runs = errorParts(own, gains);
  const [times, sizes] = edgeOf({ spec: { experiment: own, gains, seconds: 2 }, runs });
  return { run: runs[0], times, sizes };
}

test('with slip the edge of the set of y is the set itself, at every sample', () => {
  const { run, times, sizes } = measured({ kind: 'slip', linear: 0.1, angular: 0 });
  assert.deepEqual(Array.from(times), [...run.time]);
  assert.deepEqual(Array.from(sizes), [...run.ySet]);
});

test('where it trembles the edge is that of the crests, which nothing of the set exceeds', () => {
  const { run, times, sizes } = measured({ kind: 'random', linear: 0.1, angular: 0.1, seed: 1 });
  assert.ok(times.length < 60);
  for (const [i, time] of run.time.entries()) {
    const at = Array.from(times).findLastIndex((one) => one <= time);
    assert.ok(run.ySet[i] <= sizes[at], `${time}`);
  }
});
