import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { engineTest } from '../harness/browsers.js';

engineTest('on a telephone held sideways the robots stay beside all that is scrolled', async (page) => {
  await page.resize(740, 340);
  await page.open('#lab&aim=J%3C8&task=Park.');
  await page.until('the aim is there', () => document.getElementById('aim')?.checkVisibility());
  for (const part of pageNames.filter((name) => name !== 'park')) {
    // Its name may be out of sight in their row.
    await page.evaluate((name) => document.getElementById(`page-${name}`)?.click(), part);
    await page.until(`${part} is open`, (name) => document.body.dataset.open === name, part);
    const { planeHeight, ...rest } = await page.evaluate(async () => {
      scrollTo({ top: document.documentElement.scrollHeight, behavior: 'instant' });
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const boxOf = (/** @type {string} */ selector) =>
        /** @type {Element} */ (document.querySelector(selector)).getBoundingClientRect();
      const [aim, robots, readings, plane] = ['#aim', '.robot', '.readings', '#plane'].map(boxOf);
      return {
        isWhole: robots.top >= aim.bottom && robots.bottom <= innerHeight,
        isBeside: robots.right <= readings.left,
        isTooWide: document.documentElement.scrollWidth > innerWidth,
        planeHeight: plane.height,
      };
    });
    assert.deepEqual(rest, { isWhole: true, isBeside: true, isTooWide: false }, part);
    assert.ok(planeHeight >= 180, `${part}: a plane of ${planeHeight} px`);
  }
});

engineTest('there the words of a step stand beside its figure, all of which is in sight', async (page) => {
  await page.resize(740, 360);
  for (const step of [1, 3, 10]) {
    await page.open(`#lesson&step=${step}`);
    const { isBeside, cut } = await page.evaluate(async () => {
      const [figure, words] = ['.figure', '#lesson'].map(
        (selector) => /** @type {Element} */ (document.querySelector(selector)),
      );
      scrollTo({ top: document.documentElement.scrollHeight / 2, behavior: 'instant' });
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const box = figure.getBoundingClientRect();
      const isIn = (/** @type {DOMRect} */ { top, bottom, left, right }) =>
        top >= box.top - 1 && bottom <= box.bottom + 1 && left >= box.left - 1 && right <= box.right + 1;
      return {
        isBeside:
          box.top >= 0 && box.bottom <= innerHeight && box.right <= words.getBoundingClientRect().left,
        cut: [...figure.querySelectorAll('#plane, #gains input, #run, #pushes, .map')]
          .filter((one) => one.checkVisibility() && !isIn(one.getBoundingClientRect()))
          .map(({ id }) => id),
      };
    });
    assert.ok(isBeside, `step ${step}`);
    assert.deepEqual(cut, [], `step ${step}`);
  }
});
