// What the tab keeps of the lesson is there whatever of the page is open.
import assert from 'node:assert/strict';
import { Key } from 'selenium-webdriver';
import { createKeepsake } from '../../../www/lesson/keepsake.js';
import { noProgress, noTally, progressSlice } from '../../../www/lesson/state.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine, experiment as experimentOf } from '../harness/core.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';

const engine = createEngine();
const experiment = experimentOf('velocity-limits');

/** A figure of the tab, in which questions are answered. */
function figure() {
  const store = createStore(/** @type {any} */ ({ slices: {} }), () => {});
  const { follow } = createKeepsake(store, engine);
  return {
    answered: () => Object.keys(progressSlice.of(store.get()).answers).sort(),
    /** How often it drove in which experiment, the last driven first, and how often in the duel. */
    driven() {
      const { tallies, duel } = progressSlice.of(store.get());
      return [tallies.map(({ experiment, drives }) => `${experiment} ${drives}`).join(), duel?.costs.length];
    },
    /** @param {Record<string, number>} drives @param {readonly number[] | null} [locked] J of each trial in a duel. */
    drive(drives, locked = null) {
      const tallies = Object.entries(drives).map(([name, count]) => ({
        ...noTally,
        experiment: name,
        drives: count,
        costs: Array.from({ length: count }, () => Number.POSITIVE_INFINITY),
      }));
      const duel = locked && { experiment, costs: locked, gains: null, rounds: [], goesOn: false };
      progressSlice.update(store, { tallies, duel });
      follow(progressSlice.of(store.get()));
    },
    /** @param {Record<string, number>} given */
    answer(given) {
      const entries = Object.entries(given).map(([name, choice]) => [name, { choice, right: 1, why: '' }]);
      progressSlice.update(store, { answers: Object.fromEntries(entries) });
      follow(progressSlice.of(store.get()));
    },
  };
}

/** What a tab keeps. @param {import('node:test').TestContext} t */
function withTab(t) {
  /** @type {Map<string, string>} */
  const kept = new Map();
  const sessionStorage = {
    getItem: (/** @type {string} */ name) => kept.get(name) ?? null,
    setItem: (/** @type {string} */ name, /** @type {string} */ text) => kept.set(name, text),
  };
  Object.assign(globalThis, { sessionStorage });
  t.after(() => Reflect.deleteProperty(globalThis, 'sessionStorage'));
}

test('two figures in one tab keep the answers of both, and what one takes back is gone', (t) => {
  withTab(t);
  const [one, other] = [figure(), figure()];
  assert.equal(figure().answered().length, Object.keys(noProgress.answers).length);
  one.answer({ 'drive.bolder': 1, 'law.sign': 0 });
  other.answer({ 'cost.winner': 2 });
  assert.deepEqual(figure().answered(), ['cost.winner', 'drive.bolder', 'law.sign']);
  one.answer({ 'law.sign': 0 });
  assert.deepEqual(figure().answered(), ['cost.winner', 'law.sign']);
});

test('two figures in one tab keep the drives and the duel of both, and what one takes back is gone', (t) => {
  withTab(t);
  const [one, other] = [figure(), figure()];
  one.drive({ a: 3, b: 1 }, [9, 8]);
  other.drive({ c: 2 });
  assert.deepEqual(figure().driven(), ['c 2,a 3,b 1', 2]);
  other.answer({ 'cost.winner': 2 });
  one.drive({ b: 1 });
  assert.deepEqual(figure().driven(), ['b 1,c 2', undefined]);
  other.drive({ c: 2, d: 1 }, [7]);
  one.drive({ b: 2 });
  assert.deepEqual(figure().driven(), ['b 2,c 2,d 1', 1]);
  one.drive(Object.fromEntries([...'efghijk'].map((name) => [name, 1])));
  assert.equal(String(figure().driven()), 'e 1,f 1,g 1,h 1,i 1,j 1,k 1,c 2,1');
});

test('a figure that opened with what another had done does not write that over what it did since', (t) => {
  withTab(t);
  const one = figure();
  one.drive({ a: 2 }, [9]);
  const other = figure();
  one.drive({ a: 4 }, [9, 8]);
  other.answer({ 'cost.winner': 2 });
  assert.deepEqual(figure().driven(), ['a 4', 2]);
});

pageTest(
  'answers are handed in also where the page was loaded again while no step was open',
  async (page) => {
    await page.open('#lab&v=1&lesson=9&who=s1&task=Answer%20all.&aim=J%3C9');
    await page.until('the question', () => document.querySelector('#quiz-ahead .choice'));
    await page.focus('#slider-kx');
    await page.press(Key.ARROW_RIGHT);
    await page.until(
      'it can be answered',
      () => !document.querySelector('#quiz-ahead [aria-disabled="true"]'),
    );
    await page.click('#quiz-ahead .choice:nth-child(2)');
    await page.until('it is answered', () => document.querySelector('#quiz-ahead .quiz-why strong'));
    await page.click('#page-landscape');
    await page.until('no step is in the address', () => /^#landscape(?!.*lesson=)/.test(location.hash));
    await page.driver.navigate().refresh();
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.until('it can be handed in', () => document.getElementById('hand-in'));
    await page.click('#hand-in');
    const receipt = await page.until(
      'the receipt',
      () => /** @type {HTMLInputElement | null} */ (document.getElementById('handin-link'))?.value,
    );
    assert.match(decodeURIComponent(receipt), /~duel\.ahead:\d[+-]~/);
  },
);
