// An exercise that hides the paper's gains hides them from the contest, too.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { link, openContest, readTable, runContest, withoutVerdict } from './contest-page.js';
import { expectedTable, small } from './contests.js';

pageTest('hidden gains of the paper stand in no reading of a contest, nor what they cost', async (page) => {
  const drawn = () =>
    page.evaluate(() => {
      const own = /** @type {{ drawnTexts?: string[] }} */ (/** @type {unknown} */ (window));
      const { prototype } = CanvasRenderingContext2D;
      const { fillText } = prototype;
      own.drawnTexts ??= [];
      prototype.fillText = function (text, ...rest) {
        own.drawnTexts?.push(text);
        return fillText.call(this, text, ...rest);
      };
    });
  const all = () =>
    page.evaluate(() => {
      const own = /** @type {{ drawnTexts?: string[] }} */ (/** @type {unknown} */ (window));
      const labels = [...document.querySelectorAll('[aria-label]')].map((one) =>
        one.getAttribute('aria-label'),
      );
      return [document.body.textContent, ...labels, ...(own.drawnTexts ?? [])].join('\n');
    });
  await openContest(page, `${link}&hide=paper`);
  await drawn();
  await runContest(page);
  for (const reading of ['targets', 'ends', 'course']) {
    await page.click(`#contest-reading-${reading}`);
    const text = await all();
    // What is drawn is among it.
    assert.match(text, /\ntarget 7\.7/);
    assert.doesNotMatch(text, /7\.935|9\.016|3\.237|5\.179/, reading);
  }
  assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, null));
  assert.deepEqual(await page.problems(), []);
});
