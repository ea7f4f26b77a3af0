import assert from 'node:assert/strict';
import fc from 'fast-check';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';
import {
  answersTo,
  callsOf,
  hostile,
  pathsOf,
  placesIn,
  refusal,
  revoked,
  spring,
  traps,
  withOther,
} from './hostile/calls.js';

const { Evolution, Simulation } = core;
const calls = callsOf(core);

/** What the core says to good arguments, to the bit. */
const answers = () => answersTo(calls);

test('whatever a function is given in whatever place, it answers or says what is wrong, and lives on', () => {
  const before = answers();
  for (const [, call, given] of calls)
    for (const path of pathsOf(given).filter(({ length }) => length > 0))
      for (const make of hostile) refusal(call, withOther(given, path, make()));
  assert.equal(answers(), before);
});

test('what is refused is named by its path', () => {
  for (const path of pathsOf(core.experiment('velocity-limits'))) {
    const name = path.join('.').replaceAll(/\.(\d+)/g, '[$1]') || 'experiment';
    const said = refusal(core.experiment, [withOther(core.experiment('velocity-limits'), path, Symbol('s'))]);
    assert.ok(said?.startsWith(`${name} must be `), `${name}: ${said}`);
  }
});

test('what throws when it is looked at is named by its path, too', () => {
  for (const [given, said] of /** @type {const} */ ([
    [revoked.proxy, 'experiment must be an object, but was one that cannot be read'],
    [{ goal: new Proxy({}, traps) }, 'goal must be an object, but was one that cannot be read'],
    [
      { goal: Object.defineProperty({}, 'x', { get: spring }) },
      'goal.x must be a number from -1000 to 1000 m, but was one that cannot be read',
    ],
    [{ starts: [{}, revoked.proxy] }, 'starts[1] must be an object, but was one that cannot be read'],
    [
      { weights: { final: Object.defineProperty([1, 1, 1], 2, { get: spring }) } },
      'weights.final[2] must be a number from 0 to 1000000, but was one that cannot be read',
    ],
    [
      Object.defineProperty({}, 'law', { get: spring }),
      "law must be 'shim-kim' or 'kanayama', but was one that cannot be read",
    ],
  ]))
    assert.equal(refusal(core.experiment, [given]), said);
  const gains = Object.defineProperty([1, 2, 3], 1, { get: spring });
  assert.equal(refusal(core.evaluate, [{}, gains]), 'ky must be a number, but was one that cannot be read');
  assert.equal(
    refusal(core.evaluate, [{}, revoked.proxy]),
    'gains must be a Float64Array or an array of numbers, but was of type object',
  );
});

test('values of every kind that nobody thought of are refused alike', () => {
  const before = answers();
  const anything = fc.anything({
    withBigInt: true,
    withDate: true,
    withTypedArray: true,
    withSparseArray: true,
    withNullPrototype: true,
    withMap: true,
  });
  const places = placesIn(calls);
  fc.assert(
    fc.property(fc.constantFrom(...places), anything, ({ call, given, path }, value) => {
      refusal(call, withOther(given, path, value));
    }),
    { numRuns: 2000, seed: 1 },
  );
  assert.equal(answers(), before);
});

test('objects that throw cost the core nothing, however often', () => {
  const before = answers();
  const throwing = [
    () => revoked.proxy,
    () => ({ starts: new Proxy([{}], traps) }),
    () => ({ goal: new Proxy({}, traps) }),
  ];
  for (let i = 0; i < 2_000; i += 1)
    for (const make of throwing) assert.throws(() => core.experiment(/** @type {any} */ (make())));
  assert.equal(answers(), before);
});

test('what was freed, or is no object of the core, is refused', () => {
  const robot = new Simulation({}, [3, 0.1, 5]);
  // The second time there is nothing to free, as at the end of the block of `using`.
  robot.free();
  robot.free();
  assert.throws(() => robot.step(), /it was freed/);
  assert.throws(() => Evolution.prototype.step.call({}), Error);
  assert.throws(() => Reflect.apply(Evolution, undefined, [{}]), TypeError);
});

test('the learning rates are those of three gains', () => {
  const { own, common } = core.learningRates();
  assert.ok(Math.abs(own - 1 / Math.sqrt(2 * Math.sqrt(3))) < 1e-15);
  assert.ok(Math.abs(common - 1 / Math.sqrt(2 * 3)) < 1e-15);
});
