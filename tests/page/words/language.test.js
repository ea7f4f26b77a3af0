// The languages of the page: each is complete, the link carries it, and longer words find their place.
import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { linkOfStep, stepNames } from '../../../www/lesson/path.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { ko, latinWord, sameInBoth } from '../harness/words.js';
import { checked, read } from '../harness/reading.js';
import { linksTo, samples } from '../parts/samples.js';
import { follow, inFrame } from '../whole/surround.js';
import { overflowing } from './overflowing.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** What of the page that is in sight, or read aloud, is Latin letters. @param {Page} page */
async function english(page) {
  const texts = await page.evaluate(() => {
    for (const details of document.querySelectorAll('details')) details.open = true;
    const description = document.querySelector('meta[name=description]')?.getAttribute('content') ?? '';
    /** @type {string[]} */
    const found = [document.title, description];
    const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
    while (walker.nextNode()) {
      const parent = walker.currentNode.parentElement;
      if (!parent || parent.closest('script, style, #language')) continue;
      if ((parent.closest('select') ?? parent).checkVisibility())
        found.push(walker.currentNode.nodeValue ?? '');
    }
    for (const element of document.body.querySelectorAll('*')) {
      if (!element.checkVisibility() || element.id === 'language') continue;
      for (const name of [
        'aria-label',
        'aria-valuetext',
        'aria-description',
        'aria-roledescription',
        'title',
        'placeholder',
        'alt',
        'label',
      ])
        found.push(element.getAttribute(name) ?? '');
      // Read aloud although it may be out of sight.
      for (const name of ['aria-labelledby', 'aria-describedby'])
        for (const id of element.getAttribute(name)?.split(' ') ?? []) {
          const other = document.getElementById(id);
          // A table is called what its caption says.
          found.push((other instanceof HTMLTableElement ? other.caption : other)?.textContent ?? '');
        }
    }
    return found;
  });
  return texts.filter((text) => latinWord.test(text.replaceAll(sameInBoth, '')));
}

/** @param {Page} page @param {string} where */
async function isKorean(page, where) {
  assert.deepEqual(await english(page), [], where);
  assert.equal(await page.evaluate(() => document.documentElement.lang), 'ko');
}

/** The link of every part, of all that it can show without a press, and of every step of the lesson. @type {readonly string[]} */
const links = [
  ...pageNames.map((name) => `${name}&v=1&generation=2&pin1=${encodeURIComponent('가~5,1,5')}`),
  ...linksTo('views').map((link) => `${link}&generation=2&preset=acceleration-limits&seed=2`),
  ...linksTo('more').map((link) => `${link}&generation=2`),
  ...stepNames.map((_, i) => linkOfStep(i + 1)),
];

/** Follows a link of the page, which does not load it again. @param {Page} page @param {string} link @param {string} language */
async function followIn(page, link, language) {
  await follow(page, `${link}&lang=${language}`);
  const [, name, value] = /^(?:(lesson)&step=)?(\w+)/.exec(link) ?? [];
  const open = await page.evaluate(() => ({
    part: document.body.dataset.open,
    lesson: document.body.hasAttribute('data-lesson'),
    message: document.getElementById('message')?.textContent,
  }));
  assert.equal(open.message, '', link);
  assert.equal(name ? open.lesson : open.part, name ? true : value, link);
}

pageTest('what is drawn instead, and refused, is Korean', async (page) => {
  await page.open('#lab&v=1&lang=ko');
  await page.click('#curve-choice-sigmas');
  await isKorean(page, 'the step sizes');
  const gain = await page.element('#gain-kx');
  await gain.clear();
  await gain.sendKeys('1e999', Key.ENTER);
  await page.until('the gain is refused', () => document.querySelector('#gains [aria-invalid="true"]'));
  await isKorean(page, 'a refused gain');
  await page.open('#lab&v=1&lang=ko&goal.x=1000000&evolution.population=0.5');
  assert.match(
    await page.text('#message'),
    /goal\.x 항목은 쓰지 않았습니다\. 허용되는 값은 -1000 이상 1000 m 이하의 수입니다/,
  );
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
  await page.click('#table-close');
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

engineTest(
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

pageTest(
  'a language that is asked for twice, with something done in between, comes with all of it',
  async (page) => {
    await page.open('#lab&v=1&generation=3');
    await page.evaluate(() => {
      /** @type {((answer: Response) => void)[]} */
      const asked = [];
      window.fetch = () => new Promise((answer) => asked.push(answer));
      addEventListener('keydown', () => asked.shift()?.(new Response('id="instrument"')));
    });
    await page.click('#language');
    await page.click('#one-generation');
    await page.until('it has evolved', () => document.getElementById('generation')?.textContent === '4');
    await page.click('#language');
    await page.press(Key.SHIFT);
    await page.evaluate(() => pageFrames.settled());
    await page.click('#page-curves');
    await page.until('Curves is open', () => document.body.dataset.open === 'curves');
    await page.press(Key.SHIFT);
    await loaded(page, 'ko');
    assert.match(await page.evaluate(() => location.hash), /^#curves&(?=.*lang=ko).*generation=4/);
  },
);

/** What opens a table, by the link of where it is. */
const tableButtons = Object.fromEntries(
  Object.entries(samples).flatMap(([name, { tables = {} }]) =>
    Object.entries(tables).map(([more, button]) => [more ? `${name}&v=1&${more}` : name, button]),
  ),
);

/** Opens a table as soon as there is something to fill it with. @param {Page} page @param {string} part @param {string} button @param {string} language */
async function openTable(page, part, button, language) {
  await followIn(page, `${part}&generation=2`, language);
  await page.until(
    `the table of ${part} is open`,
    (id) => {
      if (!document.querySelector('dialog[open]')) document.getElementById(id)?.click();
      return document.querySelector('dialog[open] tbody tr');
    },
    button,
  );
}

for (const [language, name] of Object.entries({
  en: 'English words that are 40 % longer find their place on every screen',
  ko: 'every part and every step is Korean with lang=ko, and the strictest policy refuses nothing; 40 % longer its words find their place on every screen',
}))
  pageTest(name, async (page) => {
    await inFrame(page, `#lab&v=1&lang=${language}`, async () => {
      /** @type {string[]} */
      const problems = [];
      const look = async (/** @type {string} */ where) => {
        if (language === 'ko') await isKorean(page, where);
        problems.push(...(await overflowing(page, where)));
      };
      for (const link of links) {
        await followIn(page, link, language);
        await look(link);
        const offered = await page.evaluate(() =>
          [...document.querySelectorAll('button[id$="-table"]')]
            .filter((button) => button.checkVisibility())
            .map(({ id }) => id),
        );
        for (const id of offered)
          assert.ok(
            Object.values(tableButtons).includes(id),
            `${id} is in no \`tables\` of tests/page/parts/samples/`,
          );
      }
      for (const button of ['keys', 'keep', 'settings']) {
        await page.click(`#${button}-button`);
        await look(button);
        if (button === 'keys') {
          await page.click('#keys-checks');
          await checked(page);
          await look('checks');
        }
        await page.click(button === 'keys' ? '#checks-close' : `#${button}-close`);
      }
      for (const [part, button] of Object.entries(tableButtons)) {
        await openTable(page, part, button, language);
        await look(button);
        await page.press(Key.ESCAPE);
      }
      assert.deepEqual(problems, []);
      assert.deepEqual(await page.problems(), []);
    });
  });
