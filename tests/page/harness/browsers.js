// Drives the page in every engine of this machine by one protocol, WebDriver.
//
// A test file is a list of `pageTest('what must hold', async (page) => …)`; each becomes one test per engine. When dist/
// is built, one file in one engine runs by `ENGINES=chromium node --test tests/page/lab/page.test.js`, all by every.js.
import assert from 'node:assert/strict';
import { spawn } from 'node:child_process';
import { mkdir, mkdtemp, rm, writeFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after, test } from 'node:test';
import { setTimeout as delay } from 'node:timers/promises';
import { Builder, Key } from 'selenium-webdriver';
import { Command, Name } from 'selenium-webdriver/lib/command.js';
import { findEngines, findProgram } from './engines.js';
import { isForBrowsers } from './once.js';
import { axeAddress, serve } from './server.js';

export { Key };

// Its types go by the folder's name, which an import of a module would not find.
/** @type {typeof import('selenium-webdriver/remote')} */
const { DriverService } = createRequire(import.meta.url)('selenium-webdriver/remote');

/** @typedef {import('./engines.js').Engine} Engine */
/** @typedef {import('selenium-webdriver').WebDriver} WebDriver */
/** @typedef {{ x: number, y: number }} Point CSS pixels from the top left corner of an element */

/** Generous, because it bounds only failures: a page that works is never waited for this long. */
const patience = 45_000;
const testTimeout = 180_000;
/** A page that is left while something is awaited in it may never answer: then it is asked again. */
const longestAnswer = 2000;

/** The page in one engine. */
export class Page {
  /**
   * @param {import('./engines.js').EngineName} engine
   * @param {WebDriver} driver for what the methods below do not offer
   * @param {import('./server.js').Site} site
   */
  constructor(engine, driver, site) {
    this.engine = engine;
    this.driver = driver;
    this.site = site;
  }

  #isOpen = false;

