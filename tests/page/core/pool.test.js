// The pool without a browser, with workers whose answers the test gives.
import assert from 'node:assert/strict';
import { createPool } from '../../../www/core/pool.js';
import { test } from '../harness/once.js';

/** @typedef {import('../../../www/core/worker.js').Answer} Answer */
/** @typedef {import('../../../www/core/worker.js').Part} Part */

/** A worker that does nothing but what the test says. */
class Puppet extends EventTarget {
  /** @type {Part[]} */
  parts = [];
  terminated = false;
  answered = 0;

  /** @param {Part} part */
  postMessage(part) {
    this.parts.push(structuredClone(part));
  }

  terminate() {
    this.terminated = true;
  }

  /** @param {Answer} data */
  say(data) {
    if (!('progress' in data || 'life' in data)) this.answered += 1;
    this.dispatchEvent(new MessageEvent('message', { data }));
  }

  /** Answers the next part with the number that it was given, as all jobs here have one. */
  finish() {
    this.say({ result: this.parts[this.answered].args[0] });
  }

  /** @param {string} message */
  crash(message) {
    this.dispatchEvent(Object.assign(new Event('error', { cancelable: true }), { message }));
  }
}

/** @param {number} size */
function puppets(size) {
  /** @type {Puppet[]} */
  const workers = [];
  const spawn = () => {
    workers.push(new Puppet());
    return workers[workers.length - 1];
  };
  return { workers, pool: createPool({ spawn, size }), given: () => workers.map(numbersGiven) };
}

/** @param {Puppet} worker */
const numbersGiven = ({ parts }) => parts.map(({ args }) => args[0]);

/** A job whose parts are these numbers. @param {unknown[]} numbers */
const job = (...numbers) =>
  /** @type {import('../../../www/core/pool.js').Job<'evolve'>} */ (
    /** @type {unknown} */ ({ call: 'evolve', parts: numbers.map((number) => [number]) })
  );

const aborted = { name: 'AbortError' };

test('workers start at the first job, as many as it has parts for, and are kept', async () => {
  const { workers, pool, given } = puppets(3);
  assert.equal(workers.length, 0);
  const first = pool.run(job(1, 2));
  assert.deepEqual(given(), [[1], [2]]);
  for (const worker of workers) worker.finish();
  await first;
  const second = pool.run(job(3, 4, 5, 6));
  assert.deepEqual(given(), [[1, 3], [2, 4], [5]]);
  for (const i of [0, 1, 2, 0]) workers[i].finish();
  assert.deepEqual(await second, [3, 4, 5, 6]);
  assert.equal(workers.length, 3);
});

test('results stand in the order of the parts, whoever is first', async () => {
  const { workers, pool } = puppets(2);
  const run = pool.run(job(1, 2, 3, 4));
  for (const i of [1, 1, 0, 1]) workers[i].finish();
  assert.deepEqual(await run, [1, 2, 3, 4]);
  assert.deepEqual(await pool.run(job()), []);
});

test('each result is told as it comes, until the job is aborted', async () => {
  const { workers, pool } = puppets(2);
  /** @type {[number, number][]} */
  const told = [];
  const control = new AbortController();
  const onPart = (/** @type {number} */ result, /** @type {number} */ index) => told.push([index, result]);
  const run = pool.run(job(5, 6, 7, 8), { onPart, signal: control.signal });
  for (const i of [1, 0]) workers[i].finish();
  control.abort();
  await assert.rejects(run, aborted);
  workers[0].finish();
  assert.deepEqual(told, [
    [1, 6],
    [0, 5],
  ]);
});

test('progress counts what a worker has done of its part, never falls and ends at 1', async () => {
  const { workers, pool } = puppets(2);
  /** @type {number[]} */
  const told = [];
  const run = pool.run(job(1, 2, 3, 4), { onProgress: (done) => told.push(done) });
  workers[0].say({ progress: 0.5 });
  workers[1].say({ progress: 0.25 });
  workers[0].finish();
  for (const i of [1, 0, 1]) workers[i].finish();
  await run;
  assert.deepEqual(told, [0.125, 0.1875, 0.3125, 0.5, 0.75, 1]);
});

