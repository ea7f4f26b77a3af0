// The page in one engine, as a test looks at it and works it.
import assert from 'node:assert/strict';
import { setTimeout as delay } from 'node:timers/promises';
import { Command, Name } from 'selenium-webdriver/lib/command.js';
import { findOne, look, obstaclesOf, onceDrawn } from './inside.js';
import { resize } from './screen.js';
import { axeAddress, blankBeside } from './server.js';

/** @typedef {import('selenium-webdriver').WebDriver} WebDriver */
/** @typedef {{ x: number, y: number }} Point CSS pixels from the top left corner of an element */

/** Generous, because it bounds only failures: a page that works is never waited for this long, however busy the machine. */
export const patience = 300_000;
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
  /** The errors that nobody has caught in the pages that are left. */
  uncaught = '';

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
    const blank = blankBeside(await this.driver.getCurrentUrl()) ?? this.site.blank;
    await this.driver.get(blank);
    // A page that writes its address while it is being left makes WebKit's driver answer too early.
    this.#isOpen = true;
    const { uncaught } = await this.until(
      'the page is left',
      (address) => {
        if (location.href !== address) return null;
        const uncaught = sessionStorage.getItem('uncaught') ?? '';
        // What a tab keeps is not for the next test.
        sessionStorage.clear();
        return { uncaught };
      },
      blank,
    );
    this.uncaught += uncaught;
  }

  /** A test that has opened nothing looks at the page. */
  async #begin() {
    if (!this.#isOpen) await this.open();
  }

  /**
   * Runs a function in the page, once that has drawn what happened before, and returns what it returns, or what its
   * promise comes to. The function sees only the page and its arguments, and gives back plain objects.
   * @template {unknown[]} A
   * @template T
   * @param {(...args: A) => T | Promise<T>} body
   * @param {A} args
   * @returns {Promise<T>}
   */
  async evaluate(body, ...args) {
    await this.#begin();
    return this.#onceDrawn(body, ...args);
  }

  /**
   * A page draws what was pressed one frame later, which on a busy machine is later than the next question.
   * @param {Function} body @param {unknown[]} args @returns {Promise<any>}
   */
  #onceDrawn(body, ...args) {
    return this.driver.executeScript(`return (${onceDrawn})(${body}, arguments)`, ...args);
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
        .executeScript(
          `return (${onceDrawn})((...args) => (${look})(${longestAnswer}, ${condition}, args), arguments)`,
          ...args,
        )
        .catch(async (reason) => {
          if (/drawing without end|NoSuchSessionError|ECONNREFUSED/.test(String(reason))) throw reason;
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
    // Half of the time is for colours, which are the same in every engine.
    return this.evaluate(obstaclesOf, axeAddress, within, this.engine === 'chromium');
  }

  /** @param {string} selector @returns {Promise<{ element: import('selenium-webdriver').WebElement, place?: Point }>} */
  async #find(selector) {
    await this.#begin();
    const found = await this.#onceDrawn(findOne, selector);
    if (!found.element) assert.fail(`${selector} must find one element, it finds ${found.count}`);
    return found;
  }

  /** The one element that a CSS selector finds, scrolled into view. @param {string} selector */
  async element(selector) {
    const { element } = await this.#find(selector);
    return element;
  }

  /**
   * All elements that a CSS selector finds.
   * @param {string} selector
   * @returns {Promise<import('selenium-webdriver').WebElement[]>}
   */
  async elements(selector) {
    await this.#begin();
    return this.#onceDrawn(
      (/** @type {string} */ wanted) => [...document.querySelectorAll(wanted)],
      selector,
    );
  }

  /** The text that a person sees of an element. @param {string} selector */
  async text(selector) {
    return (await this.element(selector)).getText();
  }

  /** @param {string} selector */
  async click(selector) {
    const { element, place } = await this.#find(selector);
    // Chromium's driver works five times as long for a click of its own, which also says what is in the way.
    if (!place || this.engine !== 'chromium') return element.click();
    await this.#point('mouse', [
      { type: 'pointerMove', duration: 0, origin: 'viewport', ...place },
      { type: 'pointerDown', button: 0 },
      { type: 'pointerUp', button: 0 },
    ]);
  }

  /** @param {'mouse' | 'touch'} pointerType @param {object[]} actions */
  async #point(pointerType, actions) {
    const sequence = { type: 'pointer', id: pointerType, parameters: { pointerType }, actions };
    await this.driver.execute(new Command(Name.ACTIONS).setParameter('actions', [sequence]));
  }

  /**
   * Presses keys one after the other; where they go is decided by the focus, as for a person.
   * @param {...string} keys characters, or names such as Key.TAB
   */
  async press(...keys) {
    await this.evaluate(() => {});
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
   * @param {number} [milliseconds] from each to the next
   */
  drag(selector, points, milliseconds = 30) {
    return this.#dragWith('mouse', selector, points, milliseconds);
  }

  /**
   * Drags with a finger through points of an element. WebKitGTK has no touch: there it is the mouse again.
   * @param {string} selector
   * @param {Point[]} points
   */
  touchDrag(selector, points) {
    return this.#dragWith('touch', selector, points, 30);
  }

  /**
   * @param {'mouse' | 'touch'} pointerType
   * @param {string} selector
   * @param {Point[]} points
   * @param {number} milliseconds
   */
  async #dragWith(pointerType, selector, points, milliseconds) {
    const element = await this.element(selector);
    const corner = await this.evaluate((box) => {
      const { left, top } = /** @type {Element} */ (/** @type {unknown} */ (box)).getBoundingClientRect();
      return { left, top };
    }, element);
    const moves = points.map(({ x, y }, index) => ({
      type: 'pointerMove',
      duration: index === 0 ? 0 : milliseconds,
      origin: 'viewport',
      x: Math.round(corner.left + x),
      y: Math.round(corner.top + y),
    }));
    await this.#point(pointerType, [
      moves[0],
      { type: 'pointerDown', button: 0 },
      ...moves.slice(1),
      { type: 'pointerUp', button: 0 },
    ]);
  }

  /**
   * Gives the page a size in CSS pixels. Firefox and WebKitGTK stop at a width of 500 and 447.
   * @param {number} width
   * @param {number} height
   */
  resize(width, height) {
    return resize(this, width, height);
  }

  /** Lets what moves on the page move so many times as fast, as long as it is open. @param {number} times */
  async setPace(times) {
    await this.evaluate((pace) => pageFrames.setPace(pace), times);
  }

  /** What the page looks like, as a PNG. */
  async screenshot() {
    return Buffer.from(await this.driver.takeScreenshot(), 'base64');
  }
}