  /**
   * Opens the page afresh and waits until it is ready.
   * @param {string} [fragment] what follows the address, for instance '#law=kanayama'
   */
  async open(fragment = '#lab') {
    // Between two addresses that differ in the fragment alone, a browser would not load the page again.
    if (this.#isOpen) await this.leave();
    await this.visit(this.site.address + fragment);
    await this.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
  }

  /** Opens something else in the place of the page. @param {string} address */
  async visit(address) {
    this.#isOpen = true;
    this.site.problems.length = 0;
    await this.driver.get(address);
  }

  /** Leaves whatever is open for a page with nothing on it. */
  async leave() {
    const { blank } = this.site;
    await this.driver.get(blank);
    // A page that writes its address while it is being left makes WebKit's driver answer too early.
    this.#isOpen = true;
    await this.until('the page is left', (address) => location.href === address, blank);
  }

  /** A test that has opened nothing looks at the page. */
  async #begin() {
    if (!this.#isOpen) await this.open();
  }

  /**
   * Runs a function in the page and returns what it returns, or what its promise comes to. The function sees only the
   * page and its arguments, and gives back plain objects.
   * @template {unknown[]} A
   * @template T
   * @param {(...args: A) => T | Promise<T>} body
   * @param {A} args
   * @returns {Promise<T>}
   */
  async evaluate(body, ...args) {
    await this.#begin();
    return this.driver.executeScript(body, ...args);
  }

  /**
   * Waits until a function that runs in the page returns something true, and returns that.
   * @template {unknown[]} A
   * @template T
   * @param {string} what is waited for, told if it never comes
   * @param {(...args: A) => T | Promise<T>} condition
   * @param {A} args
   * @returns {Promise<Exclude<T, false | null | undefined | '' | 0>>}
   */
  async until(what, condition, ...args) {
    await this.#begin();
    const end = performance.now() + patience;
    /** @type {unknown} */
    let left = null;
    do {
      // The page looks by itself, for each question from here costs both of them time.
      /** @type {{ result?: unknown, error?: string } | null} */
      const answer = await this.driver
        .executeScript(`return (${look})(${longestAnswer}, ${condition}, arguments)`, ...args)
        .catch(async (reason) => {
          left = reason;
          await delay(20);
          return null;
        });
      // Firefox answers null for a page that is left meanwhile.
      const { result, error } = answer ?? {};
      if (error) throw new Error(`while waiting until ${what}: ${error}`);
      if (result) return /** @type {Exclude<T, false | null | undefined | '' | 0>} */ (result);
    } while (performance.now() < end);
    const problems = (await this.problems()).map((problem) => `\n  ${problem}`).join('');
    throw new Error(`waited ${patience / 1000} s in vain until ${what}${problems}`, { cause: left });
  }

  /**
   * Console errors, uncaught errors, refused and failed requests, those to other hosts included, since the page was opened.
   * @returns {Promise<string[]>}
   */
  async problems() {
    const collected = await this.evaluate(
      () =>
        /** @type {{ collectedProblems?: string[] }} */ (/** @type {unknown} */ (window)).collectedProblems,
    );
    return [...(collected ?? []), ...this.site.problems];
  }

  /**
   * What axe-core finds to be an obstacle for people who use assistive technology.
   * @param {string} [within] a selector; else the whole page is looked at
   * @returns {Promise<string[]>}
   */
  async obstacles(within = 'html') {
    return this.evaluate(
      async (address, selector, contrast) => {
        const own = /** @type {{ axe?: typeof import('axe-core') }} */ (/** @type {unknown} */ (window));
        if (!own.axe)
          await new Promise((resolve, reject) => {
            const script = document.createElement('script');
            Object.assign(script, { src: address, onload: resolve, onerror: reject });
            document.head.append(script);
          });
        const { violations } = await /** @type {typeof import('axe-core')} */ (own.axe).run(selector, {
          // What is read below names no selector, which takes time to find.
          selectors: false,
          resultTypes: ['violations'],
          rules: { 'color-contrast': { enabled: contrast } },
        });
        return violations.map(
          ({ id, help, nodes }) => `${id}: ${help}: ${nodes.map(({ html }) => html).join(' ')}`,
        );
      },
      axeAddress,
      within,
      // Half of the time, for colours that are the same in every engine.
      this.engine === 'chromium',
    );
  }

  /**
   * The one element that a CSS selector finds, scrolled into view.
   * @param {string} selector
   */
  async element(selector) {
    await this.#begin();
    /** @type {import('selenium-webdriver').WebElement | number} */
    const found = await this.driver.executeScript(async (/** @type {string} */ wanted) => {
      // What happened last may still have to be drawn.
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const elements = document.querySelectorAll(wanted);
      if (elements.length !== 1) return elements.length;
      elements[0].scrollIntoView({ block: 'nearest' });
      return elements[0];
    }, selector);
    if (typeof found === 'number') assert.fail(`${selector} must find one element, it finds ${found}`);
    return found;
  }

  /**
   * The text that a person sees of an element.
   * @param {string} selector
   */
  async text(selector) {
    return (await this.element(selector)).getText();
  }

  /** @param {string} selector */
  async click(selector) {
    await (await this.element(selector)).click();
  }

  /**
   * Presses keys one after the other; where they go is decided by the focus, as for a person.
   * @param {...string} keys characters, or names such as Key.TAB
   */
  async press(...keys) {
    await this.#begin();
    let actions = this.driver.actions();
    for (const key of keys) actions = actions.keyDown(key).keyUp(key);
    await actions.perform();
  }

  /** @param {string} selector */
  async focus(selector) {
    const element = await this.element(selector);
    await this.driver.executeScript('arguments[0].focus()', element);
  }

  /**
   * Drags with the mouse through points of an element.
   * @param {string} selector
   * @param {Point[]} points
   */
  drag(selector, points) {
    return this.#dragWith('mouse', selector, points);
  }

  /**
   * Drags with a finger through points of an element. WebKitGTK has no touch: there it is the mouse again.
   * @param {string} selector
   * @param {Point[]} points
   */
  touchDrag(selector, points) {
    return this.#dragWith('touch', selector, points);
  }

  /**
   * @param {'mouse' | 'touch'} pointerType
   * @param {string} selector
   * @param {Point[]} points
   */
  async #dragWith(pointerType, selector, points) {
    const element = await this.element(selector);
    const corner = await this.evaluate((box) => {
      const { left, top } = /** @type {Element} */ (/** @type {unknown} */ (box)).getBoundingClientRect();
      return { left, top };
    }, element);
    const moves = points.map(({ x, y }, index) => ({
      type: 'pointerMove',
      duration: index === 0 ? 0 : 30,
      origin: 'viewport',
      x: Math.round(corner.left + x),
      y: Math.round(corner.top + y),
    }));
    const actions = [
      moves[0],
      { type: 'pointerDown', button: 0 },
      ...moves.slice(1),
      { type: 'pointerUp', button: 0 },
    ];
    const sequence = { type: 'pointer', id: pointerType, parameters: { pointerType }, actions };
    await this.driver.execute(new Command(Name.ACTIONS).setParameter('actions', [sequence]));
  }

  /**
   * Gives the page a size in CSS pixels. Firefox and WebKitGTK stop at a width of 500 and 447.
   * @param {number} width
   * @param {number} height
   */
  async resize(width, height) {
    const window = this.driver.manage().window();
    // The frame's size is not known beforehand: the second attempt corrects what the first one missed.
    for (let attempt = 0; attempt < 5; attempt++) {
      /** @type {{ width: number, height: number }} */
      const inner = await this.driver.executeScript(() => ({ width: innerWidth, height: innerHeight }));
      if (inner.width === width && inner.height === height) return;
      const outer = await window.getRect();
      await window.setRect({
        width: outer.width + width - inner.width,
        height: outer.height + height - inner.height,
      });
      // The page learns its new size later than the window.
      await this.driver.executeScript(async (/** @type {typeof inner} */ old) => {
        for (let frame = 0; frame < 30 && innerWidth === old.width && innerHeight === old.height; frame++) {
          await new Promise((resolve) => requestAnimationFrame(resolve));
        }
      }, inner);
    }
  }

  /** What the page looks like, as a PNG. */
  async screenshot() {
    return Buffer.from(await this.driver.takeScreenshot(), 'base64');
  }
}

