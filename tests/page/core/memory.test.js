// The memory of the core after whatever it was asked. CALLS=100000 tries longer.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { glue, wasm } from '../harness/core.js';
import { test } from '../harness/once.js';
import { withTrap } from '../harness/trap.js';
import { callsOf, hostile, placesIn, refusal, withOther } from './hostile/calls.js';

/** An instance of its own, for what other tests have not freed takes memory too. @type {typeof import('../../../pkg/ep_locomotion.js')} */
const core = await import(`${glue}?alone`);
const { memory } = await core.default({ module: await readFile(wasm) });
const calls = callsOf(core);

/** The level that docs/javascript.md states, in bytes. */
const level = 256 * 2 ** 20;

/** What it has taken; it gives nothing back. */
const taken = () => memory.buffer.byteLength;

const axis = { from: -1, to: 1, count: 1024 };
const short = { horizon: 0.01, tolerance: { position: 0 } };

/** Calls that give back, or keep meanwhile, as much as one may. @type {readonly (() => unknown)[]} */
const largest = [
  () => core.robustness(short, { gains: [1, 1, 1], x: axis, y: axis, headings: 4, part: [0, 4_129_776] }),
  () => core.landscape(short, { x: { gain: 'kx', ...axis }, y: { gain: 'ky', ...axis }, gains: [1, 1, 1] }),
  () => core.evaluate(short, new Float64Array(3_000_000)),
  () => core.seedRuns({ ...short, evolution: { population: 2000 } }, { seeds: [0, 250], generations: 0 }),
  () =>
    core.seedRuns(
      { ...short, evolution: { population: 200, crossover: 1 } },
      { seeds: [0, 2500], generations: 1 },
    ),
  () => core.seedRuns({ ...short, evolution: { population: 1 } }, { seeds: [0, 50_000], generations: 0 }),
  () =>
    core.trials(
      { ...short, evolution: { population: 2000, method: 'de' } },
      { seeds: [0, 250], drives: 2500 },
    ),
  () => core.simulateAll({ horizon: 1000, tolerance: { position: 0 } }, new Float64Array(75)),
  () => core.errorParts({ horizon: 10, tolerance: { position: 0 }, starts: Array(600).fill({}) }, [1, 1, 1]),
  () => core.experiment({ starts: new Float64Array(30_000) }),
];

test('the largest calls leave the memory under its level, and a second time where it was', () => {
  // The largest of all finds less in one piece where others were before.
  for (const call of [...largest, largest[0]]) call();
  const first = taken();
  assert.ok(first <= level, `${first} bytes`);
  for (const call of largest) call();
  assert.equal(taken(), first);
});

test('what finds no memory any more says so', async () => {
  /** @type {typeof core} */
  const trap = await import(`${glue}?trap`);
  await trap.default({ module: withTrap(await readFile(wasm), 'evaluate') });
  const said = { name: 'RuntimeError', message: 'ep-locomotion: its memory is used up; free() what is kept' };
  assert.throws(() => trap.evaluate({}, [1, 2, 3]), said);
  assert.equal(trap.simulate({}, [1, 2, 3], 0).arrived, core.simulate({}, [1, 2, 3], 0).arrived);
});

test('hostile calls leave the memory under its level, however many', () => {
  const places = placesIn(calls);
  const count = Number(process.env.CALLS ?? 5000);
  // Every pair of a place and a value comes in turn, for the two numbers have no common divisor with the steps.
  for (let i = 0; i < count; i += 1) {
    const { call, given, path } = places[(i * 31) % places.length];
    refusal(
      call,
      withOther(given, path, hostile[(i * 7 + Math.floor(i / places.length)) % hostile.length]()),
    );
  }
  const after = taken();
  assert.ok(after <= level, `${after} bytes`);
  if (process.env.CALLS) console.log(`${count} calls, then ${(after / 2 ** 20).toFixed(0)} MiB`);
});

test('searches that are freed leave no trace', () => {
  const step = () => {
    const evolution = new core.Evolution({ ...short, evolution: { population: 2000, opponents: 1 } });
    evolution.step();
    evolution.free();
  };
  step();
  const before = taken();
  for (let i = 0; i < 300; i += 1) step();
  assert.equal(taken(), before);
});
