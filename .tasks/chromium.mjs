// Chromium, as tasks use it.
import { Builder } from 'selenium-webdriver';
import { findEngines } from '../tests/page/harness/engines.js';
import { Failure } from './run.mjs';

/** @typedef {ReturnType<typeof import('selenium-webdriver/chrome.js').Driver.createSession>} Driver */

/** Without a window. Its sandbox does not run as root. */
export const flags = [
  '--headless=new',
  '--disable-gpu',
  ...(process.getuid?.() === 0 ? ['--no-sandbox'] : []),
];

/** That of this machine. @param {string} why Who needs it, up to its name. */
export function findChromium(why) {
  const engine = findEngines().found.find(({ name }) => name === 'chromium');
  if (!engine) throw new Failure(`${why} Chromium, which this machine lacks`);
  return engine;
}

/**
 * @param {string} why As findChromium() has it. @param {readonly string[]} args
 * @param {object} [options] Of Chromium. @param {object} [capabilities] @returns {Promise<Driver>}
 */
export async function openChromium(why, args, options, capabilities) {
  const { browser, driver } = findChromium(why);
  if (driver !== null) process.env.SE_CHROMEDRIVER = driver;
  const chromium = { binary: browser, args: [...flags, '--accept-lang=en', ...args], ...options };
  const all = { browserName: 'chrome', 'goog:chromeOptions': chromium, ...capabilities };
  return /** @type {Driver} */ (await new Builder().withCapabilities(all).build());
}
