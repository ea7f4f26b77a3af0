// On a tablet held sideways the words of a step stand beside its figure, in which all that one presses or reads is in sight.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { endSurrounding, follow, surround } from '../whole/surround.js';
import { lessonViews } from '../whole/views.js';

/** In the page: what of the figure is cut off, by its name. */
function cutOff() {
  const figure = /** @type {Element} */ (document.querySelector('.figure'));
  const { left, right, bottom } = figure.getBoundingClientRect();
  const foot = Math.min(bottom, innerHeight);
  return [...figure.querySelectorAll('button, input, select, canvas, .push-value, #landscape-readout')]
    .filter((one) => one.checkVisibility() && !one.closest('#handles'))
    .filter((one) => {
      const box = one.getBoundingClientRect();
      return box.width > 1 && (box.bottom > foot + 1 || box.right > right + 1 || box.left < left - 1);
    })
    .map(({ id, className }) => id || className);
}

pageTest('on a tablet held sideways all of a step’s figure is in sight', async (page) => {
  /** @type {Record<string, string[]>} */
  const found = {};
  try {
    await page.open('#lesson&step=1');
    for (const view of lessonViews) {
      await follow(page, view);
      for (const size of /** @type {const} */ ([
        [1180, 745],
        [1024, 768],
      ])) {
        await surround(page, size);
        const cut = await page.evaluate(cutOff);
        if (cut.length > 0) found[`${view}, ${size}`] = cut;
      }
    }
  } finally {
    await endSurrounding(page);
  }
  assert.deepEqual(found, {});
});
