// The languages of the page: each is complete, the link carries it, and longer words find their place.
import assert from 'node:assert/strict';
import { readdirSync, readFileSync } from 'node:fs';
import { join } from 'node:path';
import { test } from 'node:test';
import { fileURLToPath } from 'node:url';
import { pageNames } from '../../www/state.js';
import * as en from '../../www/words/en/index.js';
import * as ko from '../../www/words/ko/index.js';
import { languageOf } from '../../www/words/language.js';
import { Key, pageTest } from './browsers.js';
import { checked, read } from './reading.js';

/** @typedef {import('./browsers.js').Page} Page */

const source = fileURLToPath(new URL('../../www/', import.meta.url));

/** Shorter ones are symbols and units. */
const latinWord = /[A-Za-z]{3,}/;
/** Names, keys, units and functions that stay as they are. */
const names =
  /\b(CSV|PNG|SVG|Kim|Shim|Kanayama|Enter|Shift|Alt|Ctrl|Esc|Tab|max|rad|cos|sin|exp|WebAssembly|Node|ep-locomotion|Chrome|Firefox|Safari|[0-9a-f]{8,})\b/g;

/** Every text of a language by its place; functions are named. @param {unknown} value @param {string} place @returns {[string, string][]} */
function textsOf(value, place) {
  if (typeof value === 'function') return [[place, 'function']];
  if (value === null || typeof value !== 'object') return [[place, `${typeof value}: ${value}`]];
  return Object.entries(value).flatMap(([key, inner]) => textsOf(inner, place ? `${place}.${key}` : key));
}

/** Places that hold an identifier, which is the same in every language. @param {string} place */
const isIdentifier = (place) =>
  /\.(value|id|symbol|className|unit|letter|index)$|^lab\.(costParts|untils)\.\d\.0$|^keys\.single\.\d\.[02]$|^lab\.gains|^(disturbance|curves)\.units|^luck\.gainColumns|^disturbance\.formulas/.test(
    place,
  );

test('Korean has the words of English, and none of them is English', () => {
  const [english, korean] = [en, ko].map((words) => new Map(textsOf(words, '')));
  assert.deepEqual([...korean.keys()].sort(), [...english.keys()].sort());
  const kind = (/** @type {string | undefined} */ text) => text?.split(':')[0];
  for (const [place, text] of english) {
    assert.equal(kind(korean.get(place)), kind(text), place);
    if (!text.startsWith('string: ') || isIdentifier(place)) continue;
    const own = text.slice('string: '.length).replaceAll(names, '');
    if (latinWord.test(own)) assert.notEqual(korean.get(place), text, `${place} is English in Korean`);
  }
});

test('no view has words of its own language', () => {
  const views = readdirSync(source, { recursive: true, encoding: 'utf8' }).filter(
    (name) => name.endsWith('.js') && !name.startsWith('words'),
  );
  assert.ok(views.length > 50);
  for (const name of views)
    assert.doesNotMatch(readFileSync(join(source, name), 'utf8'), /from '[^']*words\/(en|ko)\//, name);
});

test('the link says the language; without a link the browser does', () => {
  for (const [link, preferred, language] of /** @type {const} */ ([
    ['', ['en-GB'], 'en'],
    ['', ['ko-KR', 'en'], 'ko'],
    ['', ['fr', 'ko'], 'ko'],
    ['', ['fr'], 'en'],
    ['', [], 'en'],
    ['lab', ['ko'], 'en'],
    ['lab&v=1&seed=7', ['ko'], 'en'],
    ['lab&v=1&lang=ko', ['en'], 'ko'],
    ['curves&v=1&seed=7&lang=ko', ['en'], 'ko'],
    ['lab&v=1&lang=xx', ['ko'], 'en'],
  ]))
    assert.equal(languageOf(link, preferred), language, `#${link} for ${preferred}`);
});

/** What of the page that is in sight, or read aloud, is Latin letters. @param {Page} page */
async function english(page) {
  const texts = await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    /** @type {string[]} */
    const found = [document.title];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (!parent || parent.closest('script, style, #language')) continue;
      if ((parent.closest('select') ?? parent).checkVisibility())
        found.push(walker.currentNode.nodeValue ?? '');
    }
    for (const element of document.body.querySelectorAll('*'))
      if (element.checkVisibility() && element.id !== 'language')
        for (const name of [
          'aria-label',
          'aria-valuetext',
          'aria-description',
          'title',
          'placeholder',
          'alt',
        ])
          found.push(element.getAttribute(name) ?? '');
    return found;
  });
  return texts.filter((text) => latinWord.test(text.replaceAll(names, '')));
}

