// A browser that translates the page puts its own elements in the place of texts, and goes on doing so.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { follow } from './surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** In the page: what Chrome does, but for the words, which stay the same here. */
function translate() {
  /** @param {string} text */
  const wrapped = (text) => {
    const [outer, inner] = ['font', 'font'].map((name) => document.createElement(name));
    outer.style.verticalAlign = inner.style.verticalAlign = 'inherit';
    inner.textContent = text;
    outer.append(inner);
    return outer;
  };
  const translateAll = () => {
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    /** @type {Text[]} */
    const texts = [];
    while (walker.nextNode()) texts.push(/** @type {Text} */ (walker.currentNode));
    for (const text of texts)
      if (
        /\p{L}/u.test(text.data) &&
        !text.parentElement?.closest('font font, script, style, svg, [translate=no]')
      )
        text.replaceWith(wrapped(text.data));
  };
  translateAll();
  new MutationObserver(translateAll).observe(document.body, {
    childList: true,
    characterData: true,
    subtree: true,
  });
}

/** Links after which texts change that are there, each without a worker's answer. */
const links = [
  'lab&v=1&generation=2',
  'lab&v=1&generation=3&drives=hand&gains=2,2,3',
  'generation&v=1&generation=2',
  'generation&v=1&generation=2&phase=tournament',
  'generation&v=1&generation=2&phase=survivors&individual=7',
  'curves&v=1&generation=2',
  'curves&v=1&generation=2&view=numbers',
  'curves&v=1&generation=3&view=compare',
  'luck&v=1&luck=contest',
  'lesson&step=1',
  'lesson&step=3',
  'lesson&step=6',
];

/** What is told after each link. @param {Page} page @param {boolean} isTranslated */
async function told(page, isTranslated) {
  await page.open();
  // What is heard comes a little later than what is seen.
  await page.evaluate(() => {
    /** @type {HTMLElement} */ (document.getElementById('announcer')).style.display = 'none';
  });
  if (isTranslated) await page.evaluate(translate);
  const texts = [];
  for (const link of links) {
    await follow(page, link);
    texts.push(await page.evaluate(() => document.body.innerText));
  }
  assert.deepEqual(await page.problems(), []);
  return texts;
}

pageTest('what a translating browser has replaced still tells what the page says', async (page) => {
  const untouched = await told(page, false);
  const translated = await told(page, true);
  for (const [i, link] of links.entries()) assert.equal(translated[i], untouched[i], link);
  const replaced = await page.evaluate(() =>
    ['font font', 'math font', '.symbol font', '#gains label font', '#clock font'].map(
      (selector) => document.querySelectorAll(selector).length > 0,
    ),
  );
  assert.deepEqual(replaced, [true, false, false, false, false], 'symbols are no words');
});