/**
 * What ends the things that were started, the latest first; what does not end well must not keep the others.
 * @type {(() => unknown)[]}
 */
const endings = [];
after(async () => {
  for (const end of endings.reverse()) {
    try {
      await end();
    } catch (error) {
      console.error(error);
    }
  }
});

/**
 * Runs in the page: looks again and again until there is something to see.
 * @param {number} longest in milliseconds
 * @param {(...args: unknown[]) => unknown} condition
 * @param {unknown[]} args
 */
async function look(longest, condition, args) {
  const end = performance.now() + longest;
  try {
    for (;;) {
      const result = await condition(...args);
      if (result || performance.now() > end) return { result };
      await new Promise((resolve) => setTimeout(resolve, 20));
    }
  } catch (error) {
    return { error: String(error) };
  }
}

const found = isForBrowsers ? findEngines().found : [];
/** @type {Promise<import('./server.js').Site> | undefined} */
let site;
/** @type {Map<string, Promise<WebDriver>>} */
const drivers = new Map();

/**
 * Declares one test in each engine. The page is opened afresh, by the test itself or else at its first look.
 * @param {string} name
 * @param {(page: Page) => Promise<void>} body
 * @param {{ moves?: boolean }} [setting] moves: the robots drive by themselves. Else the browser asks for less motion, as people can: a page that stands still until it is told to move takes far less time to draw.
 */
export function pageTest(name, body, { moves = false } = {}) {
  for (const engine of found) {
    test(`${engine.name}: ${name}`, { timeout: testTimeout }, async () => {
      site ??= startSite();
      const key = `${engine.name} ${moves}`;
      const driver = drivers.get(key) ?? startBrowser(engine, moves);
      drivers.set(key, driver);
      const page = new Page(engine.name, await driver, await site);
      try {
        await page.resize(1200, 900);
        await body(page);
      } finally {
        // A page that goes on moving would slow the tests of the other engines; a browser that is lost, fail all others.
        await page.leave().catch(() => drivers.delete(key));
      }
    });
  }
}

async function startSite() {
  const started = await serve();
  endings.push(() => started.close());
  return started;
}

/**
 * @param {Engine} engine
 * @param {boolean} moves
 * @returns {Promise<WebDriver>}
 */
async function startBrowser(engine, moves) {
  const screen = engine.name === 'webkit' ? await startScreen(moves) : {};
  const builder = new Builder().withCapabilities(capabilities(engine, moves));
  if (engine.driver !== null) {
    const service = new DriverService.Builder(engine.driver)
      .setLoopback(true)
      .setEnvironment(/** @type {Record<string, string>} */ ({ ...process.env, ...screen }))
      .build();
    endings.push(() => service.kill());
    builder.usingServer(await service.start());
  }
  const driver = builder.build();
  endings.push(() => driver.quit());
  await driver.getSession();
  return driver;
}

/**
 * @param {Engine} engine
 * @param {boolean} moves
 * @returns {Record<string, unknown>}
 */
function capabilities({ name, browser }, moves) {
  const asRoot = process.getuid?.() === 0;
  switch (name) {
    case 'chromium': {
      const args = ['--headless=new', '--disable-gpu', '--disable-background-networking', '--no-first-run'];
      args.push('--accept-lang=en');
      if (!moves) args.push('--force-prefers-reduced-motion');
      // Its sandbox does not run as root, which is who runs in most containers.
      if (asRoot) args.push('--no-sandbox');
      return { browserName: 'chrome', 'goog:chromeOptions': { binary: browser, args } };
    }
    case 'firefox':
      return {
        browserName: 'firefox',
        'moz:firefoxOptions': {
          binary: browser,
          args: ['-headless'],
          prefs: { 'intl.accept_languages': 'en', 'ui.prefersReducedMotion': moves ? 0 : 1 },
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
 * @returns {Promise<Record<string, string>>} what its programs have to know
 */
async function startScreen(moves) {
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
  /** @type {Record<string, string>} */
  const environment = {
    DISPLAY: `:${display}`,
    GDK_BACKEND: 'x11',
    // Where the machine has no language, WebKit would take "C" for one.
    LC_ALL: 'en_US.UTF-8',
    // This screen has no graphics card, without which that renderer needs a third of a second for a frame.
    WEBKIT_DISABLE_DMABUF_RENDERER: '1',
    XDG_CONFIG_HOME: await writeDesktopSettings(moves),
  };
  if (process.getuid?.() === 0) environment.WEBKIT_DISABLE_SANDBOX_THIS_IS_DANGEROUS = '1';
  return environment;
}

/** WebKitGTK asks the desktop whether things may move. @param {boolean} moves @returns {Promise<string>} the folder of its settings */
async function writeDesktopSettings(moves) {
  const folder = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
  endings.push(() => rm(folder, { recursive: true }));
  for (const version of ['gtk-3.0', 'gtk-4.0']) {
    await mkdir(join(folder, version));
    const text = `[Settings]\ngtk-enable-animations=${moves}\n`;
    await writeFile(join(folder, version, 'settings.ini'), text);
  }
  return folder;
}
