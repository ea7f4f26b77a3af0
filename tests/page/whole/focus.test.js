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

pageTest('the first stop leads over the head of the page to what it is about', async (page) => {
  await page.open('#lab&v=1');
  await page.press(Key.TAB);
  assert.equal(await focused(page), 'skip');
  await page.press(Key.ENTER, Key.TAB);
  assert.equal(await focused(page), 'start-position');
  // Nothing but that comes to the page itself: Escape still closes what is open.
  await page.click('#settings-button');
  await page.click('#cost-title');
  assert.equal(await page.evaluate(() => document.activeElement === document.body), true);
  await page.press(Key.ESCAPE);
  await page.until('they are closed', () => !document.getElementById('settings')?.checkVisibility());
});

/** How much of what has the focus is in sight. @param {Page} page */
const inSight = (page) =>
  page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const { left, width, top, bottom } = /** @type {Element} */ (
      document.activeElement
    ).getBoundingClientRect();
    const seen = [0.1, 0.5, 0.9].map((share) =>
      document.elementFromPoint(left + width / 2, top + share * (bottom - top)),
    );
    return seen.every((one) => one && document.activeElement?.contains(one));
  });

pageTest('in a window of 320 by 256 pixels what has the focus is in sight', async (page) => {
  await page.resize(320, 256);
  await page.open('#lesson&step=1');
  await page.focus('#quiz-bolder .choice:first-child');
  for (let i = 0; i < 4; i += 1) {
    assert.ok(await inSight(page), `${i} stops after the first answer`);
    await page.press(Key.TAB);
  }
  await press(page, '.lesson-foot a:last-child');
  await page.until('the next step is there', () => document.activeElement?.id === 'lesson-title');
  assert.ok(await inSight(page), 'the title of the next step');

  await page.open('#lab&v=1');
  await page.click('#settings-button');
  for (const control of ['play', 'run', 'slider-kx', 'gain-ktheta']) {
    await page.focus(`#${control}`);
    assert.ok(await inSight(page), control);
  }
});
