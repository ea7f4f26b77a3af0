// What begins anew, and what only seems to.
import assert from 'node:assert/strict';
import { noTrial } from '../../../www/run/state.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('what is set while a link catches up begins another evolution, which nobody has let go on', () => {
  const { actions, store } = pageOf('lab');
  store.update({ evolving: true, catchingUp: { newest: 40, generation: 40 } });
  actions.changeSetting('goal.x', 1.5, false);
  assert.equal(store.get().evolving, false);
  actions.toggleEvolution();
  actions.changeSetting('goal.x', 1.75, false);
  assert.equal(store.get().evolving, true);
});

test('evolution that was left running goes on from where it was, however far that is', () => {
  for (const goesOn of [true, false]) {
    const { actions, store } = pageOf('lab');
    store.update({ evolving: true, catchingUp: { newest: 3, generation: 3, goesOn } });
    actions.evolve(() => store.get().catchingUp !== null);
    assert.deepEqual([store.get().generation, store.get().evolving], [3, goesOn]);
  }
});

test('what is wrong with a link stays in sight when its generation is there, until something is done', () => {
  const { store, actions } = pageOf('lab&goal.x=abc');
  store.update({ evolving: true, catchingUp: { newest: 4, generation: 4 } });
  actions.evolve(() => store.get().catchingUp !== null);
  assert.equal(store.get().generation, 4);
  assert.match(store.get().message, /goal\.x/);
  actions.oneGeneration();
  assert.equal(store.get().message, '');
});

test('what a link waits for can be stopped, but not where running is locked', () => {
  for (const [locked, stops] of /** @type {const} */ ([
    ['', true],
    ['&lock=seed', true],
    ['&lock=run', false],
  ])) {
    const { actions, store } = pageOf(`lab${locked}`);
    store.update({ evolving: true, catchingUp: { newest: 40, generation: 40 } });
    actions.stopComputing();
    assert.equal(store.get().catchingUp === null, stops, locked);
  }
  // What is set there, as far as that is free, is not what its link waits for.
  const { actions, store } = pageOf('lab&lock=run');
  store.update({ computing: { what: 'begin', since: 0, share: () => null } });
  actions.stopComputing();
  assert.equal(store.get().computing, null);
});

test('a start that is tried where evolution starts is none', () => {
  const { actions, store } = pageOf('robustness');
  const own = actions.postureOf('start');
  actions.movePosture('start', { ...own, x: 1 }, true);
  assert.equal(store.get().trial.start?.x, 1);
  actions.movePosture('start', own, true);
  assert.equal(store.get().trial, noTrial);
});

test('what is moved stays where the core allows it, wherever it is tried', () => {
  for (const link of ['lab', 'robustness'])
    for (const end of /** @type {const} */ (['start', 'goal'])) {
      const { actions, store } = pageOf(link);
      actions.movePosture(end, { x: 1200, y: -3000, theta: 1 }, true);
      assert.deepEqual(actions.postureOf(end), { x: 1000, y: -1000, theta: 1 }, `${end} of ${link}`);
      assert.equal(store.get().message, '');
    }
});

test('the plane stands still under a hand, and comes near again where a start is tried no more', () => {
  const { actions, store } = pageOf('robustness');
  store.update({ size: { width: 800, height: 600 } });
  const width = () => store.get().box.right - store.get().box.left;
  const before = width();
  const far = { x: 9, y: 0, theta: 0 };
  actions.movePosture('start', far, true);
  assert.equal(width(), before);
  actions.movePosture('start', { ...far, x: 9.5 }, false);
  assert.ok(width() > 2 * before);
  actions.openPage('lab');
  assert.ok(width() < 2 * before);
});