/** @param {Page} page @param {string} where */
async function isKorean(page, where) {
  assert.deepEqual(await english(page), [], where);
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'ko');
}

pageTest('every part is Korean with lang=ko', async (page) => {
  for (const name of pageNames) {
    await page.open(`#${name}&v=1&lang=ko&generation=2&pin1=${encodeURIComponent('가~5,1,5')}`);
    await isKorean(page, name);
  }
  for (const view of ['stability', 'compare', 'numbers']) {
    await page.open(`#curves&v=1&lang=ko&view=${view}&preset=acceleration-limits&seed=2`);
    await isKorean(page, view);
  }
  for (const phase of ['mutation', 'drive', 'tournament', 'ranking', 'survivors']) {
    await page.open(`#generation&v=1&lang=ko&generation=2&phase=${phase}`);
    await isKorean(page, phase);
  }
  await page.click('#generation-table');
  await isKorean(page, 'the table of a generation');
});

pageTest('what is opened, refused and computed is Korean', async (page) => {
  await page.open('#lab&v=1&lang=ko');
  await page.click('#keys-button');
  await isKorean(page, 'the keys');
  await page.click('#keys-close');
  await page.click('#keep-button');
  await isKorean(page, 'the dialog that keeps a run');
  await page.click('#keep-checks');
  await checked(page);
  await isKorean(page, 'the checks');
  await page.click('#checks-close');
  await page.click('#settings-button');
  await isKorean(page, 'the settings');
  await page.click('#settings-close');
  await page.click('#curve-choice-sigmas');
  await isKorean(page, 'the step sizes');
  const gain = await page.element('#gain-kx');
  await gain.clear();
  await gain.sendKeys('1e999', Key.ENTER);
  await page.until('the gain is refused', () => document.querySelector('#gains [aria-invalid="true"]'));
  await isKorean(page, 'a refused gain');
  await page.open('#lab&v=1&lang=ko&goal.x=1000000&evolution.population=0.5');
  assert.match(await page.text('#message'), /goal\.x: 허용되는 값은 -1000 이상 1000 m 이하의 수입니다/);
  assert.match(await page.text('#message'), /허용되는 값은 1 이상 2000 이하의 정수입니다/);
});

pageTest('what the workers find is told in Korean', async (page) => {
  await page.open('#training&v=1&lang=ko');
  await page.click('#training-generations option:first-child');
  await page.click('#training-evolve');
  await page.until('all three are evolved', () =>
    document.getElementById('training-finding')?.textContent?.includes('격자'),
  );
  await isKorean(page, 'training');
  await page.click('#page-luck');
  await page.click('#luck-count option:first-child');
  await page.click('#luck-generations option:first-child');
  await page.click('#luck-run');
  await page.until('the seeds have run', () =>
    document.getElementById('luck-finding')?.textContent?.includes('무작위 탐색의 중앙값'),
  );
  await isKorean(page, 'luck');
  await page.click('#luck-table');
  await isKorean(page, 'the table of all seeds');
  await page.click('#luck-close');
  for (const [name, found] of [
    ['robustness', '#robustness-share'],
    ['landscape', '#landscape-readout'],
    ['disturbance', '#remains-text'],
  ]) {
    await page.click(`#page-${name}`);
    await page.until(
      `${name} is computed`,
      (selector) => /\d/.test(document.querySelector(selector)?.textContent ?? ''),
      found,
    );
    await isKorean(page, name);
  }
});

/** Waits until the page is there in a language. @param {Page} page @param {string} language */
const loaded = (page, language) =>
  page.until(
    `the page is in ${language}`,
    (name) => document.documentElement.lang === name && document.documentElement.dataset.ready === 'true',
    language,
  );

