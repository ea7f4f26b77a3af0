// While evolution tries in Park: what is pressed stays where it is, and who wants less motion sees each generation for a while.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { slide } from './parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Where the button is, and which generation is told. @param {Page} page */
const told = (page) =>
  page.evaluate(() => ({
    top: Math.round(document.getElementById('park-evolve')?.getBoundingClientRect().top ?? 0),
    text: document.querySelector('.park-climb figcaption')?.textContent ?? '',
  }));

pageTest('what sets evolution going stays under the finger, and generations do not rush by', async (page) => {
  for (const [width, height] of [
    [1440, 900],
    [390, 844],
  ]) {
    await page.resize(width, height);
    await page.open('#park');
    await slide(page, 'kx', 4);
    const before = await told(page);
    // The page has all the frames that it asks for, and no time passes.
    await page.setPace(0);
    await page.click('#park-evolve');
    await page.until('the first generation is there', () => document.querySelector('.park-climb figcaption'));
    const first = await told(page);
    for (let i = 0; i < 5; i += 1) await page.evaluate(() => pageFrames.settled());
    assert.deepEqual(await told(page), first);
    assert.equal(first.top, before.top, `at ${width} pixels the button moves`);
  }
});
