// Work on an exercise goes on where its link is opened again: by the way back, after a step of the lesson, by a reload.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { withExercise } from '../../../www/link/link.js';
import { drivesOf } from '../../../www/run/state.js';
import { createEngine, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

const free = 'lab&v=1&drives=hand&gains=3,1,5&task=Few.&aim=J%3C8';
const budget = free.replace('J%3C8', 'J%3C8;drives%3C%3D400');

/** @typedef {ReturnType<typeof pageOf>} Run */

/** @param {Run} run @param {number} times */
function tryGains({ actions }, times) {
  for (let i = 0; i < times; i += 1) {
    actions.driveGains([3 + 0.1 * (i + 1), 1, 5], 'hand');
    actions.driveAgain();
  }
}

/** @param {Run} run */
const drives = ({ store }) => drivesOf({ ...store.get(), driver: 'hand' });

/** @param {Run} run As if it had begun before. */
function beginEarlier({ store }) {
  const { work } = store.get();
  store.update({ work: { ...work, begun: work.begun - 600_000 } });
  return store.get().work.begun;
}

test('drives and time count on where the link from before is opened again', () => {
  for (const link of [free, budget, `${free}&who=s1`]) {
    const run = pageOf(link);
    const begun = beginEarlier(run);
    tryGains(run, 3);
    run.open(link);
    assert.deepEqual([drives(run), run.store.get().work.begun], [3, begun], link);
    run.open(withExercise(links.linkOfStep(1), run.store.get(), experiment));
    assert.equal(run.store.get().work.begun, begun);
    run.open(link);
    assert.deepEqual([drives(run), run.store.get().work.begun], [3, begun], link);
  }
});

test('generations that are evolved once more count once', () => {
  const run = pageOf(budget);
  for (let i = 0; i < 10; i += 1) run.actions.forward();
  const before = drives(run);
  assert.equal(before, 220);
  run.open(`${budget}&generation=4`);
  assert.equal(drives(run), before);
  for (let i = 0; i < 6; i += 1) run.actions.forward();
  assert.equal(drives(run), before);
  run.actions.forward();
  assert.equal(drives(run), before + 20);
});

test('what was driven counts on also after another seed, beside the lesson, and by the way over another exercise', () => {
  const run = pageOf(budget);
  tryGains(run, 3);
  run.actions.newSeed();
  for (let i = 0; i < 10; i += 1) run.actions.forward();
  const before = drives(run);
  assert.ok(before > 200);
  run.open(budget);
  assert.equal(drives(run), before);

  const beside = pageOf(`${free}&lesson=2`);
  for (const made of [2, 4]) {
    tryGains(beside, 2);
    beside.open(`${free}&lesson=2`);
    assert.equal(drives(beside), made);
  }

  const over = pageOf(free);
  const begun = beginEarlier(over);
  tryGains(over, 3);
  over.open(free.replace('Few', 'Fewer'));
  // A receipt is looked at, and leaves what was done.
  over.open(`${free}&handin=1~7.9`);
  over.open(free);
  assert.deepEqual([drives(over), over.store.get().work.begun], [3, begun]);
});

test('what the tab has kept over a reload counts once, however often the link is opened then', () => {
  const run = pageOf('lab&v=1');
  const open = () => {
    const { opened } = links.openLink(free, createEngine());
    run.actions.openLinked({ ...opened, student: { ...opened.student, made: 5 } }, []);
  };
  open();
  assert.equal(drives(run), 5);
  tryGains(run, 2);
  for (let time = 0; time < 2; time += 1) {
    open();
    assert.equal(drives(run), 7);
  }
});

test('a link that knows of more is believed', () => {
  const run = pageOf(budget);
  tryGains(run, 2);
  run.open(`${budget}&spent=7`);
  assert.equal(drives(run), 7);
  // What was tried here counts beside generations that were made elsewhere.
  const other = pageOf(budget);
  tryGains(other, 3);
  other.open(`${budget}&generation=4`);
  assert.equal(drives(other), 103);
});

test('another exercise, another person, no exercise, and what was handed in begin anew', () => {
  for (const [from, to] of [
    [free, free.replace('Few', 'Fewer')],
    [free, `${free}&goal.x=1`],
    [`${free}&who=s1`, `${free}&who=s2`],
    ['lab&v=1&drives=hand&gains=3,1,5', 'lab&v=1&drives=hand&gains=3,1,5'],
    [free, `${free}&handin=1~7.9`],
  ]) {
    const run = pageOf(from);
    const begun = beginEarlier(run);
    tryGains(run, 3);
    run.open(to);
    assert.equal(drives(run), 0, to);
    assert.ok(run.store.get().work.begun > begun, to);
  }
});
