// In windows that are lower or higher than most, nothing lies on anything, and what is pressed is in sight.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { excess } from './surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Where the elements are. @param {Page} page @param {string[]} selectors */
const boxes = (page, ...selectors) =>
  page.evaluate(
    (...all) =>
      all.map((selector) => {
        const { top, bottom, height } = /** @type {Element} */ (
          document.querySelector(selector)
        ).getBoundingClientRect();
        return { top, bottom, height };
      }),
    ...selectors,
  );

pageTest('in a low window the curves end above the gains', async (page) => {
  await page.open('#curves&v=1&generation=12');
  for (const [width, height] of /** @type {const} */ ([
    [1097, 530],
    [1024, 500],
    [1280, 500],
    [1920, 540],
    [1280, 585],
    [1280, 680],
  ])) {
    await page.resize(width, height);
    await excess(page);
    const [curves, gains] = await boxes(page, '#curves-picture', '.driver');
    assert.ok(
      curves.height >= 200 && curves.bottom <= gains.top,
      `${width} × ${height}: ${curves.bottom}, ${gains.top}`,
    );
  }
});
