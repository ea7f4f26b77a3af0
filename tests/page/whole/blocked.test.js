// Whatever is asked for, the page's own thread is never held for long: what takes long goes to workers, and comes to the same.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { probe } from '../../../.tasks/probe.mjs';
import { isLongDrive, isLongEvolution, isLongRecord, isLongReplay } from '../../../www/core/bounds.js';
import { Pending } from '../../../www/core/pending.js';
import { links } from '../../../www/lesson/links.js';
import { pageTest } from '../harness/browsers.js';
import { createEngine, Evolution, experiment, Simulation, simulateAll, stability } from '../harness/core.js';
import { test } from '../harness/once.js';
import { beginningWith } from '../harness/server.js';
import { holdWorkers } from '../harness/workers.js';

/** @typedef {import('../../../www/core/engine.js').Experiment} Experiment */
/** @typedef {import('../../../www/core/engine.js').Triple} Triple */

const usual = experiment('velocity-limits');
/** @type {Triple} */
const gains = [5, 5, 5];

/** @param {Partial<Experiment['evolution']>} patch @param {number} [starts] @returns {Experiment} */
const evolving = (patch, starts = 1) => ({
  ...usual,
  starts: Array.from({ length: starts }, (_, i) => ({ x: i % 7, y: i % 11, theta: 0 })),
  evolution: { ...usual.evolution, ...patch },
});
/** @type {Experiment} */
const long = { ...usual, sampleTime: 0.001, horizon: 30, goal: { x: 90, y: 90, theta: 0 } };

/** What it comes to, however often one has to ask. @template T @param {() => T} ask @returns {Promise<{ value: T, waits: number }>} */
async function asked(ask) {
  for (let waits = 0; ; waits += 1) {
    try {
      return { value: ask(), waits };
    } catch (error) {
      if (!(error instanceof Pending)) throw error;
      await error.arrival;
    }
  }
}

/** Workers give its opponents otherwise. @param {import('../../../www/core/engine.js').GenerationRecord} record */
const listed = (record) => ({ ...record, opponents: record.opponents.map((met) => [...met]) });

test('a record is that of the run which is asked for, also once another has begun, or the same over again', async () => {
  const engine = createEngine();
  const [first, other] = [evolving({ seed: 1 }), evolving({ seed: 5 })];
  engine.begin(first);
  for (let i = 0; i < 3; i += 1) engine.step();
  const record = engine.record(3);
  for (const next of [other, first]) {
    engine.begin(next);
    assert.deepEqual(listed((await asked(() => engine.record(3, first))).value), record);
  }
});

test('where the reference turns so far in a sample that robots drive alone, a generation is long eight times as early', async () => {
  const core = await readFile(new URL('../../../src/number/real.rs', import.meta.url), 'utf8');
  const [, above, below] = /const SMALL_TURN: f64 = ([\d.]+) \/ ([\d.]+);/.exec(core) ?? [];
  const farTurn = Number(above) / Number(below);
  const turning = (/** @type {number} */ angular, /** @type {number} */ population) => ({
    ...evolving({ population, opponents: 1 }),
    referenceVelocity: { linear: 0.5, angular },
  });
  // A robot drives 1000 samples.
  const rate = farTurn / usual.sampleTime;
  for (const angular of [0.99 * rate, -0.99 * rate, 0])
    assert.ok(!isLongEvolution(turning(angular, 1000)), `${angular} rad/s`);
  for (const angular of [1.01 * rate, -1.01 * rate]) {
    assert.ok(isLongEvolution(turning(angular, 1000)), `${angular} rad/s`);
    assert.ok(!isLongEvolution(turning(angular, 170)), `${angular} rad/s`);
  }
});

test('what is usual is done at once, what is heavy is not', () => {
  for (const preset of /** @type {const} */ (['velocity-limits', 'acceleration-limits'])) {
    const own = experiment(preset);
    assert.ok(!isLongEvolution(own));
    assert.ok(!isLongDrive(own, own.evolution.population));
    assert.ok(!isLongRecord(own, 15));
  }
  for (const heavy of [
    evolving({ population: 2000 }),
    evolving({ population: 2000, opponents: 1000 }),
    evolving({}, 3300),
    evolving({ population: 121 }, 3300),
    evolving({ population: 2000 }, 200),
    { ...long, horizon: 100 },
  ])
    assert.ok(isLongEvolution(heavy), JSON.stringify(heavy.evolution));
  for (const heavy of [long, { ...long, horizon: 100 }]) assert.ok(isLongDrive(heavy));
  assert.ok(isLongDrive(usual, 101));
  assert.ok(isLongReplay(evolving({ population: 200 }), 63));
  assert.ok(!isLongReplay(evolving({ population: 2000 }), 0));
  assert.ok(isLongRecord(evolving({ population: 2000, opponents: 274 }), 0));
});

