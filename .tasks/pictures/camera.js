// A browser that takes the same picture of the same page again.
import { PNG } from 'pngjs';
import { openChromium } from '../chromium.mjs';
import { linkOf } from './states.js';

/** @typedef {import('./states.js').View} View */
/** @typedef {import('../chromium.mjs').Driver} Driver */

const patience = 60_000;
const args = [
  '--disable-background-networking',
  '--no-first-run',
  '--force-prefers-reduced-motion',
  '--hide-scrollbars',
  '--force-color-profile=srgb',
];

/** @param {string} host where the pages are @param {number} port where they are served */
export async function createCamera(host, port) {
  const toServer = `--host-resolver-rules=MAP ${host}:80 127.0.0.1:${port}`;
  const driver = await openChromium('pictures are taken in', [...args, toServer]);

  /** @param {string} command @param {object} parameters @returns {Promise<any>} */
  const tell = (command, parameters = {}) => driver.sendAndGetDevToolsCommand(command, parameters);

  /** What the window shows, once it stands still. @returns {Promise<string>} */
  async function shoot() {
    let latest = '';
    for (let attempt = 0; attempt < 20; attempt += 1) {
      const { data } = await tell('Page.captureScreenshot');
      if (data === latest) return data;
      latest = data;
    }
    throw new Error('the page does not stand still');
  }

  /** The whole page, one window's height after the other: a window as large as the page would lay it out anew. @param {View} view */
  async function shootAll({ size: [width, height], isWithoutScripts }) {
    const { cssContentSize: content } = await tell('Page.getLayoutMetrics');
    const first = Buffer.from(await shoot(), 'base64');
    if (content.height <= height) return first;
    const whole = new PNG({ width, height: content.height });
    PNG.bitblt(PNG.sync.read(first), whole, 0, 0, width, height, 0, 0);
    for (let top = height; top < content.height; top += height) {
      const y = Math.min(top, content.height - height);
      await tell('Runtime.evaluate', { expression: `scrollTo(0, ${y})` });
      if (!isWithoutScripts) await rest(driver);
      PNG.bitblt(PNG.sync.read(Buffer.from(await shoot(), 'base64')), whole, 0, 0, width, height, 0, y);
    }
    return PNG.sync.write(whole);
  }

  /** @param {string} address @param {View} view @returns {Promise<Buffer>} */
  async function picture(address, view) {
    const [width, height] = view.size;
    const screen = { width, height, deviceScaleFactor: 1, mobile: false };
    const features = [{ name: 'prefers-color-scheme', value: view.theme }];
    await tell('Emulation.setScriptExecutionDisabled', { value: view.isWithoutScripts ?? false });
    await tell('Emulation.setDeviceMetricsOverride', screen);
    await tell('Emulation.setEmulatedMedia', { media: view.isPrinted ? 'print' : '', features });
    await driver.get('about:blank');
    await driver.get(address + linkOf(view));
    if (!view.isWithoutScripts) {
      await rest(driver);
      for (const text of view.press ?? []) {
        await press(driver, text);
        await rest(driver);
      }
    }
    return shootAll(view);
  }

  return { picture, close: () => driver.quit() };
}

/** Waits until the page is at rest, but for pages without scripts. @param {Driver} driver */
async function rest(driver) {
  const end = performance.now() + patience;
  while (performance.now() < end) {
    const isAtRest = await driver.executeScript(
      (/** @type {number} */ attempts) =>
        new Promise((resolve) => {
          let left = attempts;
          const look = () => {
            const own = /** @type {{ isAtRest?: () => boolean }} */ (/** @type {unknown} */ (window));
            const is = own.isAtRest?.() ?? false;
            left -= 1;
            if (is || left === 0) resolve(is);
            else setTimeout(look, 20);
          };
          look();
        }),
      100,
    );
    if (isAtRest) return;
  }
  throw new Error(`the page does not come to rest within ${patience / 1000} s`);
}

/** Presses what has this text. @param {Driver} driver @param {string} text */
async function press(driver, text) {
  /** @type {boolean} */
  const isThere = await driver.executeScript((/** @type {string} */ wanted) => {
    const within = document.querySelector('dialog[open]') ?? document;
    const found = [...within.querySelectorAll('button, summary, a')].find(
      (one) => one instanceof HTMLElement && one.checkVisibility() && one.innerText.trim() === wanted,
    );
    if (found instanceof HTMLElement) found.click();
    return found !== undefined;
  }, text);
  if (!isThere) throw new Error(`nothing has the text “${text}”`);
}
