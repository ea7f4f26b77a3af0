// The robots' clock, as it is drawn by hand.
import assert from 'node:assert/strict';
import { atEnd, fromStart } from '../../../www/run/clock.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('the clock that is drawn as far as its slider goes stands at the end', () => {
  const { actions, store } = pageOf('lab', { finalTime: () => 1.9000000000000001, isStill: () => false });
  actions.scrub(1.89);
  assert.deepEqual(store.get().robot, { time: 1.89, held: 0, playing: false });
  actions.scrub(1.9);
  assert.deepEqual(store.get().robot, atEnd);
  actions.togglePlay();
  assert.deepEqual(store.get().robot, fromStart);
  actions.scrub(0);
  assert.equal(store.get().robot.time, 0);
});

const moving = { finalTime: () => 2, isStill: () => false };

test('Run lets a robot that was paused on its way drive on from there', () => {
  const { actions, store } = pageOf('lab', moving);
  actions.scrub(1);
  actions.toggleEvolution();
  assert.deepEqual(store.get().robot, { time: 1, held: 0, playing: true });
});

test('from a start that is tried the robot drives at once', () => {
  const { actions, store } = pageOf('robustness', moving);
  actions.scrub(1);
  actions.tryStart({ x: 1, y: 0, theta: 0 });
  assert.deepEqual(store.get().robot, fromStart);
});
