// Answers without a browser, from a channel whose answers the test gives.
/** @import { Run } from '../../../www/core/pool.js' */
import assert from 'node:assert/strict';
import { createAnswers } from '../../../www/core/answers.js';
import { Pending, whenThere } from '../../../www/core/pending.js';
import { test } from '../harness/once.js';

/** Questions of one number each. */
const answers = /** @type {() => (run: Run, call: string, number: number) => unknown} */ (
  /** @type {unknown} */ (createAnswers)
);

/** Runs only the newest of its jobs, which answers with its own argument once it is told to. */
function channel() {
  /** @type {{ number: unknown, resolve: (value: any) => void, reject: (error: unknown) => void }[]} */
  const jobs = [];
  const run = /** @type {Run} */ (
    /** @type {unknown} */ (
      (/** @type {{ parts: unknown[][] }} */ { parts: [[number]] }) => {
        jobs.at(-1)?.reject(new DOMException('A newer request took its place', 'AbortError'));
        return new Promise((resolve, reject) => jobs.push({ number, resolve, reject }));
      }
    )
  );
  const newest = () => /** @type {typeof jobs[number]} */ (jobs.at(-1));
  return {
    run,
    asked: () => jobs.map(({ number }) => number),
    answer: () => newest().resolve([newest().number]),
    refuse: (/** @type {string} */ reason) => newest().reject(new Error(reason)),
  };
}

/** Lets all run that waits for nothing but its turn. */
const settled = () => new Promise((resolve) => setImmediate(resolve));

/** An asker of a number, who asks again as soon as it is worth it. @param {ReturnType<typeof answers>} ask @param {Run} run @param {number} number */
function asker(ask, run, number) {
  /** @type {{ answers: unknown[], tries: number }} */
  const own = { answers: [], tries: 0 };
  whenThere(
    () => {
      own.tries += 1;
      own.answers.push(ask(run, 'evolve', number));
    },
    () => own.tries < 100,
  );
  return own;
}

test('a question is asked once, and its answer kept', async () => {
  const ask = answers();
  const { run, asked, answer } = channel();
  const askers = [asker(ask, run, 1), asker(ask, run, 1)];
  answer();
  await settled();
  askers.push(asker(ask, run, 1));
  assert.deepEqual(
    askers.map(({ answers }) => answers),
    [[1], [1], [1]],
  );
  assert.deepEqual(asked(), [1]);
});

test('an error of the core is thrown once, and then the question is asked again', async () => {
  const ask = answers();
  const { run, asked, answer, refuse } = channel();
  const once = () => ask(run, 'evolve', 1);
  assert.throws(once, Pending);
  refuse('horizon must be less');
  await settled();
  assert.throws(once, /horizon must be less/);
  assert.throws(once, Pending);
  answer();
  await settled();
  assert.equal(once(), 1);
  assert.deepEqual(asked(), [1, 1]);
});

test('errors that nobody has come back for keep no answer from being kept', async () => {
  const ask = answers();
  const { run, answer, refuse } = channel();
  for (let number = 1; number <= 40; number += 1) {
    assert.throws(() => ask(run, 'evolve', number), Pending);
    refuse('no worker can be started');
    await settled();
  }
  const { answers: given } = asker(ask, run, 100);
  answer();
  await settled();
  assert.deepEqual(given, [100]);
});

test('of several who ask in turn where only the newest question is answered, each has its answer in the end', async () => {
  const ask = answers();
  const { run, asked, answer } = channel();
  const askers = [1, 2, 3].map((number) => asker(ask, run, number));
  await settled();
  assert.deepEqual(asked(), [1, 2, 3], 'the older ones wait for the newest');
  for (let i = 0; i < 3; i++) {
    answer();
    await settled();
  }
  assert.deepEqual(
    askers.map(({ answers }) => answers),
    [[1], [2], [3]],
  );
});
