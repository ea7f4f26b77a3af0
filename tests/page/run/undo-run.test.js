// What is taken back comes back with its run: nothing that was evolved or set by hand is lost without a way back.
import assert from 'node:assert/strict';
import { Pending } from '../../../www/core/pending.js';
import { drivesOf } from '../../../www/run/state.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

/** @typedef {ReturnType<typeof pageOf>} Run */

/** @param {Run} run */
function told({ store, actions }) {
  // On a slow machine a run comes only a part of its way at once.
  actions.evolve(() => store.get().catchingUp !== null);
  const { generation, history, evolving, versions } = store.get();
  const drives = drivesOf({ ...store.get(), driver: 'hand' });
  return {
    generation,
    newest: history.length - 1,
    best: history.at(-1)?.best.cost,
    evolving,
    drives,
    past: versions.past.length,
  };
}

/** @param {Run} run @param {number} by @param {boolean} [dragging] */
function moveGoal({ actions }, by, dragging = false) {
  const goal = actions.postureOf('goal');
  actions.movePosture('goal', { ...goal, x: goal.x + by }, dragging);
}

/** @param {Run} run */
function dragAndBack(run) {
  moveGoal(run, 1, true);
  moveGoal(run, 1, true);
  moveGoal(run, -2, true);
  run.actions.releasePosture();
}

test('a drag that comes back to where it began leaves the run as it was, and one that was going on goes on', () => {
  const run = pageOf('lab&generation=12');
  run.actions.showGeneration(7);
  const before = told(run);
  assert.deepEqual([before.generation, before.newest], [7, 12]);
  dragAndBack(run);
  assert.deepEqual(told(run), before);
  run.actions.toggleEvolution();
  dragAndBack(run);
  assert.deepEqual(told(run), { ...before, evolving: true });
});

test('undo and redo bring back experiments with their runs, whose drives count once', () => {
  const run = pageOf('lab&generation=9');
  const first = told(run);
  moveGoal(run, 1);
  for (let i = 0; i < 4; i += 1) run.actions.forward();
  const second = told(run);
  assert.deepEqual([second.generation, second.past], [4, 1]);
  assert.ok(second.drives > first.drives);
  run.actions.undo();
  const { drives } = second;
  assert.deepEqual(told(run), { ...first, drives });
  run.actions.redo();
  assert.deepEqual(told(run), second);
  run.actions.undo();
  assert.deepEqual(told(run), { ...first, drives });
});

test('what was driven stays counted where undo is paused on its way, and is undone again', () => {
  const { store, actions } = pageOf('lab&population=200&generation=60');
  const drives = () => drivesOf({ ...store.get(), driver: 'hand' });
  const before = drives();
  const goal = actions.postureOf('goal');
  actions.movePosture('goal', { ...goal, x: 1 }, false);
  actions.undo();
  actions.pauseEvolution();
  const paused = store.get().history.length - 1;
  assert.equal(drives() - before, 0);
  actions.movePosture('goal', { ...goal, x: 1 }, false);
  actions.undo();
  actions.pauseEvolution();
  assert.ok(paused <= 60 && drives() >= before, `${drives()} of ${before}`);
});

test('a run that is passed by while another is on its way keeps what it had', async () => {
  const run = pageOf('lab&generation=5');
  moveGoal(run, 1);
  for (let i = 0; i < 2; i += 1) run.actions.forward();
  const second = told(run);
  moveGoal(run, 1);
  const { begin } = run.engine;
  /** @type {() => void} */
  let arrive = () => {};
  run.engine.begin = () => {
    throw new Pending(
      new Promise((resolve) => {
        arrive = () => resolve(undefined);
      }),
    );
  };
  for (let i = 0; i < 2; i += 1) {
    run.actions.undo();
    assert.equal(run.store.get().computing?.what, 'begin');
  }
  run.engine.begin = begin;
  arrive();
  await run.actions.whenIdle();
  assert.equal(told(run).generation, 5);
  run.actions.redo();
  const { generation, best } = told(run);
  assert.deepEqual([generation, best], [2, second.best]);
});

test('of a drag that comes back nothing is said, and what had been reached is no end', () => {
  const run = pageOf('lab');
  const { restart } = run.store.get();
  dragAndBack(run);
  assert.equal(run.store.get().restart, restart);
  for (let i = 0; i < 12; i += 1) run.actions.forward();
  run.actions.setUntil('cost', '1e6');
  run.store.update({ evolving: true });
  dragAndBack(run);
  told(run);
  assert.deepEqual([run.store.get().evolving, run.store.get().until.kind], [true, 'every']);
});

