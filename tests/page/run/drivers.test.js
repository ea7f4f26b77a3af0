// Whom who drives is compared with, without a browser.
import assert from 'node:assert/strict';
import { rivalOf } from '../../../www/run/drivers.js';
import { firstMaker, noExercise } from '../../../www/run/exercise.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';

test('a hand is compared with evolution, and before it has begun with what it found in the paper', () => {
  const usual = experiment('velocity-limits');
  const state = { handGains: null, exercise: noExercise, maker: firstMaker, experiment: usual };
  const unlimited = { ...usual, limits: { ...usual.limits, turnRate: null } };
  const paperless = { ...state, exercise: { ...noExercise, hidden: /** @type {['paper']} */ (['paper']) } };
  for (const [driver, generations, rival, rivalWithoutPaper] of /** @type {const} */ ([
    ['hand', 0, 'paper-ep', 'evolved'],
    ['hand', 1, 'evolved', 'evolved'],
    ['paper-arbitrary', 0, 'paper-ep', 'evolved'],
    ['paper-arbitrary', 7, 'evolved', 'evolved'],
    ['paper-ep', 0, 'paper-arbitrary', 'evolved'],
    ['evolved', 7, 'paper-arbitrary', 'evolved'],
  ])) {
    const history = new Array(1 + generations).fill(null);
    assert.equal(rivalOf({ ...state, driver, history }), rival);
    for (const other of [unlimited, { ...usual, law: /** @type {const} */ ('kanayama') }])
      assert.notEqual(rivalOf({ ...state, driver, history, experiment: other }), 'paper-ep');
    assert.equal(rivalOf({ ...paperless, driver, history }), rivalWithoutPaper);
  }
});
