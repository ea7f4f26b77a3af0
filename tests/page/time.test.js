import assert from 'node:assert/strict';
import { Key, pageTest } from './browsers.js';
import { Evolution, evolve, experiment } from './core.js';
import { readEvolution } from './reading.js';

/** @typedef {import('./browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');

/** What the page shows of a generation of seed 1. @param {number} generation */
const expected = (generation) => ({
  generation: String(generation),
  seed: '1',
  ...evolve(velocityLimits, generation).shown,
});

/** Presses a button by the keyboard. @param {Page} page @param {string} id @param {number} times */
async function press(page, id, times) {
  await page.focus(`#${id}`);
  await page.press(...Array(times).fill(Key.ENTER));
}

/** Waits until evolution has gone on and stopped by itself. @param {Page} page */
const rests = (page) =>
  page.until('evolution rests', () => {
    const text = (/** @type {string} */ id) => document.getElementById(id)?.textContent;
    return text('generation') !== '0' && text('run') === 'Run';
  });

/** Chooses an option as a person would by the keyboard. @param {Page} page @param {string} id @param {string} text */
const choose = (page, id, text) =>
  page.evaluate(
    (select, wanted) => {
      const element = /** @type {HTMLSelectElement} */ (document.getElementById(select));
      element.selectedIndex = [...element.options].findIndex((option) => option.text === wanted);
      element.dispatchEvent(new Event('change'));
    },
    id,
    text,
  );

/** Types over the value at which evolution pauses. @param {Page} page @param {...string} keys */
async function typeUntil(page, ...keys) {
  await page.until('the field is there', () => document.getElementById('until-value')?.hidden === false);
  await page.focus('#until-value');
  await page.press(...keys);
}

pageTest(
  'generations go back and forward to what they were, and evolution goes on from there',
  async (page) => {
    await press(page, 'one-generation', 8);
    assert.deepEqual(await readEvolution(page), expected(8));
    await press(page, 'one-back', 3);
    assert.deepEqual(await readEvolution(page), expected(5));
    await page.focus('#timeline');
    await page.press(Key.HOME);
    assert.deepEqual(await readEvolution(page), expected(0));
    await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
    assert.deepEqual(await readEvolution(page), expected(2));
    await page.press(Key.END);
    assert.deepEqual(await readEvolution(page), expected(8));
    await press(page, 'one-back', 1);
    await press(page, 'one-generation', 3);
    assert.deepEqual(await readEvolution(page), expected(10));
  },
);

pageTest('evolution stops at the generation that is asked for', async (page) => {
  await choose(page, 'until', 'until generation');
  await typeUntil(page, '1', '2', Key.ENTER);
  await choose(page, 'pace', 'fastest');
  await page.click('#run');
  await rests(page);
  assert.deepEqual(await readEvolution(page), expected(12));
});

pageTest('evolution stops at the first J below the one that is asked for', async (page) => {
  const evolution = new Evolution(velocityLimits);
  let generation = 0;
  while (evolution.statistics().best.cost >= 7.9) {
    evolution.step();
    generation += 1;
  }
  await choose(page, 'until', 'until J is below');
  await typeUntil(page, '7', '.', '9', Key.ENTER);
  await choose(page, 'pace', '60/s');
  await page.click('#run');
  await rests(page);
  assert.deepEqual(await readEvolution(page), expected(generation));
});

pageTest('as fast as it goes it comes to the same generation 100', async (page) => {
  await choose(page, 'pace', 'fastest');
  await page.click('#run');
  await rests(page);
  assert.deepEqual(await readEvolution(page), expected(100));
});

pageTest(
  'where to stop is refused in sight when it is no number, and the last good one stays',
  async (page) => {
    await choose(page, 'until', 'until generation');
    await page.focus('#until-value');
    await page.press('x', Key.ENTER);
    assert.match(await page.text('#until-error'), /generation.*whole number from 1.*x/);
    await choose(page, 'until', 'pause every 100');
    await page.until('the message is gone', () => document.getElementById('until-error')?.hidden);
  },
);
