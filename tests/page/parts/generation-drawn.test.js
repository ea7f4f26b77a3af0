// When the picture of a generation is drawn: whenever it would be another, and no more often.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** @param {number} generation @param {number} population */
const at = (generation, population) =>
  `#generation&v=1&generation=${generation}&evolution.population=${population}`;

pageTest(
  'a generation that was bred while another part was open is drawn when one comes back',
  async (page) => {
    /** Once there are others. @param {string} [was] */
    const marks = (was = '') =>
      page.until(
        'it is drawn',
        (before) => {
          const now = document.querySelector('.generation-picture .marks')?.innerHTML ?? '';
          return now !== before && now;
        },
        was,
      );
    for (const population of [20, 201]) {
      await page.open(at(2, population));
      const second = await marks();
      await page.open(at(1, population));
      const first = await marks();
      assert.notEqual(first, second);
      await page.click('#page-lab');
      await page.click('#one-generation');
      await page.until('generation 2', () => document.getElementById('generation')?.textContent === '2');
      await page.click('#page-generation');
      assert.equal(await marks(first), second, `${population}`);
    }
  },
);

/** How often the picture is drawn in each frame in which it is: one of the browser, however late those of the page come. */
const counting = `
  globalThis.drawn = new Map();
  new MutationObserver((records) => {
    const frame = document.timeline.currentTime;
    for (const { target } of records)
      if (target.matches('.generation-picture svg')) drawn.set(frame, (drawn.get(frame) ?? 0) + 1);
  }).observe(document, { attributeFilter: ['viewBox'], subtree: true });`;

pageTest('a large generation is drawn once a frame, also where its record comes later', async (page) => {
  const site = await serve(undefined, { before: counting });
  try {
    const link = `${at(1, 2000)}&evolution.opponents=274&phase=tournament`;
    await page.visit(site.address + link);
    const drawn = await page.until('the record is drawn, too', () => {
      const bouts = document.querySelector('.generation-picture .bouts');
      return bouts?.hasChildNodes() && [.../** @type {any} */ (globalThis).drawn.values()];
    });
    assert.equal(Math.max(...drawn), 1, String(drawn));
  } finally {
    await page.leave();
    await site.close();
  }
});
