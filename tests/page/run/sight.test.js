// What is seen while drives that take long are computed elsewhere.
import assert from 'node:assert/strict';
import { Pending } from '../../../www/core/pending.js';
import { breathe } from '../../../www/kit/loop.js';
import { createSight } from '../../../www/run/scene.js';
import { test } from '../harness/once.js';

/** @typedef {import('../../../www/run/state.js').State} State */
/** @typedef {import('../../../www/run/scene.js').Scene} Scene */

const stateOf = (/** @type {object} */ fields) => /** @type {State} */ (fields);

test('drives that cannot be had are told once, and asked for again when something else is to drive', async () => {
  const first = stateOf({ experiment: {} });
  let asked = 0;
  let isPending = true;
  /** @type {string[]} */
  const told = [];
  const scene = /** @type {Scene} */ ({});
  const sight = createSight(
    (state) => {
      if (state === first) return scene;
      asked += 1;
      isPending = !isPending;
      if (!isPending) throw new Pending(Promise.resolve());
      throw new Error('a worker was lost');
    },
    first,
    () => {},
    (error) => told.push(String(error)),
  );
  const long = stateOf({ experiment: { horizon: 1 } });
  assert.ok(sight.of(long).isComputing);
  await sight.whenSeen(() => long);
  assert.deepEqual([asked, told], [2, ['Error: a worker was lost']]);
  // That it is told is another state, of the same drives.
  for (const state of [long, stateOf({ ...long, message: 'a worker was lost' })]) {
    const { isComputing, state: seen } = sight.of(state);
    assert.deepEqual([isComputing, seen === first, asked], [false, true, 2]);
  }
  assert.ok(sight.of(stateOf({ experiment: { horizon: 2 } })).isComputing);
  assert.equal(asked, 3);
});

test('drives that cannot be had at once are told as well, and the last ones stay', () => {
  const first = stateOf({ experiment: {} });
  /** @type {string[]} */
  const told = [];
  const scene = /** @type {Scene} */ ({});
  const sight = createSight(
    (state) => {
      if (state === first) return scene;
      throw new Error('a worker was lost');
    },
    first,
    () => {},
    (error) => told.push(String(error)),
  );
  const next = stateOf({ experiment: { horizon: 1 } });
  for (let i = 0; i < 3; i += 1) assert.equal(sight.of(next).scene, scene);
  assert.deepEqual(told, ['Error: a worker was lost']);
  assert.match(String(sight.of(next).failure), /lost/);
  assert.equal(sight.of(first).failure, null);
  // After something else has driven they are asked for again.
  sight.of(first);
  assert.equal(told.length, 1);
  sight.renew();
  sight.of(first);
  sight.of(next);
  assert.equal(told.length, 2);
});

test('what lacks something more once the first is there is seen when all of it is', async () => {
  const first = stateOf({ experiment: {} });
  const next = stateOf({ experiment: { horizon: 1 } });
  const scene = /** @type {Scene} */ ({});
  // As the individuals of a generation, and then their drives.
  const lacking = new Map([
    [next, 3],
    [stateOf({ experiment: { horizon: 2 } }), 3],
  ]);
  const sight = createSight(
    (state) => {
      const count = lacking.get(state) ?? 0;
      lacking.set(state, count - 1);
      if (count > 0) throw new Pending(breathe());
      return scene;
    },
    first,
    () => {},
    () => {},
  );
  const [, before] = lacking.keys();
  assert.ok(sight.of(before).isComputing);
  await sight.whenSeen(() => next);
  const { isComputing, state } = sight.of(next);
  assert.deepEqual([isComputing, state === next], [false, true]);
});
