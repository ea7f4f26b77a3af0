// Where the page cannot run it says so in one sentence, shows a picture, and its lesson can be read.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { writeInstead } from '../../../.tasks/instead.mjs';
import { engineTest, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { serve } from '../harness/server.js';
import { withTrap } from '../harness/trap.js';

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
      message: texts('.message').join(''),
      why: texts('.instead-why').join(''),
      lessons: texts('#instead a'),
      captions: texts('#instead figcaption p'),
      picture: document.querySelector('#instead svg')?.checkVisibility({ visibilityProperty: true }),
      instrument: document.getElementById('instrument')?.checkVisibility(),
      all: document.body.innerText,
    };
  });

/** A file of the site that is not sent. @param {RegExp} name @returns {Changes} */
const without = (name) => ({ send: (file, content) => (name.test(file) ? null : content) });

/** The page fails when it listens to an event, which it does when all else is there. @param {string} name */
const failing = (name) => `
  const listen = addEventListener;
  window.addEventListener = (name, ...rest) => {
    if (name === '${name}') throw Error('no ear for ${name}');
    listen(name, ...rest);
  };`;

/** The page fails before all else. */
const silent = `
  const set = Element.prototype.setAttribute;
  Element.prototype.setAttribute = function (name, ...rest) {
    if (name === 'data-page') throw Error('no texts');
    return set.call(this, name, ...rest);
  };`;

/** As Chromium says it, where many tabs and figures are open. */
const full = `
  const error = RangeError('WebAssembly.instantiate(): Out of memory: Cannot allocate Wasm memory for new instance');
  WebAssembly.instantiate = () => Promise.reject(error);`;

engineTest('what the browser or the server lacks is said, above a picture and the lesson', async (page) => {
  for (const [wrong, fragment, said] of /** @type {[Changes, string, RegExp][]} */ ([
    [{ before: 'delete globalThis.WebAssembly;' }, '', /^The robots cannot drive here: .*no WebAssembly/],
    [
      { before: 'WebAssembly.validate = () => false; WebAssembly.compile = () => Promise.reject(Error());' },
      '#curves&v=1&seed=7',
      /no SIMD/,
    ],
    [without(/\.wasm$/), '?embed#lab', /could not be loaded \(.*404.*then load the page again/],
    [{ before: full }, '', /no memory left/],
    [{ before: failing('popstate') }, '', /could not be loaded \(no ear for popstate\)/],
    [{ before: silent }, '', /could not be loaded \(no texts\)/],
    [{ policy: { 'script-src': "'self'" } }, '#lesson&lang=ko', /주행할 수 없습니다.*WebAssembly를 금지/],
  ]))
    await withSite(page, wrong, async (address) => {
      await page.visit(address + fragment);
      await page.until('a message is there to read', () =>
        document.querySelector('main > .message:not(#message)')?.checkVisibility(),
      );
      const korean = fragment.includes('ko');
      const { message, why, lessons, captions, picture, instrument, all } = await inSight(page);
      assert.match(message, said);
      assert.equal(why, '');
      assert.equal(picture, true);
      assert.equal(captions.length, 1);
      assert.deepEqual(lessons, [korean ? '글로 읽는 수업' : 'The lesson, to read']);
      assert.equal(instrument, false, 'controls that nothing drives are to be seen');
      assert.doesNotMatch(all, /npm start/);
      // Once, for it is long.
      if (page.engine === 'chromium' && korean) assert.deepEqual(await page.obstacles(), []);
      if (korean) await readsLesson(page, 'ko');
    });
});

/** Follows the link to the lesson and sees that all of it is there, in its looks. @param {Page} page @param {'en' | 'ko'} language */
async function readsLesson(page, language) {
  await page.click(`#instead [lang=${language}] a`);
  // The page that is left has sections, too.
  const seen = await page.until('the lesson is there to read', () => {
    const sections = [
      .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('main > section')),
    ].map((section) => section.innerText);
    return (
      location.pathname.includes('/lesson.') &&
      document.readyState === 'complete' &&
      sections.length > 0 && {
        language: document.documentElement.lang,
        heading: document.querySelector('h1')?.innerText,
        firsts: sections.map((text) => text.split('\n')[0]),
        shortest: Math.min(...sections.map((text) => text.length)),
        formulas: document.querySelectorAll('math').length,
        paper: getComputedStyle(document.body).getPropertyValue('--paper'),
        width: document.documentElement.scrollWidth - innerWidth,
        links: [...document.querySelectorAll('a')].map((link) => link.getAttribute('href')),
        torn: [
          ...new Set(
            [...document.querySelectorAll('.on-one-line')].map((one) => getComputedStyle(one).whiteSpace),
          ),
          ...[...document.querySelectorAll('p, th, td')].flatMap(
            ({ textContent }) =>
              textContent?.match(/[)”°%][가-힣]+|[가-힣]\(|\b(?:CMA|self)-[A-Za-z]/g) ?? [],
          ),
          // A symbol and what opens a bracket around it, or its sine.
          ...[...document.querySelectorAll(':is(p, td, li) > math')].flatMap(
            ({ previousSibling }) => /(?:\(|\b(?:sin|cos) )$/.exec(previousSibling?.nodeValue ?? '') ?? [],
          ),
        ],
      }
    );
  });
  const korean = language === 'ko';
  assert.equal(seen.language, language);
  assert.equal(seen.heading, korean ? '글로 읽는 수업' : 'The lesson, to read');
  assert.equal(seen.firsts.length, 15);
  for (const [i, first] of seen.firsts.entries())
    assert.match(first, new RegExp(`^${i + 1}\\. ${korean ? '.*[가-힣]' : '[A-Z]'}`));
  assert.ok(seen.shortest > 200, 'a section of it is empty');
  assert.ok(seen.formulas > 20);
  assert.notEqual(seen.paper, '', 'it has no style');
  assert.ok(seen.width <= 0, 'it is wider than the window');
  assert.deepEqual(seen.torn, ['nowrap'], 'what belongs together can be on two lines');
  assert.deepEqual(seen.links, [`./#lesson&lang=${language}`, `./lesson.${korean ? 'en' : 'ko'}.html`]);
  if (page.engine === 'chromium') assert.deepEqual(await page.obstacles(), []);
}

engineTest('without its scripts, or where they are forbidden, the page can be read', async (page) => {
  await withSite(page, without(/assets.*\.js$/), async (address) => {
    await page.visit(address);
    // However long the way from here to there takes.
    await page.evaluate(() => {
      for (const wait of document.getAnimations()) {
        wait.pause();
        wait.currentTime = 0;
      }
    });
    assert.equal(
      (await inSight(page)).picture,
      false,
      'it is told at once, while the page may still be loading',
    );
    await page.evaluate(() => {
      for (const wait of document.getAnimations()) wait.finish();
    });
    const { why, lessons, captions, picture } = await inSight(page);
    assert.match(why, /^No robots yet\?.*Firefox.*\n+.*Firefox/s);
    assert.deepEqual([picture, captions.length], [true, 2]);
    assert.deepEqual(lessons, ['The lesson, to read', '글로 읽는 수업']);
    await readsLesson(page, 'en');
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
    if (inside?.readyState !== 'complete') return null;
    const picture = inside?.querySelector('#instead svg');
    const links = [...(inside?.querySelectorAll('#instead a') ?? [])].filter((link) =>
      link.checkVisibility({ visibilityProperty: true }),
    );
    return picture?.checkVisibility({ visibilityProperty: true }) && text && [text, links.length];
  });
  assert.match(String(seen[0]), /need JavaScript.*JavaScript/);
  assert.equal(seen[1], 2);
});

pageTest('without its styles the page does not open, and says that a file of it is missing', async (page) => {
  await withSite(page, without(/assets.index-.*\.css$/), async (address) => {
    await page.visit(`${address}#lab`);
    await page.until('the page has seen it', () =>
      /** @type {any} */ (window).collectedProblems.some((/** @type {string} */ one) =>
        one.includes('no styles'),
      ),
    );
    const { why, instrument } = await inSight(page);
    assert.match(why, /slow.*a file of it is missing/s);
    assert.equal(instrument, false);
  });
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
    // Nobody can catch it but who says so.
    await page.leave();
    assert.match(page.uncaught, /^uncaught: [^\n]*RuntimeError[^\n]*\n$/);
    page.uncaught = '';
  });
});

