// What a step computes aside.
import assert from 'node:assert/strict';
import { Pending, tryNow } from '../../../www/core/pending.js';
import { aside } from '../../../www/lesson/aside.js';
import { test } from '../harness/once.js';

test('what is computed aside is asked for once, and asked again when it is there', async () => {
  let asked = 0;
  const value = aside(async () => {
    asked += 1;
    return 7;
  });
  assert.equal(
    await new Promise((again) =>
      assert.equal(
        tryNow(value, () => again('again')),
        null,
      ),
    ),
    'again',
  );
  assert.deepEqual([value(), tryNow(value, assert.fail), asked], [7, 7, 1]);
});

test('what fails never arrives, and is no error that nobody catches', async () => {
  let asked = 0;
  const value = aside(() => {
    asked += 1;
    return Promise.reject(new Error('no worker'));
  });
  for (let i = 0; i < 3; i += 1) assert.equal(tryNow(value, assert.fail), null);
  await new Promise((resolve) => setImmediate(resolve));
  assert.throws(value, Pending);
  assert.equal(asked, 1);
});
