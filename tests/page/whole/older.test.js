// In the oldest browsers that README.md names: without what they lack the page does what it does elsewhere.
import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { pageTest } from '../harness/browsers.js';
import { saved } from '../harness/saved.js';
import { beginningWith } from '../harness/server.js';
import { link as contest, openContest, runContest } from '../parts/contest-page.js';
import { follow } from './surround.js';
import { lessonViews } from './views.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** In the page: takes away what Chrome has since 110 at the earliest, Firefox since 116 and Safari since 17. */
function age() {
  const refuse = (/** @type {string} */ why) => {
    throw new RangeError(why);
  };
  // Chrome before 115.
  WebAssembly.Instance = new Proxy(WebAssembly.Instance, {
    construct: () => refuse('WebAssembly.Instance is disallowed on the main thread'),
  });
  const all = /** @type {any} */ (globalThis);
  for (const [owner, ...names] of [
    [Element.prototype, 'checkVisibility', 'setHTMLUnsafe', 'getHTML'],
    [TextMetrics.prototype, 'fontBoundingBoxAscent', 'fontBoundingBoxDescent'],
    [Array.prototype, 'toSorted', 'toReversed', 'toSpliced', 'with'],
    [Object.getPrototypeOf(Uint8Array.prototype), 'toSorted', 'toReversed', 'with'],
    [
      all.Set.prototype,
      'union',
      'intersection',
      'difference',
      'isSubsetOf',
      'isSupersetOf',
      'isDisjointFrom',
    ],
    [
      all.Iterator?.prototype ?? {},
      'map',
      'filter',
      'take',
      'drop',
      'flatMap',
      'toArray',
      'some',
      'every',
      'find',
    ],
    [String.prototype, 'isWellFormed', 'toWellFormed'],
    [Object, 'groupBy'],
    [all.Map, 'groupBy'],
    [Array, 'fromAsync'],
    [Promise, 'withResolvers', 'try'],
    [all.URL, 'canParse', 'parse'],
    [AbortSignal, 'any'],
  ])
    for (const name of names) delete owner[name];
  // Firefox before 121.
  for (const owner of [Document, DocumentFragment, Element])
    for (const name of ['querySelector', 'querySelectorAll', 'matches', 'closest']) {
      const { prototype } = /** @type {any} */ (owner);
      const find = prototype[name];
      if (!find) continue;
      prototype[name] = function (/** @type {string} */ selector) {
        if (selector.includes(':has(')) refuse(`${selector} is no selector`);
        return find.call(this, selector);
      };
    }
}

/** @param {Page} page @param {() => Promise<void>} act */
const inOlder = (page, act) => beginningWith(page, `(${age})();`, act);

pageTest('an older browser opens every part and every step', (page) =>
  inOlder(page, async () => {
    await page.open('');
    for (const link of [...pageNames.map((name) => `${name}&v=1`), ...lessonViews]) {
      await follow(page, link);
      const open = await page.evaluate(async () => {
        await pageFrames.settled();
        const { body } = document;
        return [body.dataset.open, body.hasAttribute('data-lesson')];
      });
      // What cannot be loaded leaves open what was, and throws nothing.
      assert.deepEqual(open, [link.split('&')[0], link.includes('lesson=')], link);
      assert.deepEqual(await page.problems(), [], link);
    }
  }),
);

pageTest('in an older browser evolution runs on after its button, keys press, and a contest ends', (page) =>
  inOlder(page, async () => {
    await page.open('#lab');
    await page.click('#run');
    await page.until('it has evolved', () => Number(document.getElementById('generation')?.innerText) > 2);
    await page.press('r');
    await page.until('it is paused', () => document.getElementById('run')?.textContent === 'Run');
    await page.click('#keep-button');
    const svg = await saved(page, '#keep-pictures [aria-label$="SVG"]');
    assert.match(svg, /<text/);
    assert.doesNotMatch(svg, /NaN|undefined/);
    await openContest(page, contest);
    await runContest(page);
  }),
);

pageTest('in an older browser an exercise hides and locks what it says', (page) =>
  inOlder(page, async () => {
    await page.open('#lab&v=1&task=Find.&hide=paper,share&lock=seed,postures');
    await page.click('#settings-button');
    await page.until('the settings', () => document.getElementById('setting-evolution-seed'));
    await page.evaluate(() => pageFrames.settled());
    const seen = await page.evaluate(() => ({
      there: ['drives-paper-ep', 'keep-button'].filter((id) => document.getElementById(id)),
      locked: ['new-seed', 'setting-evolution-seed', 'setting-goal-x'].filter((id) =>
        document.getElementById(id)?.closest('[data-locked]'),
      ),
    }));
    assert.deepEqual(seen, { there: [], locked: ['new-seed', 'setting-evolution-seed', 'setting-goal-x'] });
  }),
);