test('in a channel the newest request wins, and no worker ends for it', async (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { workers, pool, given } = puppets(1);
  const channel = pool.channel();
  const first = assert.rejects(channel.run(job(1, 2)), aborted);
  const second = assert.rejects(channel.run(job(3)), aborted);
  const third = channel.run(job(4));
  await Promise.all([first, second]);
  t.mock.timers.tick(1000);
  for (let i = 0; i < 3; i++) workers[0].finish();
  assert.deepEqual(await third, [4]);
  assert.deepEqual(given(), [[1, 2, 4]]);
  assert.equal(workers[0].terminated, false);
});

test('a worker has the next part of a channel already while it does one, in turn', async () => {
  const { workers, pool, given } = puppets(2);
  const run = pool.channel().run(job(1, 2, 3, 4, 5));
  assert.deepEqual(given(), [
    [1, 3],
    [2, 4],
  ]);
  for (const i of [1, 1, 1, 0, 0]) workers[i].finish();
  assert.deepEqual(await run, [1, 2, 3, 4, 5]);
  assert.deepEqual(given(), [
    [1, 3],
    [2, 4, 5],
  ]);
});

test('channels do not disturb each other, and go before other jobs', async () => {
  const { workers, pool, given } = puppets(1);
  const long = pool.run(job(1, 2, 3));
  const quick = [pool.channel(), pool.channel()].map((channel, i) => channel.run(job(10 + i)));
  // What takes no newer one's place goes before them too.
  quick.push(pool.soon(job(12)), pool.soon(job(13)));
  for (let i = 0; i < 7; i++) workers[0].finish();
  assert.deepEqual(await Promise.all([long, ...quick]), [[1, 2, 3], [10], [11], [12], [13]]);
  assert.deepEqual(given(), [[1, 10, 11, 12, 13, 2, 3]]);
});

test('an abort rejects at once, and ends only a worker that does not answer', async (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { workers, pool, given } = puppets(2);
  const control = new AbortController();
  const run = pool.run(job(1, 2, 3), { signal: control.signal, onProgress: () => assert.fail('told') });
  control.abort();
  await assert.rejects(run, aborted);
  workers[0].finish();
  t.mock.timers.tick(99);
  assert.equal(workers[1].terminated, false);
  const next = pool.run(job(4, 5));
  assert.deepEqual(given(), [[1, 4], [2]]);
  t.mock.timers.tick(1);
  assert.deepEqual(
    workers.map(({ terminated }) => terminated),
    [false, true, false],
  );
  assert.deepEqual(given(), [[1, 4], [2], [5]]);
  workers[1].finish();
  workers[0].finish();
  workers[2].finish();
  assert.deepEqual(await next, [4, 5]);

  await assert.rejects(pool.run(job(6), { signal: AbortSignal.abort() }), aborted);
  assert.deepEqual(given(), [[1, 4], [2], [5]]);
});

test('an error of the core rejects its job and drops the rest of it; the worker goes on', async () => {
  const { workers, pool, given } = puppets(1);
  const refused = pool.run(job(1, 2));
  const next = pool.run(job(3));
  workers[0].say({ error: 'horizon must be less', lost: false });
  await assert.rejects(refused, { name: 'Error', message: 'horizon must be less' });
  workers[0].finish();
  assert.deepEqual(await next, [3]);
  assert.deepEqual(given(), [[1, 3]]);
});

