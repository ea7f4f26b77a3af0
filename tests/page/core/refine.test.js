// A picture is asked for coarse, then fine; what failed is asked for again only when somebody says so.
import assert from 'node:assert/strict';
import { createRefining } from '../../../www/core/refine.js';
import { test } from '../harness/once.js';

/** What the workers were asked for, and what came of it. */
function createAsked() {
  const seen = {
    asked: /** @type {string[]} */ ([]),
    results: /** @type {string[]} */ ([]),
    failures: 0,
    isBlocked: false,
  };
  const refining = createRefining({
    counts: [2, 4],
    async compute(/** @type {{ name: string }} */ { name }, count) {
      seen.asked.push(`${name}${count}`);
      if (seen.isBlocked) throw new Error('blocked');
      return `${name}${count}`;
    },
    onResult: (result) => seen.results.push(result),
    onFailure: () => {
      seen.failures += 1;
    },
  });
  /** Some frames of a page. @param {{ name: string }} spec */
  const draw = async (spec) => {
    for (let frame = 0; frame < 5; frame += 1) {
      refining.follow(spec, false);
      await new Promise(setImmediate);
    }
  };
  return { seen, draw, follow: refining.follow, retry: refining.retry };
}

test('what failed is asked for once, and once more when it is retried', async () => {
  const { seen, draw, retry } = createAsked();
  const spec = { name: 'a' };
  seen.isBlocked = true;
  await draw(spec);
  assert.deepEqual(seen.asked, ['a2']);
  retry();
  await draw(spec);
  assert.deepEqual(seen.asked, ['a2', 'a2']);
  assert.equal(seen.failures, 2);

  seen.isBlocked = false;
  await draw(spec);
  assert.deepEqual(seen.results, []);
  retry();
  await draw(spec);
  assert.deepEqual(seen.results, ['a2', 'a4']);
});

test('what is there is not asked for again, and what failed hinders nothing else', async () => {
  const { seen, draw, retry } = createAsked();
  const spec = { name: 'a' };
  await draw(spec);
  retry();
  await draw(spec);
  assert.deepEqual(seen.asked, ['a2', 'a4']);
  seen.isBlocked = true;
  await draw({ name: 'b' });
  seen.isBlocked = false;
  await draw({ name: 'c' });
  assert.deepEqual(seen.results, ['a2', 'a4', 'c2', 'c4']);
});

test('what is under way is not asked for once more, and nothing finer while something moves', async () => {
  const { seen, follow } = createAsked();
  const spec = { name: 'a' };
  for (let frame = 0; frame < 3; frame += 1) follow(spec, true);
  await new Promise(setImmediate);
  follow(spec, true);
  assert.deepEqual(seen.asked, ['a2']);
  for (let frame = 0; frame < 3; frame += 1) follow(spec, false);
  assert.deepEqual(seen.asked, ['a2', 'a4']);
});
