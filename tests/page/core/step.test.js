// So many steps at once are those that are taken one by one.
import assert from 'node:assert/strict';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

test('an evolution that is told how many generations is where it comes to one by one', () => {
  const [one, other] = [new core.Evolution({}), new core.Evolution({})];
  for (let i = 0; i < 29; i += 1) one.step();
  assert.deepEqual(other.step(30), one.step());
  assert.equal(other.generation, 30);
  assert.equal(other.hash(), one.hash());
  assert.deepEqual(other.step(1), one.step(undefined));
});

test('a robot that is told how many samples moves on by so many, and no further than its run', () => {
  const of = () => new core.Simulation({}, [3, 0.1, 5]);
  const [one, other] = [of(), of()];
  for (let i = 0; i < 99; i += 1) one.step();
  assert.deepEqual(other.step(100), one.step());
  assert.deepEqual(other.step(), one.step());
  const { time } = core.simulate({}, [3, 0.1, 5]);
  const end = other.step(500_000_000);
  assert.deepEqual([end.time, end.outcome], [time[time.length - 1], 'arrived']);
  assert.deepEqual(other.step(), end);
});

test('steps that are no number of steps are refused by name, and nothing moves', () => {
  const evolution = new core.Evolution({});
  const robot = new core.Simulation({}, [3, 0.1, 5]);
  for (const [count, message] of /** @type {const} */ ([
    [0, 'a whole number from 1 to 536870911, but was 0'],
    [-1, 'a whole number from 1 to 536870911, but was -1'],
    [1.5, 'a whole number from 1 to 536870911, but was 1.5'],
    [Number.NaN, 'a whole number from 1 to 536870911, but was NaN'],
    ['3', "a number, but was '3'"],
    [null, 'a number, but was null'],
  ])) {
    const given = /** @type {any} */ (count);
    assert.throws(() => evolution.step(given), { message: `generations must be ${message}` });
    assert.throws(() => robot.step(given), { message: `samples must be ${message}` });
  }
  assert.throws(() => evolution.step(20_001), /^Error: generations must be at most 20000 with 1 start/);
  assert.equal(evolution.generation, 0);
  assert.equal(robot.step().time, 0);
});
