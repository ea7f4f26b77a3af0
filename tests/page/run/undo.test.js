// What one step of undo takes back, without the controls.
import assert from 'node:assert/strict';
import { noErrors } from '../../../www/run/first.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('gains by hand that gains from elsewhere replace come back with one step of undo, and nothing begins again', () => {
  const { store, actions } = pageOf('lab&generation=3&drives=paper-ep&gains=3,1,5');
  const told = () => {
    // On a slow machine undo comes only a part of its way at once.
    actions.evolve(() => store.get().catchingUp !== null);
    const { driver, handGains, found, generation, versions } = store.get();
    return [driver, String(handGains), found, generation, versions.past.length];
  };
  const own = ['paper-ep', '3,1,5', 'hand', 3, 0];
  const found = ['hand', '4,2,6', 'luck', 3, 1];
  assert.deepEqual(told(), own);
  // One for all that a slider passes by.
  actions.driveGains([4, 1, 6], 'luck');
  actions.driveGains([4, 2, 6], 'luck');
  assert.deepEqual(told(), found);
  actions.undo();
  assert.deepEqual(told(), own);
  actions.redo();
  assert.deepEqual(told(), found);
  // Among steps of the experiment each is taken back in its turn.
  const posture = actions.postureOf('goal');
  actions.movePosture('goal', { ...posture, x: 1 }, false);
  actions.undo();
  assert.deepEqual([store.get().handGains, actions.postureOf('goal')], [[4, 2, 6], posture]);
  actions.undo();
  assert.deepEqual(told(), own);
  // What nobody has set by hand is not lost.
  const { store: other, actions: without } = pageOf('lab');
  without.driveGains([4, 2, 6], 'map');
  assert.equal(other.get().versions.past.length, 0);
});

test('what a page opens with has nothing before it; the link that is opened next does', () => {
  const { store, actions, open } = pageOf('lab&seed=5&goal.x=2');
  const told = () => {
    const { experiment, versions } = store.get();
    return [experiment.evolution.seed, versions.past.length];
  };
  assert.deepEqual(told(), [5, 0]);
  open('lab&seed=6');
  assert.deepEqual(told(), [6, 1]);
  actions.undo();
  assert.deepEqual(told(), [5, 0]);
});

test('gains by hand that a link replaces come back with all else that it changed, in one step', () => {
  const { store, actions, open } = pageOf('lab&drives=hand&gains=6.45,5,5&start=1,0,90deg');
  const told = () => {
    const { driver, handGains, experiment, versions } = store.get();
    return [driver, String(handGains), experiment.starts[0].x, versions.past.length];
  };
  const own = told();
  for (const [link, opened] of /** @type {const} */ ([
    ['lab&drives=hand&gains=3,5,5&start=3,0,90deg', ['hand', '3,5,5', 3, 1]],
    ['lab&drives=hand&gains=3,0,0&start=1,0,90deg', ['hand', '3,0,0', 1, 1]],
    ['lab&drives=paper-ep&start=1,0,90deg', ['paper-ep', 'null', 1, 1]],
  ])) {
    open(link);
    assert.deepEqual(told(), opened, link);
    actions.undo();
    assert.deepEqual(told(), own, link);
  }
  // What drives as before is no step.
  open('lab&drives=hand&gains=6.45,5,5&start=1,0,90deg&generation=2');
  assert.deepEqual(told(), own);
});

test('a step of the lesson has nothing before it; what is changed in it is taken back there', () => {
  const { store, actions, open } = pageOf('lab&seed=5&drives=hand&gains=6.45,5,5');
  const told = () => {
    const { experiment, lesson, versions } = store.get();
    return [experiment.evolution.seed, lesson, versions.past.length];
  };
  open('lab&seed=6&lesson=6');
  assert.deepEqual(told(), [6, 6, 0]);
  open('lab&seed=7&lesson=6');
  assert.deepEqual(told(), [7, 6, 1]);
  open('lab&seed=8&lesson=7');
  assert.deepEqual(told(), [8, 7, 0]);
  actions.undo();
  assert.deepEqual(told(), [8, 7, 0]);
});

test('nor has a link that takes long to begin', async () => {
  const { store, actions } = pageOf('lab&population=1200&seed=5');
  assert.equal(store.get().computing?.what, 'begin');
  await actions.whenIdle();
  const { experiment, versions } = store.get();
  assert.deepEqual([experiment.evolution.seed, versions.past.length], [5, 0]);
});

test('nothing is taken back under a hand that still holds something', () => {
  const { actions } = pageOf('lab');
  const goal = actions.postureOf('goal');
  actions.movePosture('goal', { ...goal, x: 1 }, false);
  actions.movePosture('goal', { ...goal, x: 1.5 }, true);
  actions.undo();
  assert.equal(actions.postureOf('goal').x, 1.5);
});

test('a drag that comes back to where it began leaves what was undone; one that does not, and a press alone, are as ever', () => {
  const { store, actions } = pageOf('lab');
  const goal = actions.postureOf('goal');
  const dragTo = (/** @type {readonly number[]} */ ...places) => {
    for (const x of places) actions.movePosture('goal', { ...goal, x }, true);
    actions.releasePosture();
  };
  const told = () => {
    const { past, future } = store.get().versions;
    return [actions.postureOf('goal').x, past.length, future.length];
  };
  dragTo(1);
  dragTo(2);
  actions.undo();
  assert.deepEqual(told(), [1, 1, 1]);
  dragTo(1.5, 1);
  dragTo();
  assert.deepEqual(told(), [1, 1, 1]);
  actions.changeSetting('goal.x', 1.5, true);
  actions.changeSetting('goal.x', 1, true);
  actions.releaseSetting();
  assert.deepEqual(told(), [1, 1, 1]);
  actions.redo();
  assert.deepEqual(told(), [2, 2, 0]);
  actions.undo();
  dragTo(1.5);
  dragTo();
  assert.deepEqual(told(), [1.5, 2, 0]);
});

test('what was refused of the gains is gone with those that an undo takes back', () => {
  const { store, actions } = pageOf('lab&drives=hand&gains=3,1,5');
  actions.driveGains([4, 2, 6], 'luck');
  actions.typeGain(0, 'x');
  actions.undo();
  assert.deepEqual([store.get().handGains, store.get().gainErrors], [[3, 1, 5], noErrors]);
});
