// The pool without a browser, with threads that have the core.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { createPool } from '../../../www/core/pool.js';
import { createSurveys } from '../../../www/core/surveys.js';
import { Evolution, evaluate, experiment, landscape, robustness, seedRuns, wasm } from '../harness/core.js';
import { test } from '../harness/once.js';
import { Thread } from '../harness/threads.js';
import { withTrap } from '../harness/trap.js';

const bytes = await readFile(wasm);
const core = await WebAssembly.compile(bytes);
const preset = experiment('velocity-limits');

/** @param {import('node:test').TestContext} t @param {number} size @param {WebAssembly.Module[]} [cores] of the workers in their order; the last one is also that of all others */
function threads(t, size, cores = [core]) {
  /** @type {Thread[]} */
  const started = [];
  t.after(() => {
    for (const thread of started) thread.terminate();
  });
  const spawn = () => {
    started.push(new Thread(cores[Math.min(started.length, cores.length - 1)]));
    return started[started.length - 1];
  };
  return createSurveys(createPool({ spawn, size }));
}

const map = {
  x: { gain: /** @type {const} */ ('kx'), from: 0.1, to: 10, count: 37, log: true },
  y: { gain: /** @type {const} */ ('ktheta'), from: 0, to: 10, count: 29 },
  gains: [3, 0.1, 5],
};
const grid = {
  x: { from: -1, to: 1, count: 5 },
  y: { from: -1, to: 1, count: 7 },
  headings: 5,
  gains: [3, 0.1, 5],
};

for (const size of [1, 2, 8]) {
  test(`${size} workers compute the same bits as one call on the main thread`, async (t) => {
    const surveys = threads(t, size);
    assert.deepEqual(await surveys.landscape(preset, map), landscape(preset, map));
    assert.deepEqual(await surveys.robustness(preset, grid), robustness(preset, grid));
    assert.deepEqual(
      await surveys.seedRuns(preset, { first: 3, count: 20, generations: 4 }),
      seedRuns(preset, { seeds: [3, 23], generations: 4 }),
    );
    const gains = Float64Array.of(3, 0.1, 5, 10, 10, 10);
    assert.deepEqual(await surveys.evaluate(preset, gains), evaluate(preset, gains));

    const others = [1, 2, 3].map((seed) => ({ ...preset, evolution: { ...preset.evolution, seed } }));
    assert.deepEqual(
      await surveys.evolveAll(others, 6),
      others.map((one) => evolved(one, 6)),
    );
    assert.deepEqual(await surveys.evolve(preset, 0), evolved(preset, 0));
  });
}

/** @param {import('../../../www/core/surveys.js').Experiment} from @param {number} generations */
function evolved(from, generations) {
  const evolution = new Evolution(from);
  const records = [evolution.statistics()];
  for (let i = 0; i < generations; i++) records.push(evolution.step());
  const { best, evaluations } = records[generations];
  const history = {
    best: Float64Array.from(records, (one) => one.best.cost),
    median: Float64Array.from(records, (one) => one.median),
  };
  return { ...best, history, evaluations, hash: evolution.hash() };
}

test('what the core says of bad input arrives as it was said', async (t) => {
  const surveys = threads(t, 2);
  const { NaN: none, POSITIVE_INFINITY: endless } = Number;
  const wrong = /** @type {import('../../../www/core/surveys.js').Experiment} */ ({
    ...preset,
    horizon: none,
  });
  await assert.rejects(surveys.landscape(wrong, map), /^Error: horizon must be .* but was NaN$/);
  for (const count of [none, endless, -1, 0, 2.5, 1e9]) {
    await assert.rejects(surveys.landscape(preset, { ...map, y: { ...map.y, count } }), /count must be/);
    await assert.rejects(surveys.robustness(preset, { ...grid, x: { ...grid.x, count } }), /count must be/);
  }
  await assert.rejects(surveys.evaluate(preset, [1, 2]), /three numbers for each robot, but was 2 numbers/);
  for (const generations of [none, endless, -1, 2.5]) {
    await assert.rejects(surveys.evolve(preset, generations), /generations must be a whole number/);
    await assert.rejects(
      surveys.seedRuns(preset, { first: 0, count: 1, generations }),
      /generations must be/,
    );
  }
  await assert.rejects(surveys.seedRuns(preset, { first: 0, count: 1e9, generations: 9 }), /must be/);
  assert.deepEqual(await surveys.landscape(preset, map), landscape(preset, map));
});

test('an evolution without end tells how it goes on, and can be aborted', async (t) => {
  const surveys = threads(t, 1);
  const control = new AbortController();
  const options = { signal: control.signal, onProgress: () => control.abort() };
  await assert.rejects(surveys.evolve(preset, 1e7, options), { name: 'AbortError' });
  assert.deepEqual(await surveys.evolve(preset, 1), evolved(preset, 1));
});

test('a worker whose core broke down fails its job; what one without a core cannot do is done by another', async (t) => {
  const trap = await WebAssembly.compile(withTrap(bytes, 'robustness'));
  const empty = new WebAssembly.Module(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));

  const surveys = threads(t, 1, [trap, empty, core]);
  await assert.rejects(surveys.robustness(preset, grid), /^Error: A worker was lost: an error in the core$/);
  assert.deepEqual(await surveys.robustness(preset, grid), robustness(preset, grid));
});
