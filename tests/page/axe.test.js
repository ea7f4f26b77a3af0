// Nothing is in the way of assistive technology: in every part and every step of the lesson, at every size, in light, dark
// and forced colours, in each language, and in a frame.
//
// Each is looked at in every size and in every kind of colours, but not in every pair of them: the pairs go round. The other
// engines have the same styles; there each part is looked at where it is tested.
import assert from 'node:assert/strict';
import { Command } from 'selenium-webdriver/lib/command.js';
import { linkOfStep, steps } from '../../www/lesson/steps.js';
import { pageNames } from '../../www/state.js';
import { languageNames } from '../../www/words/language.js';
import { pageTest } from './browsers.js';

/** @typedef {import('./browsers.js').Page} Page */
/** @typedef {readonly [number, number]} Size */

const pin = 'pin1=a~5,1,5';
const views = [
  ...pageNames.map((name) => `${name}&v=1&generation=2&${pin}`),
  ...['stability', 'compare', 'numbers'].map((view) => `curves&v=1&view=${view}&generation=2&${pin}`),
  ...steps.map((_, i) => linkOfStep(i + 1)),
];

/** @type {readonly Size[]} */
const sizes = [
  [1440, 900],
  [1024, 768],
  [390, 844],
];
/** @type {Size} */
const frame = [400, 300];
const colours = /** @type {const} */ (['light', 'dark', 'forced']);

/** What can be told to Chromium alone. @param {Page} page @param {string} cmd @param {object} params */
function tell(page, cmd, params) {
  const executor = /** @type {any} */ (page.driver.getExecutor());
  executor.defineCommand('tellChromium', 'POST', '/session/:sessionId/goog/cdp/execute');
  return page.driver.execute(new Command('tellChromium').setParameters({ cmd, params }));
}

/** @param {Page} page @param {Size} size @param {typeof colours[number]} kind */
async function surround(page, [width, height], kind) {
  await tell(page, 'Emulation.setDeviceMetricsOverride', {
    width,
    height,
    deviceScaleFactor: 1,
    mobile: false,
  });
  await tell(page, 'Emulation.setEmulatedMedia', {
    features: [
      { name: 'prefers-color-scheme', value: kind === 'dark' ? 'dark' : 'light' },
      { name: 'forced-colors', value: kind === 'forced' ? 'active' : 'none' },
    ],
  });
}

/** Follows a link without loading the page again. @param {Page} page @param {string} link */
const follow = (page, link) =>
  page.evaluate(async (hash) => {
    const opened = new Promise((resolve) => addEventListener('popstate', resolve, { once: true }));
    location.replace(hash);
    await opened;
    for (let i = 0; i < 2; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, `#${link}`);

for (const embed of [false, true])
  pageTest(
    `nothing is in the way of assistive technology ${embed ? 'in a frame' : 'anywhere'}`,
    async (page) => {
      if (page.engine !== 'chromium') return;
      /** @type {Record<string, string[]>} */
      const found = {};
      try {
        for (const [l, language] of languageNames.entries()) {
          await page.open(`${embed ? '?embed' : ''}#lab&v=1&lang=${language}`);
          for (const [c, kind] of colours.entries())
            for (const [s, size] of (embed ? [frame] : sizes).entries()) {
              // One of the sizes, and one of the languages, for each kind of colours.
              const isDue = (/** @type {number} */ view) =>
                embed ? view % 6 === 2 * c + l : (view + s) % 3 === c && (view + c) % 2 === l;
              const due = views.filter((_, view) => isDue(view));
              if (due.length > 0) await surround(page, size, kind);
              for (const view of due) {
                await follow(page, `${view}&lang=${language}`);
                const where = `${view} ${size.join(' × ')} ${kind} ${language}`;
                const obstacles = await page.obstacles();
                if (obstacles.length > 0) found[where] = obstacles;
              }
            }
        }
      } finally {
        await tell(page, 'Emulation.clearDeviceMetricsOverride', {});
        await tell(page, 'Emulation.setEmulatedMedia', { features: [] });
      }
      assert.deepEqual(found, {});
    },
  );
