// What the tab keeps of the lesson is there whatever of the page is open.
import assert from 'node:assert/strict';
import { Key } from 'selenium-webdriver';
import { createKeepsake } from '../../../www/lesson/keepsake.js';
import { noProgress, progressSlice } from '../../../www/lesson/state.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine } from '../harness/core.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';

const engine = createEngine();

/** A figure of the tab, in which questions are answered. */
function figure() {
  const store = createStore(/** @type {any} */ ({ slices: {} }), () => {});
  const { follow } = createKeepsake(store, engine);
  return {
    answered: () => Object.keys(progressSlice.of(store.get()).answers).sort(),
    /** @param {Record<string, number>} given */
    answer(given) {
      const entries = Object.entries(given).map(([name, choice]) => [name, { choice, right: 1, why: '' }]);
      progressSlice.update(store, { answers: Object.fromEntries(entries) });
      follow(progressSlice.of(store.get()));
    },
  };
}

test('two figures in one tab keep the answers of both, and what one takes back is gone', (t) => {
  /** @type {Map<string, string>} */
  const kept = new Map();
  const sessionStorage = {
    getItem: (/** @type {string} */ name) => kept.get(name) ?? null,
    setItem: (/** @type {string} */ name, /** @type {string} */ text) => kept.set(name, text),
  };
  Object.assign(globalThis, { sessionStorage });
  t.after(() => Reflect.deleteProperty(globalThis, 'sessionStorage'));
  const [one, other] = [figure(), figure()];
  assert.equal(figure().answered().length, Object.keys(noProgress.answers).length);
  one.answer({ 'drive.bolder': 1, 'law.sign': 0 });
  other.answer({ 'cost.winner': 2 });
  assert.deepEqual(figure().answered(), ['cost.winner', 'drive.bolder', 'law.sign']);
  one.answer({ 'law.sign': 0 });
  assert.deepEqual(figure().answered(), ['cost.winner', 'law.sign']);
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
