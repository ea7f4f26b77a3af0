// Long work that is given up in the moment in which it is done.
import assert from 'node:assert/strict';
import { createAttempts } from '../../../www/parts/attempt.js';
import { test } from '../harness/once.js';

/** Work that is done once `done` is called, and what is said of it. */
function attempted() {
  /** @type {Record<string, unknown>} */
  const said = {};
  const attempts = createAttempts((patch) => Object.assign(said, patch));
  /** @param {number} found */
  const begin = (found) => {
    let done = () => {};
    const end = attempts.begin(
      () => new Promise((resolve) => (done = () => resolve(/** @type {object} */ ({ found })))),
    );
    return { end, done };
  };
  return { said, begin, cancel: attempts.cancel };
}

test('what is cancelled as it is done leaves what was there before', async () => {
  const { said, begin, cancel } = attempted();
  const { end, done } = begin(1);
  done();
  cancel();
  assert.equal(await end, false);
  assert.deepEqual(said, { progress: null, cancelled: true, message: '' });
});

test('what another took the place of as it was done says nothing', async () => {
  const { said, begin } = attempted();
  const first = begin(1);
  first.done();
  const second = begin(2);
  assert.equal(await first.end, false);
  assert.deepEqual(said, { progress: 0, cancelled: false, message: '' });
  second.done();
  assert.equal(await second.end, true);
  assert.deepEqual(said, { progress: null, cancelled: false, message: '', found: 2 });
});