pageTest(
  'the link to the other language keeps the run, and "back" brings the first one back',
  async (page) => {
    await page.open('#lab&v=1&seed=7&generation=5&drives=paper-ep');
    const before = await read(page);
    assert.equal(await page.text('#language'), '한국어');
    await page.focus('#language');
    await page.press(Key.ENTER);
    await loaded(page, 'ko');
    assert.equal(await page.text('h1'), ko.lab.texts.pageTitle);
    const korean = await read(page);
    for (const key of /** @type {const} */ (['seed', 'generation', 'driver', 'cost']))
      assert.equal(korean[key], before[key], key);
    assert.match(await page.evaluate(() => location.hash), /[&]lang=ko/);
    await page.click('#page-curves');
    await page.until('the link of the part says the language', () =>
      /^#curves&.*lang=ko/.test(location.hash),
    );
    await page.click('#page-lab');
    await page.click('#language');
    await loaded(page, 'en');
    assert.doesNotMatch(await page.evaluate(() => location.hash), /lang/);
    const after = await read(page);
    for (const key of /** @type {const} */ (['seed', 'generation', 'driver', 'cost']))
      assert.equal(after[key], before[key], key);
    await page.evaluate(() => history.back());
    await loaded(page, 'ko');
  },
);

/** Makes every text on the page 40 % longer, and says what then finds no place. @param {Page} page */
const overflowing = (page) =>
  page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const node = walker.currentNode;
      const text = (node.nodeValue ?? '').trim();
      if (/\p{L}{3}/u.test(text)) node.nodeValue = `${text}${text.slice(0, Math.ceil(0.4 * text.length))}`;
    }
    const width = document.documentElement.clientWidth;
    const problems = [];
    const whole = document.documentElement.scrollWidth;
    if (whole > width) {
      const last = [...document.body.querySelectorAll('*')].filter(
        (element) => Math.ceil(element.getBoundingClientRect().right) >= whole,
      );
      const name = last.map(({ tagName, id, className }) => `${tagName}#${id}.${className}`).join(', ');
      problems.push(`the page is ${whole} px wide, not ${width}: ${name}`);
    }
    for (const face of document.querySelectorAll('button, .segmented span, nav a, #language')) {
      if (!face.checkVisibility() || !face.textContent?.trim()) continue;
      // What is only read aloud has no place to find.
      const end = face.querySelector('span:not(.symbol)');
      const range = document.createRange();
      range.selectNodeContents(face);
      if (end && getComputedStyle(end).clipPath !== 'none') range.setEndBefore(end);
      const [text, box] = [range.getBoundingClientRect(), face.getBoundingClientRect()];
      const scrolls = face.closest('nav, .generation-scroll, .curves-scroll, .luck-scroll');
      const cut = text.left < box.left - 1 || text.right > box.right + 1;
      if (cut || (!scrolls && (text.left < 0 || text.right > width)))
        problems.push(`${face.id || face.parentElement?.id || face.className}: ${face.textContent}`);
    }
    for (const box of document.querySelectorAll('select, .bar, .heading, .segmented, p, ul, table')) {
      const { left, right } = box.getBoundingClientRect();
      const scrolls = box.closest('nav, .generation-scroll, .curves-scroll, .luck-scroll, .visually-hidden');
      if (!scrolls && box.checkVisibility() && (left < -1 || right > width + 1))
        problems.push(`${box.id || box.className} ends at ${right}, the page at ${width}`);
    }
    return problems;
  });

for (const [width, height] of [
  [1440, 900],
  [1024, 768],
  [390, 844],
])
  pageTest(`words that are 40 % longer find their place at ${width} × ${height}`, async (page) => {
    // Two engines stop at a somewhat greater width.
    await page.resize(width, height);
    /** @type {Record<string, string[]>} */
    const problems = {};
    for (const name of pageNames) {
      await page.open(`#${name}&v=1&generation=2&pin1=${encodeURIComponent('first~5,1,5')}`);
      problems[name] = await overflowing(page);
    }
    for (const view of ['stability', 'compare']) {
      await page.open(`#curves&v=1&view=${view}&generation=2`);
      problems[view] = await overflowing(page);
    }
    for (const phase of ['mutation', 'drive', 'tournament', 'ranking', 'survivors']) {
      await page.open(`#generation&v=1&generation=2&phase=${phase}`);
      problems[phase] = await overflowing(page);
    }
    for (const button of ['keys', 'keep', 'settings']) {
      await page.open();
      await page.click(`#${button}-button`);
      problems[button] = await overflowing(page);
    }
    await page.open();
    await page.click('#keys-button');
    await page.click('#keys-checks');
    await checked(page);
    problems.checks = await overflowing(page);
    const found = Object.entries(problems).filter(([, texts]) => texts.length > 0);
    assert.deepEqual(Object.fromEntries(found), {});
  });
