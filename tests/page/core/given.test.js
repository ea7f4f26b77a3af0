// What the core makes of experiments that were copied, mixed, or came from elsewhere.
import assert from 'node:assert/strict';
import { runInNewContext } from 'node:vm';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */

const [slow, fast] = /** @type {const} */ (['acceleration-limits', 'velocity-limits']).map((name) =>
  core.experiment(name),
);
const limits = /** @type {any} */ ({ speed: 1 });
/** What is filled in. @param {Experiment} from */
const acceleration = (from) => core.experiment(from).limits.acceleration;

test('the experiment of a task, too, is completed from the preset that it was made from', () => {
  assert.equal(acceleration({ ...new core.Task(slow).experiment, limits }), 5);
  assert.equal(acceleration({ ...new core.Task(fast).experiment, limits }), null);
  assert.equal(acceleration({ ...new core.Task({ horizon: 5 }).experiment, limits }), null);
  const again = new core.Task({ ...slow, limits }).experiment;
  assert.equal(acceleration({ ...again, limits }), 5);
});

test('wherever an experiment is given, the name of a preset will do', () => {
  const gains = [3, 0.1, 5];
  assert.deepEqual(core.evaluate('acceleration-limits', gains), core.evaluate(slow, gains));
  assert.notDeepEqual(core.evaluate('acceleration-limits', gains), core.evaluate(fast, gains));
  const robots = [new core.Simulation('acceleration-limits', gains), new core.Simulation(slow, gains)];
  const [named, whole] = robots.map((robot) => robot.step(50));
  assert.deepEqual(named, whole);
  for (const make of [core.Task, core.Evolution]) {
    const { experiment } = new make('acceleration-limits');
    assert.deepEqual(experiment, slow);
    assert.equal(acceleration({ ...experiment, limits }), 5);
  }
  const expected = "experiment must be 'velocity-limits' or 'acceleration-limits', but was 'none'";
  // @ts-expect-error there is no such preset
  for (const refused of [() => new core.Task('none'), () => core.evaluate('none', gains)])
    assert.throws(refused, { message: expected, field: 'experiment' });
});

test('what is refused has the name of its field by itself', () => {
  const wrong = { starts: [{}, { theta: Number.NaN }] };
  assert.throws(() => core.experiment(wrong), {
    message: 'starts[1].theta must be a number from -100 to 100 rad, but was NaN',
    field: 'starts[1].theta',
  });
  assert.throws(() => core.evaluate({}, [1, 2]), { field: 'gains' });
});

test('an evolution has its experiment, with every field filled in', () => {
  const evolution = new core.Evolution({ goal: { x: 3 } });
  assert.deepEqual(evolution.experiment, core.experiment({ goal: { x: 3 } }));
});

test('a mix is completed from the preset of most of its parts, whichever come first', () => {
  const { starts, evolution } = fast;
  assert.equal(acceleration({ ...slow, starts, limits }), 5);
  assert.equal(acceleration({ ...slow, starts, evolution, limits }), 5);
  assert.equal(acceleration({ ...fast, starts: slow.starts, limits }), null);
  const { goal, referenceVelocity, tolerance, weights } = fast;
  const half = { ...slow, goal, referenceVelocity, tolerance, weights };
  assert.equal(acceleration({ ...half, limits }), null, 'more of the other');
  assert.equal(acceleration({ ...structuredClone(slow), limits }), null, 'of a clone nothing is known');
});

test('numbers side by side are read from another realm, as they are from this one', () => {
  const numbers = [0, 0, 1, 1, 0.5, -1];
  const foreign = runInNewContext('Float64Array.from(numbers)', { numbers });
  assert.ok(!(foreign instanceof Float64Array));
  const own = core.experiment({ starts: Float64Array.from(numbers) });
  assert.deepEqual(core.experiment({ starts: foreign }), own);
  assert.deepEqual(core.evaluate({}, foreign), core.evaluate({}, Float64Array.from(numbers)));
  const refused = {
    message: /^starts must be three numbers \(x, y, θ\) for each posture, but was 5 numbers$/,
  };
  assert.throws(() => core.experiment({ starts: foreign.subarray(1) }), refused);
  for (const kind of ['Float32Array', 'BigInt64Array', 'Uint8Array'])
    assert.throws(() => core.experiment({ starts: runInNewContext(`new ${kind}(6)`) }), {
      message: 'starts must be an array of 1 to 10000, but was of type object',
    });
});
