// Nothing is in the way of assistive technology, also where other tests do not look: on a small screen in the dark, in the
// reader's own colours, in Korean, in a frame. Every part and every step of the lesson is looked at twice, in each language
// once; light and in English each is looked at in every engine where it is tested.
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

/** @typedef {{ size: Size, media: Record<string, string>, search: string, isDue: (view: number, language: number) => boolean }} Surroundings */

/** @type {readonly Surroundings[]} */
const surroundings = [
  {
    size: [390, 844],
    media: { 'prefers-color-scheme': 'dark' },
    search: '',
    isDue: (view, language) => view % 2 === language,
  },
  ...[0, 1].map((wide) => ({
    size: /** @type {Size} */ (wide ? [1440, 900] : [1024, 768]),
    media: { 'forced-colors': 'active' },
    search: '',
    isDue: (/** @type {number} */ view, /** @type {number} */ language) =>
      view % 2 !== language && (view >> 1) % 2 === wide,
  })),
  {
    size: [400, 300],
    media: {},
    search: '?embed',
    isDue: (view, language) => view % 4 === 2 * language,
  },
];

/** What can be told to Chromium alone. @param {Page} page @param {string} cmd @param {object} params */
function tell(page, cmd, params) {
  const executor = /** @type {any} */ (page.driver.getExecutor());
  executor.defineCommand('tellChromium', 'POST', '/session/:sessionId/goog/cdp/execute');
  return page.driver.execute(new Command('tellChromium').setParameters({ cmd, params }));
}

/** @param {Page} page @param {Size} size @param {Record<string, string>} media */
async function surround(page, [width, height], media) {
  const screen = { width, height, deviceScaleFactor: 1, mobile: false };
  await tell(page, 'Emulation.setDeviceMetricsOverride', screen);
  const features = Object.entries(media).map(([name, value]) => ({ name, value }));
  await tell(page, 'Emulation.setEmulatedMedia', { features });
}

/** Follows a link without loading the page again. @param {Page} page @param {string} link */
const follow = (page, link) =>
  page.evaluate(async (hash) => {
    const opened = new Promise((resolve) => addEventListener('popstate', resolve, { once: true }));
    location.replace(hash);
    await opened;
    for (let i = 0; i < 2; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, `#${link}`);

pageTest('nothing is in the way of assistive technology, wherever the page is', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {Record<string, string[]>} */
  const found = {};
  try {
    for (const [l, language] of languageNames.entries())
      for (const { size, media, search, isDue } of surroundings) {
        await surround(page, size, media);
        await page.open(`${search}#lab&v=1&lang=${language}`);
        for (const view of views.filter((_, i) => isDue(i, l))) {
          await follow(page, `${view}&lang=${language}`);
          const obstacles = await page.obstacles();
          if (obstacles.length > 0) found[`${view}, ${language}, ${size.join(' × ')}`] = obstacles;
        }
      }
  } finally {
    await tell(page, 'Emulation.clearDeviceMetricsOverride', {});
    await tell(page, 'Emulation.setEmulatedMedia', { features: [] });
  }
  assert.deepEqual(found, {});
});
