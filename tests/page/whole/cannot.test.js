// Where the page cannot run it says so in one sentence, shows a picture, and its lesson can be read.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import binaryen from 'binaryen';
import { writeInstead } from '../../../.tasks/instead.mjs';
import { engineTest, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/server.js').Changes} Changes */

/** Serves the site with something wrong while a test looks at it. @param {Page} page @param {Changes} wrong @param {(address: string) => Promise<void>} body */
async function withSite(page, wrong, body) {
  const site = await serve(undefined, wrong);
  try {
    await body(site.address);
  } finally {
    await page.leave();
    await site.close();
  }
}

/** What of the page is in sight: texts by language, and the picture. @param {Page} page */
const inSight = (page) =>
  page.evaluate(() => {
    /** @param {string} selector */
    const texts = (selector) =>
      [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll(selector))]
        .filter((element) => element.checkVisibility({ visibilityProperty: true }))
        .map((element) => element.innerText);
    return {
      message: texts('#message, noscript').join(''),
      why: texts('.instead-why').join(''),
      articles: texts('#instead details > section').map((text) => text.split('\n')[0]),
      captions: texts('#instead figcaption p'),
      picture: document.querySelector('#instead svg')?.checkVisibility({ visibilityProperty: true }),
      instrument: document.getElementById('instrument')?.checkVisibility(),
      all: document.body.innerText,
    };
  });

/** A file of the site that is not sent. @param {RegExp} name @returns {Changes} */
const without = (name) => ({ send: (file, content) => (name.test(file) ? null : content) });

engineTest('what the browser or the server lacks is said, above a picture and the lesson', async (page) => {
  for (const [wrong, fragment, said] of /** @type {[Changes, string, RegExp][]} */ ([
    [{ before: 'delete globalThis.WebAssembly;' }, '', /^The robots cannot drive here: .*no WebAssembly/],
    [
      { before: 'WebAssembly.validate = () => false; WebAssembly.compile = () => Promise.reject(Error());' },
      '#curves&v=1&seed=7',
      /no SIMD/,
    ],
    [without(/\.wasm$/), '?embed#lab', /could not be loaded \(.*404/],
    [{ policy: { 'script-src': "'self'" } }, '#lesson&lang=ko', /주행할 수 없습니다.*WebAssembly를 금지/],
  ]))
    await withSite(page, wrong, async (address) => {
      await page.visit(address + fragment);
      await page.until('a message is there to read', () => document.getElementById('message')?.innerText);
      const korean = fragment.includes('ko');
      const { message, why, articles, captions, picture, instrument, all } = await inSight(page);
      assert.match(message, said);
      assert.equal(why, '');
      assert.equal(picture, true);
      assert.equal(captions.length, 1);
      assert.equal(articles.length, 13);
      assert.match(articles[0], korean ? /^1\. [가-힣]/ : /^1\. Drive it yourself/);
      assert.equal(instrument, false, 'controls that nothing drives are to be seen');
      assert.doesNotMatch(all, /npm start/);
      // Once, for it is long.
      if (page.engine === 'chromium' && korean) assert.deepEqual(await page.obstacles(), []);
    });
});

engineTest('without its scripts, or where they are forbidden, the page can be read', async (page) => {
  await withSite(page, without(/index.*\.js$/), async (address) => {
    await page.visit(address);
    assert.equal(
      (await inSight(page)).picture,
      false,
      'it is told at once, while the page may still be loading',
    );
    await page.evaluate(() => {
      for (const wait of document.getAnimations()) wait.finish();
      for (const details of document.querySelectorAll('details')) details.open = true;
    });
    const { why, articles, captions, picture } = await inSight(page);
    assert.match(why, /^No robots yet\?.*Firefox.*\n+.*Firefox/s);
    assert.deepEqual([picture, captions.length, articles.length], [true, 2, 26]);
  });

  await page.visit(page.site.blank);
  await page.evaluate((src) => {
    const frame = document.createElement('iframe');
    frame.setAttribute('sandbox', 'allow-same-origin');
    Object.assign(frame, { src, width: '800', height: '700' });
    document.body.append(frame);
  }, page.site.address);
  const seen = await page.until('sentence and picture are in sight', () => {
    const inside = document.querySelector('iframe')?.contentDocument;
    // Firefox asks for its own setting, not for the frame's, whether there are scripts: it waits before it shows the rest.
    for (const wait of inside?.getAnimations() ?? []) wait.finish();
    const text = /** @type {HTMLElement | null | undefined} */ (inside?.querySelector('noscript'))?.innerText;
    const picture = inside?.querySelector('#instead svg');
    return picture?.checkVisibility({ visibilityProperty: true }) && text;
  });
  assert.match(seen, /need JavaScript.*JavaScript/);
});

pageTest('when the core fails the page says so and how to go on, and answers nothing more', async (page) => {
  const send = (/** @type {string} */ file, /** @type {Buffer} */ content) =>
    file.endsWith('.wasm') ? withTrap(content, 'evolution_step') : content;
  await withSite(page, { send }, async (address) => {
    await page.visit(`${address}#lab&v=1&seed=7`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.click('#one-generation');
    const text = await page.until('it says so', () => {
      const message = /** @type {HTMLElement | null} */ (
        document.querySelector('main > .message:not(#message)')
      );
      return message?.checkVisibility() && message.innerText;
    });
    assert.match(text, /stopped.*reload/s);
    assert.doesNotMatch(await page.text('body'), /unreachable|RuntimeError/);
    assert.equal(await page.evaluate(() => document.getElementById('instrument')?.inert), true);
    assert.match(await page.evaluate(() => location.hash), /seed=7/);
  });
});

/** The core with one function that traps. @param {Buffer} bytes @param {string} name */
function withTrap(bytes, name) {
  const module = binaryen.readBinary(bytes);
  const { value } = binaryen.getExportInfo(module.getExport(name));
  /** @type {{ Function: { setBody(of: number, body: number): void } }} */ (
    /** @type {unknown} */ (binaryen)
  ).Function.setBody(module.getFunction(value), module.unreachable());
  const broken = Buffer.from(module.emitBinary());
  module.dispose();
  return broken;
}

test('what is there to read has every number, and is what the core says today', async () => {
  const written = await writeInstead();
  assert.doesNotMatch(written, /[–…]<|undefined|NaN|null|\{/);
  assert.doesNotMatch(written, / style=|href=|<a |<script|∞/);
  for (const name of ['index.html', 'ep-locomotion.html'])
    assert.ok(
      (await readFile(new URL(`../../../dist/${name}`, import.meta.url), 'utf8')).includes(written),
      `${name} has another`,
    );
});
