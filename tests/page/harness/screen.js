// How large the page is.
import { Command } from 'selenium-webdriver/lib/command.js';

/** @typedef {import('./page.js').Page} Page */

/** What can be told to Chromium alone. @param {Page} page @param {string} cmd of its DevTools @param {object} params */
export function tellChromium({ driver }, cmd, params) {
  const executor = /** @type {any} */ (driver.getExecutor());
  executor.defineCommand('tellChromium', 'POST', '/session/:sessionId/goog/cdp/execute');
  return driver.execute(new Command('tellChromium').setParameters({ cmd, params }));
}

/** In Chromium, which need not change its window for that. @param {Page} page @param {number} width @param {number} height */
export const setScreen = (page, width, height) =>
  tellChromium(page, 'Emulation.setDeviceMetricsOverride', {
    ...{ width, height, deviceScaleFactor: 1, mobile: false },
  });

/** The frame of a window has a size that is not known beforehand: the second attempt corrects what the first one missed. @param {Page} page @param {number} wide @param {number} high How much larger it is to be. */
async function setWindow({ driver }, wide, high) {
  const window = driver.manage().window();
  const { width, height } = await window.getRect();
  await window.setRect({ width: width + wide, height: height + high });
}

/** @param {Page} page @param {number} width @param {number} height CSS pixels. */
export async function resize(page, width, height) {
  /** @type {{ width: number, height: number }} */
  let inner = await page.driver.executeScript(() => ({ width: innerWidth, height: innerHeight }));
  for (let attempt = 0; attempt < 5 && (inner.width !== width || inner.height !== height); attempt++) {
    if (page.engine === 'chromium') await setScreen(page, width, height);
    else await setWindow(page, width - inner.width, height - inner.height);
    // The page learns its new size later than the window, and its pictures in the frame after that.
    inner = await page.driver.executeScript(async (/** @type {typeof inner} */ old) => {
      const frame = () =>
        window.pageFrames?.settled() ?? new Promise((done) => requestAnimationFrame(() => setTimeout(done)));
      for (let i = 0; i < 30 && innerWidth === old.width && innerHeight === old.height; i++) await frame();
      await frame();
      return { width: innerWidth, height: innerHeight };
    }, inner);
  }
}
