// What one step of undo takes back, without the controls.
import assert from 'node:assert/strict';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('gains by hand that gains from elsewhere replace come back with one step of undo, and nothing begins again', () => {
  const { store, actions } = pageOf('lab&generation=3&drives=paper-ep&gains=3,1,5');
  const told = () => {
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
  assert.deepEqual(told(), ['paper-ep', '3,1,5', 'hand', 0, 0]);
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

test('nor has a link that takes long to begin', async () => {
  const { store, actions } = pageOf('lab&population=1200&seed=5');
  assert.equal(store.get().computing?.what, 'begin');
  await actions.whenIdle();
  const { experiment, versions } = store.get();
  assert.deepEqual([experiment.evolution.seed, versions.past.length], [5, 0]);
});