for (const [what, break_] of /** @type {[string, (worker: Puppet) => void][]} */ ([
  ['crashed', (worker) => worker.crash('out of memory')],
  ['cannot be started', (worker) => worker.dispatchEvent(new Event('error', { cancelable: true }))],
  ['cannot be understood', (worker) => worker.dispatchEvent(new MessageEvent('messageerror'))],
])) {
  test(`what a worker that ${what} had to do is done by another`, async () => {
    const { workers, pool, given } = puppets(2);
    /** @type {number[]} */
    const told = [];
    const run = pool.run(job(1, 2, 3), { onProgress: (done) => told.push(done) });
    workers[0].say({ progress: 0.6 });
    break_(workers[0]);
    assert.ok(workers[0].terminated);
    assert.deepEqual(given(), [[1], [2], [1]]);
    workers[2].finish();
    workers[1].finish();
    workers[2].finish();
    assert.deepEqual(await run, [1, 2, 3]);
    assert.deepEqual(told, [...told].sort(), 'progress falls');
  });

  test(`a part of which a worker ${what} twice fails its own job, and only that`, async () => {
    const { workers, pool, given } = puppets(2);
    const failing = pool.run(job(1));
    const other = pool.run(job(2));
    for (const i of [0, 2]) {
      if (what !== 'cannot be started') workers[i].say({ life: null });
      break_(workers[i]);
    }
    const why = what === 'cannot be started' ? /No worker can be started\. The server / : /worker was lost/;
    await assert.rejects(failing, why);
    assert.deepEqual(given(), [[1], [2], [1]]);
    workers[1].finish();
    assert.deepEqual(await other, [2]);
  });
}

test('a worker that had more than one short part leaves them all to others', async () => {
  const { workers, pool, given } = puppets(1);
  const run = pool.channel().run(job(1, 2, 3));
  workers[0].finish();
  workers[0].crash('out of memory');
  assert.deepEqual(given(), [
    [1, 2, 3],
    [2, 3],
  ]);
  workers[1].finish();
  workers[1].finish();
  assert.deepEqual(await run, [1, 2, 3]);
});

test('a worker that says no word is replaced, the next one has twice as long, and who has spoken takes its time', async (t) => {
  t.mock.timers.enable({ apis: ['setTimeout'] });
  const { workers, pool, given } = puppets(2);
  const run = pool.run(job(1, 2));
  workers[1].say({ life: null });
  t.mock.timers.tick(9_999);
  assert.equal(workers[0].terminated, false);
  t.mock.timers.tick(1);
  assert.ok(workers[0].terminated);
  assert.deepEqual(given(), [[1], [2], [1]]);
  t.mock.timers.tick(19_999);
  assert.equal(workers[2].terminated, false);
  workers[2].finish();
  t.mock.timers.tick(100_000);
  assert.deepEqual([workers[1].terminated, workers[2].terminated], [false, false]);
  workers[1].finish();
  assert.deepEqual(await run, [1, 2]);

  const silent = pool.run(job(3, 4, 5));
  for (const worker of workers.slice(1, 3)) worker.crash('out of memory');
  t.mock.timers.tick(20_000);
  t.mock.timers.tick(40_000);
  await assert.rejects(silent, /it did not begin/);
});

test('a worker that lost its core is replaced, and only its own job fails', async () => {
  const { workers, pool, given } = puppets(2);
  const failing = pool.run(job(1));
  const other = pool.run(job(2, 3));
  workers[0].say({ error: 'internal error', lost: true });
  await assert.rejects(failing, /internal error/);
  assert.ok(workers[0].terminated);
  assert.deepEqual(given(), [[1], [2], [3]]);
  workers[2].finish();
  workers[1].finish();
  assert.deepEqual(await other, [2, 3]);
});

test('a worker that cannot be made, or an argument that cannot be sent, rejects the job', async () => {
  const pool = createPool({
    spawn() {
      throw new Error('this browser has no workers.');
    },
    size: 2,
  });
  const none = /^Error: No worker can be started: this browser has no workers\. The server /;
  for (const run of [pool.run, pool.channel().run]) await assert.rejects(run(job(1)), none);

  const { workers, pool: other } = puppets(1);
  await assert.rejects(other.run(job(() => {})), { name: 'DataCloneError' });
  const run = other.run(job(1));
  workers[0].finish();
  assert.deepEqual(await run, [1]);
});
