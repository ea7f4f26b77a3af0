// What is far smaller than usual can be seen and set, too.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';

pageTest('one goes through a drive of some thousandths of a second by its slider', async (page) => {
  await page.open('#lab&v=1&sampleTime=0.0001&horizon=0.005');
  const clock = (/** @type {string} */ wanted) =>
    page.until(
      `the clock says ${wanted}`,
      (text) => document.querySelector('#clock')?.textContent === text,
      wanted,
    );
  await clock('0.0050 of 0.0050 s');
  await page.focus('#scrub');
  await page.press(Key.HOME);
  await clock('0.0000 of 0.0050 s');
  for (const _ of [1, 2]) await page.press(Key.ARROW_RIGHT);
  await clock('0.0001 of 0.0050 s');
});

pageTest('a long gain stands whole in its field', async (page) => {
  await page.open('#lab&v=1&drives=hand&gains=3,1000000,123456.789');
  const fields = await page.evaluate(() =>
    [...document.querySelectorAll('.gain [type="text"]')].map(
      (one) => /** @type {HTMLInputElement} */ (one).value,
    ),
  );
  assert.deepEqual(fields.slice(0, 3), ['3.000', '1000000', '123456.789']);
});
