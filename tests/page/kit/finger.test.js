// A finger that scrolls the page changes nothing on the way; one that holds something moves it.
import assert from 'node:assert/strict';
import { engineTest, pageTest } from '../harness/browsers.js';
import { openContest, runContest, link as contest } from '../parts/contest-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Over the whole width of something the middle of its height. @param {Page} page @param {string} selector */
const middleOf = (page, selector) =>
  page.evaluate((wanted) => {
    const { width, height } = /** @type {Element} */ (document.querySelector(wanted)).getBoundingClientRect();
    return { x: width * 0.7, y: height / 2 };
  }, selector);

for (const [what, fragment, selector] of [
  ['a slider', '#lab', '#slider-kx'],
  ['a slider of Park', '#park', '#park-kx'],
  ['the map of the landscape', '#landscape', '#landscape-map'],
])
  pageTest(`a finger over ${what} scrolls the page, or moves what it is on`, async (page) => {
    // Others have no touch that scrolls.
    if (page.engine !== 'chromium') return;
    await page.resize(500, 700);
    await page.open(fragment);
    await page.until('it is there', (wanted) => document.querySelector(wanted)?.checkVisibility(), selector);
    /** Whose gains drive, and the gains. */
    const driving = () =>
      page.evaluate(() =>
        [...document.querySelectorAll('#drives :checked, #gains input, .park input')].map(
          (input) => /** @type {HTMLInputElement} */ (input).value,
        ),
      );
    const [before, top] = [await driving(), await page.evaluate(() => scrollY)];
    assert.ok(before.length > 2);
    const { x, y } = await middleOf(page, selector);
    await page.touchDrag(
      selector,
      [0, 40, 90, 160].map((by) => ({ x, y: y - by })),
    );
    await page.until('the page is scrolled', (from) => scrollY > from, top);
    assert.deepEqual(await driving(), before);

    const at = await middleOf(page, selector);
    await page.touchDrag(selector, [at, { ...at, x: at.x - 20 }, { ...at, x: at.x - 60 }]);
    assert.notDeepEqual(await driving(), before);
  });

pageTest('a finger over the picture of a contest leaves the target where it is', async (page) => {
  if (page.engine !== 'chromium') return;
  await page.resize(500, 700);
  await openContest(page, contest);
  await runContest(page);
  const target = () =>
    page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('contest-target')).value);
  const before = await target();
  const { x, y } = await middleOf(page, '#contest-chart canvas');
  const top = await page.evaluate(() => scrollY);
  await page.touchDrag('#contest-chart canvas', [
    { x, y },
    { x, y: y - 40 },
    { x, y: y - 90 },
    { x, y: y - 160 },
  ]);
  await page.until('the page is scrolled', (from) => scrollY !== from, top);
  assert.equal(await target(), before);
});

engineTest('where everything is selected, what is held is moved all the same', async (page) => {
  await page.open('#lab&v=1');
  for (const [what, key] of [
    ['#goal-position', 'goal.x'],
    ['#slider-kx', 'gains'],
  ]) {
    await page.evaluate(() => getSelection()?.selectAllChildren(document.body));
    const { x, y } = await page.evaluate((selector) => {
      const { width, height } = /** @type {Element} */ (
        document.querySelector(selector)
      ).getBoundingClientRect();
      return { x: width / 2, y: height / 2 };
    }, what);
    await page.drag(
      what,
      [0, 20, 40, 60, 80].map((by) => ({ x: x - by, y })),
    );
    await page.until(`${what} is moved`, (wanted) => location.hash.includes(`&${wanted}=`), key);
  }
  // Not until the pointer was lost on its way.
  const goal = await page.evaluate(() => Number(new URLSearchParams(location.hash).get('goal.x')));
  assert.ok(goal < 1.85, `the goal is at x = ${goal}`);
});
