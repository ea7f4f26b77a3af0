// The page on another screen, in Chromium, and what is looked at there.
import { Command } from 'selenium-webdriver/lib/command.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {readonly [number, number]} Size */

/** What can be told to Chromium alone. @param {Page} page @param {string} cmd @param {object} params */
function tell(page, cmd, params) {
  const executor = /** @type {any} */ (page.driver.getExecutor());
  executor.defineCommand('tellChromium', 'POST', '/session/:sessionId/goog/cdp/execute');
  return page.driver.execute(new Command('tellChromium').setParameters({ cmd, params }));
}

/** @param {Page} page @param {Size} size @param {Record<string, string>} [media] */
export async function surround(page, [width, height], media = {}) {
  const screen = { width, height, deviceScaleFactor: 1, mobile: false };
  await tell(page, 'Emulation.setDeviceMetricsOverride', screen);
  const features = Object.entries(media).map(([name, value]) => ({ name, value }));
  await tell(page, 'Emulation.setEmulatedMedia', { features });
}

/** As it was. @param {Page} page */
export async function endSurrounding(page) {
  await tell(page, 'Emulation.clearDeviceMetricsOverride', {});
  await tell(page, 'Emulation.setEmulatedMedia', { features: [] });
}

/** Follows a link without loading the page again. @param {Page} page @param {string} link */
export const follow = (page, link) =>
  page.evaluate(async (hash) => {
    const opened = new Promise((resolve) => addEventListener('popstate', resolve, { once: true }));
    location.replace(hash);
    await opened;
    for (let i = 0; i < 2; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, `#${link}`);
