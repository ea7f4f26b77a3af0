import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { swarm } from '../../../www/lesson/words/en.js';
import { contest, evolvedBest, yard } from './duel-task.js';

/** One drive by hand, locked in, and a prediction. @param {import('../harness/browsers.js').Page} page */
async function predict(page) {
  await page.open('#lesson&step=9');
  await page.until('the robots', () => document.getElementById('swarm-parked'));
  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT);
  await page.click('#duel-lock');
  await page.click('#quiz-ahead .choice:first-child');
}

pageTest('evolution’s robots drive where they were bred, whatever the limits are now', async (page) => {
  await predict(page);
  const { gains } = evolvedBest(1, 20);
  const hasParked = (/** @type {string} */ name, /** @type {string} */ parked) =>
    document.querySelector('.swarm-name')?.textContent === name &&
    document.getElementById('swarm-parked')?.textContent === parked;
  const theirs = /** @type {const} */ ([swarm.evolution(gains), String(yard.drive(contest, gains)?.parked)]);
  await page.until('evolution’s robots', hasParked, ...theirs);
  await page.click('#preset-acceleration-limits');
  await page.until(
    'one’s own robots',
    (name) => document.querySelector('.swarm-name')?.textContent !== name,
    theirs[0],
  );
  await page.click('#duel-watch');
  await page.until('evolution’s robots once more', hasParked, ...theirs);
});

pageTest(
  'who drives on while the duel is computed again after a reload sees what is driven',
  async (page) => {
    await predict(page);
    await page.until('the table', () => document.getElementById('duel-table')?.checkVisibility());
    await page.until('the answer', () => document.querySelector('#quiz-ahead .quiz-why strong'));
    await page.driver.navigate().refresh();
    await page.until('a slider is moved as soon as it is there', () => {
      const slider = /** @type {HTMLInputElement | null} */ (document.getElementById('slider-kx'));
      if (!slider?.checkVisibility() || !document.querySelector('.swarm-name')) return false;
      slider.value = '12';
      for (const type of ['input', 'change']) slider.dispatchEvent(new Event(type, { bubbles: true }));
      return true;
    });
    await page.until('the table again', () => document.getElementById('duel-table')?.checkVisibility());
    await page.evaluate(() => pageFrames.settled());
    const { gains } = evolvedBest(1, 20);
    assert.notEqual(await page.text('.swarm-name'), swarm.evolution(gains));
  },
);
