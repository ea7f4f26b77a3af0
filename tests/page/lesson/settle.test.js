// When a prediction is answered, and when it is free again.
import assert from 'node:assert/strict';
import { Pending } from '../../../www/core/pending.js';
import { isAskedIn } from '../../../www/lesson/questions/asked-in.js';
import { restOf, settle } from '../../../www/lesson/questions/settle.js';
import { progressSlice } from '../../../www/lesson/state.js';
import { lapsed } from '../../../www/lesson/words/en.js';
import { duel } from '../../../www/lesson/words/en/duel.js';
import { Key, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { liveOf } from './live.js';

/** @typedef {import('../../../www/lesson/page.js').Live} Live */
/** @typedef {import('../../../www/lesson/questions/quiz.js').Quiz} Quiz */

const asked = { choice: 1, right: null, why: '' };
const key = 'drive.bolder';

/** A page with one question, which is asked. @param {Live} live @param {Quiz['answer']} answer @param {Partial<Quiz>} [more] */
function pageOf(live, answer, more) {
  const { slices } = live.state;
  const own = { ...asked };
  const first = { ...progressSlice.first, answers: { [key]: own } };
  let state = { ...live.state, slices: { ...slices, [progressSlice.name]: first } };
  /** @type {string[]} */
  const said = [];
  const quiz = { ...more, answer };
  isAskedIn(own, state, quiz);
  const tools = /** @type {any} */ ({
    store: {
      get: () => state,
      keep: (/** @type {string} */ name, /** @type {unknown} */ slice) => {
        state = { ...state, slices: { ...state.slices, [name]: slice } };
      },
    },
    actions: { say: (/** @type {string} */ text) => said.push(text) },
  });
  const step = /** @type {any} */ ({ name: 'drive', blocks: [{ kind: 'quiz', name: 'bolder', quiz }] });
  return {
    said,
    lapsed: () => progressSlice.of(state).lapsed,
    /** Draws a frame. @param {Partial<Live['state']>} [patch] */
    frame: async (patch) => {
      state = { ...state, ...patch };
      settle({ ...live, state }, step, tools);
      await new Promise((resolve) => setImmediate(resolve));
      return progressSlice.of(state).answers[key];
    },
  };
}

const live = liveOf('lab&drives=hand&gains=3,1,5');

test('a prediction is answered from the run that it was made about, and free once that is another', async () => {
  const answer = async () => {
    throw new Error('nothing is to be computed');
  };
  const ready = () => false;
  const waits = () => pageOf(live, answer, { ready, of: ({ page }) => [page] });
  const { experiment } = live.state;
  const same = structuredClone(experiment);
  for (const patch of [{}, { experiment: same }, { generation: 1 }])
    assert.notEqual(await waits().frame(patch), undefined);
  for (const patch of [
    { experiment: { ...experiment, goal: { x: 1, y: 1, theta: 0 } } },
    { driver: /** @type {const} */ ('paper-ep') },
    { handGains: /** @type {[number, number, number]} */ ([3, 1, 4]) },
    { work: { ...live.state.work, opened: 60 } },
    { page: 'curves' },
  ]) {
    const page = waits();
    assert.equal(await page.frame(patch), undefined, Object.keys(patch).join());
    assert.equal(page.lapsed(), key);
    assert.deepEqual(page.said, []);
  }
});

test('nothing is answered from a run that is still being computed', async () => {
  const page = pageOf(live, () => assert.fail('too early'));
  const computing = { what: /** @type {const} */ ('begin'), since: 0, share: () => null };
  assert.equal((await page.frame({ computing }))?.right, null);
});

test('a question whose computation fails says so, at once or later, and can be asked again', async () => {
  const later = pageOf(live, () => Promise.reject(new Error('no worker')));
  assert.equal(await later.frame(), undefined);
  assert.deepEqual(later.said, ['no worker']);
  const atOnce = pageOf(live, () => {
    throw new Error('no such run');
  });
  assert.equal(await atOnce.frame(), undefined);
  assert.deepEqual(atOnce.said, ['no such run']);
});

test('what an answer needs and is still being computed is asked for again', async () => {
  let there = false;
  const answer = () => {
    if (!there) throw new Pending(Promise.resolve());
    return { right: 0, gentle: live.scene.driving, bold: live.scene.driving };
  };
  const page = pageOf(live, answer);
  await assert.rejects(page.frame(), Pending);
  assert.deepEqual(page.said, []);
  there = true;
  assert.equal((await page.frame())?.right, 0);
});

pageTest(
  'who has not predicted is told nothing; whose run was changed before the answer, that',
  async (page) => {
    const said = () =>
      page.evaluate(() => [...document.querySelectorAll('.quiz-why')].map((one) => one.textContent?.trim()));
    await page.open('#lesson&step=1');
    assert.deepEqual([...new Set(await said())], ['']);
    // So slowly that the answer does not come before the change.
    await page.setPace(0.02);
    await page.click('#quiz-bolder .choice:first-child');
    await page.until('it is watched', () => document.querySelector('#quiz-bolder [aria-disabled="true"]'));
    await page.focus('#slider-kx');
    await page.press(Key.ARROW_RIGHT);
    await page.until(
      'it is said',
      (wanted) => document.querySelector('#quiz-bolder .quiz-why')?.textContent?.trim() === wanted,
      lapsed,
    );
    assert.equal(
      await page.evaluate(() => document.querySelectorAll('#quiz-bolder [aria-disabled="true"]').length),
      0,
    );
  },
  { moves: true },
);

pageTest(
  'who goes on to another question has seen enough of the drive that answers the one before',
  async (page) => {
    await page.open('#lesson&step=limits');
    await page.setPace(0.02);
    await page.click('#quiz-free .choice:first-child');
    await page.until('it is watched', () => document.querySelector('#quiz-free [aria-disabled="true"]'));
    await page.click('#quiz-heals .choice:first-child');
    await page.until('its answer', () => document.querySelector('#quiz-free .right'));
  },
  { moves: true },
);

pageTest('a duel is predicted by who has driven', async (page) => {
  await page.open('#lesson&step=duel');
  await page.click('#quiz-ahead .choice:first-child');
  const why = () => page.text('#quiz-ahead .quiz-why');
  assert.equal(await why(), duel.quizzes.ahead.first);
  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT);
  await page.until('a trial', () => document.getElementById('duel-drives')?.textContent === '1');
  assert.equal(await why(), '');
  await page.click('#quiz-ahead .choice:first-child');
  await page.until('its answer', () => document.querySelector('#quiz-ahead .right'));
  // The prediction has locked it in, and another contest can be begun.
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('[data-try="dear"]')).click());
  await page.until('that it is another contest', () =>
    /Start over/.test(document.getElementById('duel-status')?.textContent ?? ''),
  );
  await page.click('#duel-new');
  await page.until('a new contest', () => document.getElementById('duel-lock')?.checkVisibility());
});

test('what still turns is not at rest', () => {
  const still = Float64Array.of(1, 1, 1, 1);
  const run = { time: Float64Array.of(0, 1, 2, 3), x: still, y: still, theta: Float64Array.of(0, 1, 2, 3) };
  assert.equal(restOf(/** @type {any} */ (run)), 3);
});
