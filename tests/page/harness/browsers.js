// Drives the page in every engine of this machine by one protocol, WebDriver.
//
// A test file is a list of `pageTest('what must hold', async (page) => …)` and, for what engines can do differently,
// `engineTest`: the one becomes a test in one engine, the other a test in each. `npm test -- plane` runs a file by its name;
// when dist/ is built, `ENGINES=firefox node --test tests/page/lab/plane.test.js` runs all of it in that engine.
import assert from 'node:assert/strict';
import { spawn, spawnSync } from 'node:child_process';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { Builder, error, Key } from 'selenium-webdriver';
import { findEngines, findProgram } from './engines.js';
import { runs } from './once.js';
import { Page, patience } from './page.js';
import { serve } from './server.js';

export { Key, Page, patience };

// Its types go by the folder's name, which an import of a module would not find.
/** @type {typeof import('selenium-webdriver/remote')} */
const { DriverService } = createRequire(import.meta.url)('selenium-webdriver/remote');

/** @typedef {import('./engines.js').Engine} Engine */
/** @typedef {import('selenium-webdriver').WebDriver} WebDriver */

const testTimeout = 900_000;

/**
 * What ends the things that were started, the latest first; what does not end well must not keep the others.
 * @type {(() => unknown)[]}
 */
const endings = [];
async function endAll() {
  for (const end of endings.reverse()) {
    try {
      await end();
    } catch (error) {
      console.error(error);
    }
  }
}
after(endAll);
// Whoever ends the tests before their end leaves no browser behind.
for (const signal of /** @type {const} */ (['SIGTERM', 'SIGHUP']))
  process.prependListener(signal, () => endAll().finally(() => process.exit(1)));

const found = runs('page') || runs('engine') ? findEngines().found : [];
/** @type {Promise<import('./server.js').Site> | undefined} */
let site;
/** @type {Map<string, Promise<WebDriver>>} */
const drivers = new Map();

/** @typedef {(page: Page) => Promise<void>} Body The page is opened afresh, by the test itself or else at its first look. */
/**
 * @typedef {object} Setting
 * @property {boolean} [moves] The robots drive by themselves. Else the browser asks for less motion, as people can: a page that stands still until it is told to move takes far less time to draw.
 * @property {number} [least] In Chromium: no letter is smaller, in CSS pixels, as people can ask for.
 */

/** Declares a test of what the page does, the same in every engine: numbers, words, what leads where. @param {string} name @param {Body} body @param {Setting} [setting] */
export function pageTest(name, body, setting) {
  if (runs('page')) for (const engine of found) declare(lightOf(engine), name, body, setting);
}

/** Declares a test in each engine: input, layout, drawing, workers, files, policies, frames, bits. @param {string} name @param {Body} body @param {Setting} [setting] */
export function engineTest(name, body, setting) {
  if (runs('engine')) for (const engine of found) declare(engine, name, body, setting);
}

/** The engine with nothing around it that no page needs, where the machine has it so: it starts and draws sooner. @param {Engine} engine @returns {Engine} */
const lightOf = (engine) => ({ ...engine, browser: engine.bare ?? engine.browser });

/** @param {Engine} engine @param {string} name @param {Body} body @param {Setting} [setting] */
function declare(engine, name, body, { moves = false, least = 0 } = {}) {
  test(`${engine.name}: ${name}`, { timeout: testTimeout }, async ({ signal }) => {
    site ??= startSite();
    const key = `${engine.browser} ${moves} ${least}`;
    let isOver = false;
    let lost = '';
    // What takes too long would go on in the page of the next test. The signal comes at the end of every test.
    signal.addEventListener('abort', () => isOver || drivers.delete(key));
    const driver = drivers.get(key) ?? startBrowser(engine, moves, least);
    drivers.set(key, driver);
    const page = new Page(engine.name, await driver, await site);
    try {
      await page.resize(1200, 900);
      await body(page);
    } finally {
      // A page that goes on moving would slow the tests of the other engines; a browser that is lost, fail all others.
      await page.leave().catch((error) => {
        drivers.delete(key);
        lost = `the page cannot be left: ${error}`;
      });
      isOver = true;
    }
    assert.equal(page.uncaught + lost, '', 'something was thrown that nobody has caught');
  });
}

async function startSite() {
  const started = await serve();
  endings.push(() => started.close());
  return started;
}

/** @param {Engine} engine @param {boolean} moves @param {number} least @returns {Promise<WebDriver>} */
async function startBrowser(engine, moves, least) {
  const folder = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
  endings.push(() => rm(folder, { recursive: true, maxRetries: 5 }));
  const screen = engine.name === 'webkit' ? await startScreen(moves, folder) : {};
  const builder = new Builder().withCapabilities(capabilities(engine, moves, least, folder));
  if (engine.driver !== null) {
    const [program, ...args] = amongEquals(engine.driver);
    const service = new DriverService.Builder(program)
      .addArguments(...args)
      .setLoopback(true)
      .setEnvironment(/** @type {Record<string, string>} */ ({ ...process.env, ...screen }))
      .build();
    endings.push(() => service.kill());
    builder.usingServer(await service.start());
  }
  const driver = await startSession(builder);
  await driver.manage().setTimeouts({ script: patience });
  return driver;
}

