// What is drawn follows the size of its place.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

/** In how many pictures one after the other a canvas is not as wide as its place, once something is done. @typedef {(open: string) => number} Wrong */

pageTest('where there is less room one picture at most has the old size', async (page) => {
  for (const [link, canvas, button] of [
    ['lab', '#plane-paths', 'settings-button'],
    ['robustness', '.survey-map canvas', 'settings-button'],
    ['curves', '.curves-picture canvas', 'settings-button'],
  ]) {
    await page.resize(1440, 900);
    await page.open(`#${link}`);
    await page.evaluate(() => pageFrames.settled());
    const { wrong, widths } = await page.evaluate(
      async (selector, id) => {
        const element = /** @type {HTMLCanvasElement} */ (document.querySelector(selector));
        const widths = new Set([element.clientWidth]);
        let wrong = 0;
        document.getElementById(id)?.click();
        for (let i = 0; i < 12; i += 1) {
          await new Promise((resolve) => requestAnimationFrame(() => setTimeout(resolve)));
          widths.add(element.clientWidth);
          if (Math.abs(element.width - element.clientWidth * devicePixelRatio) > 1) wrong += 1;
        }
        return { wrong, widths: widths.size };
      },
      canvas,
      button,
    );
    assert.ok(widths > 1, `${link}: nothing has another size`);
    assert.ok(wrong <= 1, `${link}: ${wrong} pictures are stretched`);
  }
  assert.deepEqual(await page.problems(), []);
});
