// A browser that takes the same picture of the same page again.
import { Builder } from 'selenium-webdriver';
import { findEngines } from '../../tests/page/harness/engines.js';
import { linkOf } from './states.js';

/** @typedef {import('./states.js').View} View */
/** @typedef {ReturnType<typeof import('selenium-webdriver/chrome.js').Driver.createSession>} Driver */

const patience = 60_000;
const args = [
  '--headless=new',
  '--disable-gpu',
  '--disable-background-networking',
  '--no-first-run',
  '--accept-lang=en',
  '--force-prefers-reduced-motion',
  '--hide-scrollbars',
  '--force-color-profile=srgb',
];

export async function createCamera() {
  const engine = findEngines().found.find(({ name }) => name === 'chromium');
  if (!engine) throw new Error('pictures are taken in Chromium, which this machine lacks');
  if (engine.driver !== null) process.env.SE_CHROMEDRIVER = engine.driver;
  const asRoot = process.getuid?.() === 0;
  const options = { binary: engine.browser, args: asRoot ? [...args, '--no-sandbox'] : args };
  const capabilities = { browserName: 'chrome', 'goog:chromeOptions': options };
  const driver = /** @type {Driver} */ (await new Builder().withCapabilities(capabilities).build());

  /** @param {string} command @param {object} parameters @returns {Promise<any>} */
  const tell = (command, parameters = {}) => driver.sendAndGetDevToolsCommand(command, parameters);

  /** Waits until the page is at rest, but for pages without scripts. */
  async function rest() {
    const end = performance.now() + patience;
    while (performance.now() < end) {
      const isAtRest = await driver.executeScript(
        (/** @type {number} */ longest) =>
          new Promise((resolve) => {
            const end = performance.now() + longest;
            const look = () => {
              const own = /** @type {{ isAtRest?: () => boolean }} */ (/** @type {unknown} */ (window));
              const is = own.isAtRest?.() ?? false;
              if (is || performance.now() > end) resolve(is);
              else setTimeout(look, 20);
            };
            look();
          }),
        2000,
      );
      if (isAtRest) return;
    }
    throw new Error(`the page does not come to rest within ${patience / 1000} s`);
  }

  /** The whole page, beyond the window too. */
  async function shoot() {
    const { cssContentSize: size } = await tell('Page.getLayoutMetrics');
    const clip = { x: 0, y: 0, width: size.width, height: size.height, scale: 1 };
    const { data } = await tell('Page.captureScreenshot', { captureBeyondViewport: true, clip });
    return data;
  }

  /** Presses what has this text. @param {string} text */
  async function press(text) {
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
      await rest();
      for (const text of view.press ?? []) {
        await press(text);
        await rest();
      }
    }
    // What comes late without a frame, a font for instance, would differ.
    let latest = await shoot();
    for (let attempt = 0; attempt < 20; attempt += 1) {
      const again = await shoot();
      if (again === latest) return Buffer.from(latest, 'base64');
      latest = again;
    }
    throw new Error('the page does not stand still');
  }

  return { picture, close: () => driver.quit() };
}
