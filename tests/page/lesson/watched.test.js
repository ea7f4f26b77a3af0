// Where there is room for one thing only, what one is told to watch is that.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';

const pressed = /** @type {const} */ ([
  ['drive', '#quiz-bolder .choice'],
  ['task', '[data-try="beside"]'],
  ['task', '[data-try="withKy"]'],
]);

pageTest('on a telephone the drive that a question or a try is about comes into sight', async (page) => {
  await page.resize(390, 844);
  for (const [name, selector] of pressed) {
    await page.open(`#${linkOfStep(stepNames.indexOf(name) + 1)}`);
    await page.evaluate((selector) => {
      /** @type {HTMLElement | null} */ (document.querySelector(selector))?.click();
    }, selector);
    const height = await page.until(`${name} shows the robot`, () => {
      const plane = document.getElementById('plane');
      const isRobot = /** @type {HTMLInputElement | null} */ (document.getElementById('sights-robot'))
        ?.checked;
      return isRobot && plane?.checkVisibility() && plane.clientHeight;
    });
    assert.ok(height >= 300, `${name}: ${height}`);
  }
});