/** @param {string} name */
const built = (name) => readFile(new URL(`../../../dist/${name}`, import.meta.url), 'utf8');

test('what is there to read has every number, and is what the core says today', async () => {
  const { linked, inside, pages } = await writeInstead();
  assert.doesNotMatch(inside, /[–…]<|undefined|NaN|null|\{/);
  assert.doesNotMatch(inside, / style=|href=|<a |<script|∞/);
  assert.equal(inside.match(/<details/g)?.length, 2);
  assert.equal(inside.match(/<h2/g)?.length, 30);
  const site = await built('index.html');
  assert.ok(site.includes(linked), 'the site has another');
  assert.ok((await built('ep-locomotion.html')).includes(inside), 'the one file has another');
  const looks = /<link rel="(stylesheet|icon)"[^>]*>/g;
  for (const { fileName, html } of pages) {
    const page = await built(fileName);
    // Beside those of the site the styles of the lesson, which are loaded with it.
    const styles = [...page.matchAll(looks)].map(([tag]) => tag);
    for (const own of site.match(looks) ?? []) assert.ok(styles.includes(own), own);
    for (const [, file] of styles.join().matchAll(/href="\.\/([^"]*)"/g)) assert.ok(await built(file), file);
    assert.match(await built(/assets\/page-[^"]*\.css/.exec(page)?.[0] ?? ''), /\.formula-lines/);
    assert.equal(page, html(styles.join('\n  ')), `${fileName} is another`);
    assert.doesNotMatch(page, / style=|<script|<style/);
  }
});

pageTest('the one file has the lesson to read in it, where the core cannot run', async (page) => {
  const before = 'delete globalThis.WebAssembly;';
  const policy = { 'script-src': "'self' 'unsafe-inline'", 'style-src': "'unsafe-inline'" };
  await withSite(page, { before, policy }, async (address) => {
    await page.visit(`${address}ep-locomotion.html#lab&lang=ko`);
    const sections = await page.until('the lesson is there to read', () => {
      const seen = [
        .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#instead details > section')),
      ];
      return (
        document.querySelector('main > .message:not(#message)') &&
        seen.filter((section) => section.checkVisibility()).map((section) => section.innerText)
      );
    });
    assert.equal(sections.length, 15);
    assert.match(sections[0], /^1\. [가-힣]/);
  });
});
