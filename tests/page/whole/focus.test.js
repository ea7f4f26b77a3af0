// What is pressed by the keyboard keeps the focus, or hands it on, when it has nothing more to do.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { counted, slide } from '../parts/parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Presses one that has the focus. @param {Page} page @param {string} selector */
async function press(page, selector) {
  await page.focus(selector);
  await page.press(Key.ENTER);
}

/** @param {Page} page */
const focused = (page) => page.evaluate(() => document.activeElement?.id);

/** @param {Page} page @param {string} id */
const rests = (page, id) =>
  page.until(
    `${id} can do nothing more`,
    (wanted) => document.getElementById(wanted)?.ariaDisabled === 'true',
    id,
  );

pageTest('a button that can do nothing more keeps the focus', async (page) => {
  await page.open('#lab&v=1&generation=1');
  await press(page, '#one-back');
  await rests(page, 'one-back');
  assert.equal(await focused(page), 'one-back');
  await page.press(Key.ENTER);
  assert.equal(await page.text('#generation'), '0');

  await page.open('#generation&v=1&generation=0&phase=mutation');
  await page.until('the phases are there', () => document.getElementById('generation-back'));
  for (let i = 0; i < 8; i += 1) await press(page, '#generation-back');
  await rests(page, 'generation-back');
  assert.equal(await focused(page), 'generation-back');

  await page.open('#lab&v=1&generation=70');
  await page.click('#fitness-table');
  await press(page, '#table-after');
  await rests(page, 'table-after');
  assert.equal(await focused(page), 'table-after');
});

pageTest('a button that goes away by being pressed hands the focus on', async (page) => {
  for (const [link, id, next] of [
    ['#lab&v=1&start=1,0,0deg', 'restore-postures', 'play'],
    ['#robustness&v=1&from=1,0,0deg', 'restore-postures', 'play'],
    ['#lab&v=1&lock=settings&task=Stay', 'exercise-leave', 'play'],
  ]) {
    await page.open(link);
    await press(page, `#${id}`);
    await page.until(`${id} is gone`, (gone) => !document.getElementById(gone)?.checkVisibility(), id);
    assert.equal(await focused(page), next);
  }
});

pageTest('a way from one part to another leads to the heading of what it opens', async (page) => {
  const leadsTo = async (/** @type {string} */ way, /** @type {string} */ id) => {
    await press(page, way);
    await page.until(
      `the focus is on ${id}`,
      (wanted) => document.activeElement?.id === wanted && document.activeElement.matches('h2'),
      id,
    );
  };
  await page.open('#lesson&step=15');
  await leadsTo('#lesson a[href^="#park"]', 'park-title');
  await slide(page, 'kx', 4);
  await page.click('#park-evolve');
  await counted(page);
  await leadsTo('#park-lesson', 'lesson-title');
  await page.click('#page-park');
  await page.until('Park is open', () => document.getElementById('park-lab')?.checkVisibility());
  await leadsTo('#park-lab', 'cost-title');
});