/** Firefox has a minute to start, says its driver; on a busy machine it begins anew. @param {Builder} builder @returns {Promise<WebDriver>} */
async function startSession(builder, tries = 5) {
  const driver = builder.build();
  endings.push(() => driver.quit());
  try {
    return await driver;
  } catch (reason) {
    if (tries === 1 || !(reason instanceof error.TimeoutError)) throw reason;
    endings.pop();
    return await startSession(builder, tries - 1);
  }
}

/** As root Chromium puts itself before all others, and on a busy machine the other engines starve. @param {string} driver @returns {string[]} the command by which it may not */
function amongEquals(driver) {
  const limit = '--bounding-set=-sys_nice';
  const isPossible = spawnSync('setpriv', [limit, 'true']).status === 0;
  return isPossible ? ['setpriv', limit, driver] : [driver];
}

/** @param {Engine} engine @param {boolean} moves @param {number} least @param {string} folder Where the page's files are saved, not among those of whoever runs the tests. @returns {Record<string, unknown>} */
function capabilities({ name, browser }, moves, least, folder) {
  const asRoot = process.getuid?.() === 0;
  switch (name) {
    case 'chromium': {
      const args = ['--headless=new', '--disable-gpu', '--disable-background-networking', '--no-first-run'];
      args.push('--accept-lang=en');
      // A busy machine can lose the animation by which a key scrolls: 8 of 600 End keys then did nothing, without it none of 800.
      args.push('--disable-smooth-scrolling');
      if (!moves) args.push('--force-prefers-reduced-motion');
      if (least) args.push(`--blink-settings=minimumFontSize=${least},minimumLogicalFontSize=${least}`);
      // Its sandbox does not run as root, which is who runs in most containers.
      if (asRoot) args.push('--no-sandbox');
      return {
        browserName: 'chrome',
        'goog:chromeOptions': { binary: browser, args, prefs: { 'download.default_directory': folder } },
      };
    }
    case 'firefox':
      return {
        browserName: 'firefox',
        'moz:firefoxOptions': {
          binary: browser,
          args: ['-headless'],
          prefs: {
            'intl.accept_languages': 'en',
            'ui.prefersReducedMotion': moves ? 0 : 1,
            // In the folder that is named.
            'browser.download.folderList': 2,
            'browser.download.dir': folder,
          },
        },
      };
    case 'webkit':
      if (process.platform === 'darwin') return { browserName: 'safari' };
      return {
        browserName: 'MiniBrowser',
        'webkitgtk:browserOptions': { binary: browser, args: ['--automation'] },
      };
  }
}

/**
 * WebKitGTK has no headless mode: it gets a screen that nobody sees.
 * @param {boolean} moves
 * @param {string} folder
 * @returns {Promise<Record<string, string>>} what its programs have to know
 */
async function startScreen(moves, folder) {
  const program = findProgram(['Xvfb']);
  if (program === null) return {};
  const args = ['-displayfd', '3', '-screen', '0', '1600x1200x24', '-nolisten', 'tcp'];
  const child = spawn(program, args, { stdio: ['ignore', 'ignore', 'ignore', 'pipe'] });
  endings.push(() => child.kill());
  const display = await new Promise((resolve, reject) => {
    child.once('exit', (code) => reject(new Error(`${program} ended with exit code ${code}`)));
    child.once('error', reject);
    child.stdio[3]?.once('data', (number) => resolve(String(number).trim()));
  });
  await writeDesktopSettings(moves, folder);
  /** @type {Record<string, string>} */
  const environment = {
    DISPLAY: `:${display}`,
    GDK_BACKEND: 'x11',
    // Where the machine has no language, WebKit would take "C" for one.
    LC_ALL: 'en_US.UTF-8',
    // This screen has no graphics card, without which that renderer needs a third of a second for a frame.
    WEBKIT_DISABLE_DMABUF_RENDERER: '1',
    XDG_CONFIG_HOME: folder,
  };
  if (process.getuid?.() === 0) environment.WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS = '1';
  return environment;
}

/** WebKitGTK asks the desktop whether things may move, and where files are saved. @param {boolean} moves @param {string} folder */
async function writeDesktopSettings(moves, folder) {
  for (const version of ['gtk-3.0', 'gtk-4.0']) {
    await mkdir(join(folder, version));
    const text = `[Settings]\ngtk-enable-animations=${moves}\n`;
    await writeFile(join(folder, version, 'settings.ini'), text);
  }
  await writeFile(join(folder, 'user-dirs.dirs'), `XDG_DOWNLOAD_DIR="${folder}"\n`);
}