test('an exercise has its prepared generation whichever way leads back to what was given', () => {
  /** @type {Record<string, (run: Run) => void>} */
  const ways = {
    'a drag that is taken back': dragAndBack,
    'one step there, one back': (run) => {
      moveGoal(run, 1);
      assert.equal(told(run).generation, 0);
      moveGoal(run, -1);
    },
    'the postures of the paper': (run) => {
      moveGoal(run, 1);
      run.actions.restorePostures();
    },
    'the other preset and back': ({ actions }) => {
      actions.choosePreset('acceleration-limits');
      actions.choosePreset('velocity-limits');
    },
    'a setting and its own way back': ({ actions }) => {
      actions.changeSetting('limits.speed', 1, false);
      actions.changeSetting('limits.speed', 2, false);
    },
    'a slider there and back': ({ actions }) => {
      for (const value of [1, 2]) actions.changeSetting('limits.speed', value, true);
      actions.releaseSetting();
    },
    'back to the preset': ({ actions }) => {
      actions.changeSetting('limits.speed', 1, false);
      actions.backToPreset();
    },
    'the exercise as given': (run) => {
      moveGoal(run, 1);
      run.actions.backToExercise();
    },
    undo: (run) => {
      moveGoal(run, 1);
      run.actions.undo();
    },
  };
  for (const way of ['lock', 'hide'])
    for (const [name, act] of Object.entries(ways)) {
      const run = pageOf(`lab&v=1&generation=8&task=Look.&${way}=run&aim=J%3C8`);
      assert.equal(run.store.get().experiment.limits.speed, 2);
      const { generation, best, drives } = told(run);
      assert.equal(generation, 8);
      act(run);
      const after = told(run);
      assert.deepEqual([after.generation, after.best], [8, best], name);
      // What was prepared counts once, however often it is evolved.
      assert.equal(after.drives - drives, 0, name);
    }
});

test('where evolution may run on, what is set back by hand begins anew', () => {
  const run = pageOf('lab&v=1&generation=8&task=Look.&aim=J%3C8');
  moveGoal(run, 1);
  moveGoal(run, -1);
  assert.equal(told(run).generation, 0);
});

/** @param {Run} run */
const hand = ({ store }) => {
  const { driver, handGains, versions } = store.get();
  return [driver, String(handGains), versions.past.length];
};

test('gains by hand that a slider leaves while others drive are a step of undo, whole', () => {
  const run = pageOf('lab&drives=hand&gains=2.5,7.1,3.3');
  run.actions.slideGain(0, 2.6);
  assert.deepEqual(hand(run), ['hand', '2.6,7.1,3.3', 0]);
  run.actions.chooseDriver('paper-ep');
  run.actions.slideGain(0, 3);
  run.actions.slideGain(0, 3.5);
  const [driver, gains, past] = hand(run);
  assert.deepEqual([driver, past], ['hand', 1]);
  assert.match(String(gains), /^3\.5,/);
  run.actions.undo();
  assert.deepEqual(hand(run), ['paper-ep', '2.6,7.1,3.3', 0]);
  run.actions.typeGain(1, '4');
  run.actions.undo();
  assert.deepEqual(hand(run), ['paper-ep', '2.6,7.1,3.3', 0]);
  // Three at once take the place of those by hand, too.
  run.actions.chooseDriver('hand');
  run.actions.driveGains([2, 2, 5]);
  run.actions.undo();
  assert.deepEqual(hand(run), ['hand', '2.6,7.1,3.3', 0]);
});

test('where nobody can choose who drives, undo brings back who did', () => {
  const run = pageOf('lab&v=1&generation=5&task=Look.&lock=drives,run&aim=J%3C8');
  run.actions.slideGain(0, 3);
  assert.equal(hand(run)[0], 'hand');
  run.actions.undo();
  assert.deepEqual([...hand(run), told(run).generation], ['evolved', 'null', 0, 5]);
  // Elsewhere a press does.
  const free = pageOf('lab&generation=5');
  free.actions.slideGain(0, 3);
  assert.equal(free.store.get().versions.past.length, 0);
});

test('gains of a step of the lesson that nobody has moved are not taken for own ones', () => {
  const link = 'lab&drives=hand&gains=2.5,7.1,3.3';
  const run = pageOf('lab&lesson=1&drives=hand&gains=1,4,1');
  run.open(link);
  assert.deepEqual(hand(run), ['hand', '2.5,7.1,3.3', 0]);
  const moved = pageOf('lab&lesson=1&drives=hand&gains=1,4,1');
  moved.actions.slideGain(0, 2);
  moved.actions.driveAgain();
  moved.open(link);
  moved.actions.undo();
  assert.deepEqual(hand(moved), ['hand', '2,4,1', 0]);
});