test('an evolution in a worker comes to the same bits, generation by generation, back and forth', async () => {
  const heavy = evolving({ population: 300 }, 8);
  assert.ok(isLongEvolution(heavy));
  const engine = createEngine();
  const own = new Evolution(heavy);
  const begun = await asked(() => engine.begin(heavy));
  assert.equal(begun.waits, 1);
  assert.deepEqual(begun.value, { statistics: own.statistics(), population: own.population() });
  for (let generation = 1; generation <= 3; generation += 1) {
    const { value, waits } = await asked(() => engine.step());
    assert.equal(waits, 1);
    assert.deepEqual(value, own.step());
    assert.deepEqual(engine.population(generation), own.population());
    assert.equal(engine.hash(), own.hash());
  }
  const { value: population } = await asked(() => engine.population(1));
  assert.deepEqual(population, own.population(1));
  const { value: record } = await asked(() => engine.record(2));
  assert.deepEqual(listed(record), own.record(2));
  assert.deepEqual((await asked(() => engine.step())).value, own.step());
  assert.equal(engine.hash(), own.hash());
  // Begun again, it is at its beginning.
  await asked(() => engine.begin(heavy));
  assert.equal(engine.hash(), new Evolution(heavy).hash());
  assert.deepEqual((await asked(() => engine.step())).value.generation, 1);
});

test('a long drive in a worker comes to the same, and so do its samples and its stability', async () => {
  const engine = createEngine();
  const drive = await asked(() => engine.drive(long, [gains]));
  assert.equal(drive.waits, 1);
  assert.deepEqual(drive.value, simulateAll(long, gains));
  assert.deepEqual((await asked(() => engine.stability(long, gains))).value, stability(long, gains));
  const { value: samples } = await asked(() => engine.samples(long, gains));
  const robot = new Simulation(long, gains);
  for (const seen of samples.map((one) => one)) assert.deepEqual(seen, robot.step());
  assert.notEqual(samples.at(-1).outcome, null);
});

test('what the core refuses is refused in the same words', async () => {
  const engine = createEngine();
  const wrong = evolving({ population: 2000, opponents: 4000 });
  await assert.rejects(
    asked(() => engine.begin(wrong)),
    { message: messageFrom(() => new Evolution(wrong)) },
  );
});

/** @param {() => unknown} act */
function messageFrom(act) {
  try {
    act();
  } catch (error) {
    return error instanceof Error ? error.message : '';
  }
  throw new Error('it was not refused');
}

test('what is wrong with a link is said shortly, however much it is', () => {
  const engine = createEngine();
  const many = Array.from({ length: 4600 }, (_, i) => `a${i}=`).join('&');
  for (const link of [
    `lab&v=1&${many}`.slice(0, 19_999),
    `lab&v=1&${'k'.repeat(19_000)}=1`,
    `lab&v=1&seed=${'1x'.repeat(9000)}`,
    'p'.repeat(19_000),
  ]) {
    const { problems } = links.openLink(link, engine);
    assert.ok(problems.length > 0);
    assert.ok(problems.join(' ').length < 800, problems.join(' '));
  }
});

pageTest('a heavy link opens once a worker has begun it, and Escape stops what goes on', async (page) => {
  const heavy = `start=${Array.from({ length: 200 }, (_, i) => `${i % 9},${i % 8},0`).join(';')}`;
  await page.open(`#lab&v=1&population=1000&${heavy}`);
  const population = await page.until('the experiment has begun', () =>
    /1000/.test(document.getElementById('evolution-note')?.textContent ?? ''),
  );
  assert.ok(population);
  await holdWorkers(page);
  await page.click('#run');
  await page.until('it says what it computes', () => !document.getElementById('computing')?.hidden);
  await page.evaluate(() => {
    dispatchEvent(new KeyboardEvent('keydown', { key: 'Escape' }));
  });
  await page.until('it has stopped, and says so', () => {
    const isStopped = document.getElementById('computing')?.hidden;
    return isStopped && /^Stopped/.test(document.getElementById('message')?.textContent ?? '');
  });
});

pageTest('what npm run heavy puts before the page leaves it as it is, and sees the core at work', (page) =>
  beginningWith(page, probe, async () => {
    await page.open('#lab');
    assert.ok((await page.evaluate(() => Reflect.get(window, 'longest'))) > 0);
  }),
);
