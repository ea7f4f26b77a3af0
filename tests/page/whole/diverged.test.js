// Drives that leave every bound: no view says nonsense of them, and none throws or hangs.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { follow } from './surround.js';
import { lessonViews, partViews } from './views.js';

const views = [
  ...partViews.map((view) =>
    view.includes('&view=') ? `${view}&pin1=a~1e308,1e308,1e308~limits.speed:off` : view,
  ),
  ...lessonViews,
  'disturbance&v=1&kind=slip',
];

/** Robots that are nowhere after some samples, and such that run away. */
const runs = /** @type {const} */ ([
  ['en', 'gains=1e308,1e308,1e308'],
  ['ko', 'gains=-1e9,1e9,-1e9&law=kanayama'],
]);

for (const [language, run] of runs)
  pageTest(`what is nowhere is told as such: ${run}`, async (page) => {
    /** @type {string[]} */
    const found = [];
    await page.open(`#lab&v=1&lang=${language}`);
    for (const view of views) {
      const more = `lang=${language}&limits.speed=off&limits.turnRate=off&horizon=2&drives=hand&${run}`;
      await follow(page, `${view}${view.includes('v=1') ? '' : '&v=1'}&${more}`);
      const nonsense = await page.evaluate(async () => {
        const scrub = /** @type {HTMLInputElement} */ (document.getElementById('scrub'));
        const said = [];
        for (const share of [0.02, 0.5, 1]) {
          scrub.value = String(share * Number(scrub.max));
          scrub.dispatchEvent(new Event('input', { bubbles: true }));
          await new Promise((resolve) => requestAnimationFrame(resolve));
          said.push(...(document.body.innerText.match(/.*(?:\bNaN\b|undefined|\[object|Infinity).*/g) ?? []));
          said.push(...(document.body.innerHTML.match(/[\w-]+="[^"]*NaN[^"]*"/g) ?? []));
        }
        return said;
      });
      for (const text of [...nonsense, ...(await page.problems())]) found.push(`${view}: ${text}`);
    }
    assert.deepEqual(found, []);
  });
