// Pictures of what is on screen: each is offered, looks like the screen, and says where it comes from.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { runContest } from '../parts/contests.js';
import { difference, placeOf, readPng, readSvg, saved } from './picture-files.js';

const pageNames = links.pages;

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {{ name: string, key: string, texts: readonly string[], lines: number, apart?: boolean }} Expected Some of its texts, and how many shapes there are at least. Apart: other things stand between its parts. */
/** @typedef {{ page: string, setUp?: (page: Page) => Promise<unknown>, pictures: readonly Expected[] }} Part */

const plane = { name: 'The plane', key: 'plane', texts: ['0 m', 'Goal 2.00 m, 2.00 m, 45°'], lines: 6 };

/** @param {Page} page @param {string} id @param {string} beginning */
const textOf = (page, id, beginning) =>
  page.until(
    `#${id} says ${beginning}`,
    (element, text) =>
      document.getElementById(element)?.textContent?.replace(/\s/g, ' ').startsWith(text) ?? false,
    id,
    beginning,
  );

/** @type {readonly Part[]} */
const parts = [
  {
    page: 'park',
    setUp: (page) =>
      page.until('all have driven', () => document.querySelector('.park-side [role="status"]')?.textContent),
    pictures: [{ name: 'The parking place', key: 'park', texts: [], lines: 200 }],
  },
  {
    page: 'lab',
    setUp: async (page) => {
      await page.click('#pin');
      for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
      await textOf(page, 'generation', '3');
    },
    pictures: [
      { ...plane, texts: ['best of generation 3', ...plane.texts], lines: 20 },
      {
        name: 'The fitness curve',
        key: 'fitness',
        texts: ['best', 'median', 'paper’s EP', 'generation', '10', '20'],
        lines: 5,
      },
    ],
  },
  {
    page: 'lab',
    setUp: (page) => page.click('#curve-choice label:last-of-type'),
    pictures: [
      plane,
      { name: 'The step sizes σ', key: 'sigmas', texts: ['σ of', 'θ', 'generation'], lines: 4 },
    ],
  },
  {
    page: 'generation',
    setUp: async (page) => {
      await page.click('#one-generation');
      await page.click('#generation-phases label:nth-of-type(3)');
    },
    pictures: [
      plane,
      {
        name: 'The generation',
        key: 'generation',
        texts: ['parent', 'offspring', 'J', 'pair'],
        lines: 40,
        apart: true,
      },
    ],
  },
  {
    page: 'curves',
    pictures: [
      plane,
      { name: 'The run against time', key: 'curves', texts: ['θ', 'rad/s', 'energy', '0.2 s'], lines: 15 },
    ],
  },
  {
    page: 'curves',
    setUp: (page) => page.click('#curves-view-stability'),
    pictures: [
      plane,
      {
        name: 'V and its rate against time',
        key: 'stability',
        texts: ['V = ½ xₑ²', 'V̇ robot', 'sin² θ', '0.2 s'],
        lines: 12,
      },
    ],
  },
  {
    page: 'landscape',
    setUp: (page) => textOf(page, 'landscape-note', '16 384 drives'),
    pictures: [
      plane,
      { name: 'The landscape of J', key: 'landscape', texts: ['paper’s EP', '10', 'k', 'θ'], lines: 30 },
    ],
  },
  {
    page: 'robustness',
    setUp: (page) => textOf(page, 'robustness-note', '118 098 starts in'),
    pictures: [
      plane,
      { name: 'The map of starts', key: 'robustness', texts: ['goal', 'none arrives', 'all'], lines: 20 },
    ],
  },
  {
    page: 'training',
    setUp: (page) => textOf(page, 'training-seen-title', 'From the start:'),
    pictures: [
      plane,
      { name: 'The starts of training', key: 'training', texts: ['Filled arrives,'], lines: 1000 },
    ],
  },
  {
    page: 'disturbance',
    setUp: (page) => textOf(page, 'remains-text', 'In the last'),
    pictures: [
      { ...plane, texts: ['0 m'] },
      {
        name: 'What remains of the error',
        key: 'disturbance',
        texts: ['this drive', 'largest', '|sin', '2 s', '32 other starts'],
        lines: 15,
      },
    ],
  },
  {
    page: 'luck',
    setUp: async (page) => {
      await page.click('#luck-count option[value="20"]');
      await page.click('#luck-generations option[value="50"]');
      await page.click('#luck-run');
      await textOf(page, 'luck-finding', 'After 50 generations');
    },
    pictures: [
      plane,
      {
        name: 'The fitness curve of all seeds',
        key: 'luck-curve',
        texts: ['random search', 'evolution', 'seed 1', '50'],
        lines: 40,
      },
      { name: 'The gains of all seeds', key: 'luck-gains', texts: ['k', 'θ', 'median'], lines: 60 },
    ],
  },
  {
    page: 'luck',
    setUp: async (page) => {
      await page.click('#luck-view label:last-child');
      await page.click('#contest-seeds option[value="15"]');
      await page.click('#contest-budget option[value="1000"]');
      await runContest(page);
    },
    pictures: [
      plane,
      { name: 'The contest', key: 'contest', texts: ['target', 'drives', '100 %'], lines: 12, apart: true },
    ],
  },
];

const margin = 12;
const base64 = (/** @type {string} */ type, /** @type {Buffer} */ bytes) =>
  `data:${type};base64,${bytes.toString('base64')}`;

test('the pictures of every part are tried', () => {
  assert.deepEqual(
    pageNames.filter((name) => parts.every(({ page }) => page !== name)),
    [],
  );
});

/** Lines and letters, and a map: in every engine. */
const inAll = ['fitness', 'landscape'];

for (const { page: name, setUp, pictures } of parts)
  (pictures.some(({ key }) => inAll.includes(key)) ? engineTest : pageTest)(
    `${name}: ${pictures.map((one) => one.key).join(', ')} as files`,
    async (page) => {
      await page.open(`#${name}`);
      await setUp?.(page);
      await page.evaluate(async () => {
        // Park has none.
        const scrub = /** @type {HTMLInputElement | null} */ (document.getElementById('scrub'));
        if (scrub) scrub.value = '1';
        scrub?.dispatchEvent(new Event('input', { bubbles: true }));
        /** @type {HTMLElement} */ (document.activeElement)?.blur();
        scrollTo(0, 0);
        // What moves has arrived, and is drawn.
        await Promise.all(document.getAnimations().map(({ finished }) => finished));
        for (let i = 0; i < 3; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
      });
      // WebKit's driver waits for a frame before it looks at the page, and one at rest makes none.
      const screen = page.engine === 'webkit' ? null : base64('image/png', await page.screenshot());
      await page.click('#keep-button');
      const offered = await page.evaluate(() =>
        [...document.querySelectorAll('#keep-pictures span')].map(({ textContent }) => textContent),
      );
      assert.deepEqual(
        offered,
        pictures.map((one) => one.name),
      );
      const link = await page.evaluate(
        () => /** @type {HTMLInputElement} */ (document.getElementById('keep-link')).value,
      );
      assert.ok(link.includes(`#${name}`), link);

      for (const { name: title, key, texts, lines, apart } of pictures) {
        const png = await saved(page, `${title}: save as PNG`);
        const svg = await saved(page, `${title}: save as SVG`);
        assert.deepEqual([png.type, svg.type], ['image/png', 'image/svg+xml']);
        const stem = /^robot-seed-1-generation-\d+-/;
        assert.deepEqual(
          [png, svg].map((file) => file.name.replace(stem, '')),
          [`${key}.png`, `${key}.svg`],
        );

        const place = await placeOf(page, key);
        const inPng = readPng(png.bytes);
        assert.equal(inPng.width, 2 * Math.ceil(place.right - place.left + 2 * margin));
        if (!apart) assert.equal(inPng.height, 2 * Math.ceil(place.bottom - place.top + 2 * margin));
        assert.equal(inPng.texts.Title, title);
        assert.equal(inPng.texts.Source, link);
        assert.match(inPng.texts.Software, /^ep-locomotion \d+\.\d+\.\d+$/);

        const inSvg = await readSvg(page, svg.bytes.toString('utf8'));
        assert.equal(inSvg.error, null);
        assert.deepEqual(
          [inSvg.title, inSvg.link, inSvg.creator, inSvg.description],
          [title, link, inPng.texts.Software, inPng.texts.Description],
        );
        assert.deepEqual(inSvg.outside, []);
        assert.ok(!inSvg.names.includes('script'));
        assert.ok(inSvg.names.filter((one) => one === 'path').length >= lines, `${key}: shapes`);
        for (const text of texts)
          assert.ok(
            inSvg.texts.some((one) => one?.includes(text)),
            `${key}: “${text}” is not in ${JSON.stringify(inSvg.texts)}`,
          );

        const corner = { x: place.left - margin, y: place.top - margin };
        const pngAddress = base64(png.type, png.bytes);
        const fromPng = await difference(page, base64(svg.type, svg.bytes), pngAddress, { x: 0, y: 0 }, 1, 2);
        assert.ok(fromPng.marked > 0.015, `${key} is blank: ${fromPng.marked}`);
        assert.ok(
          fromPng.mean < Math.min(3, 30 * fromPng.marked),
          `${key}: SVG and PNG differ by ${fromPng.mean}`,
        );
        if (!screen || apart) continue;
        const fromScreen = await difference(page, pngAddress, screen, corner, 2, 1);
        assert.ok(
          fromScreen.mean < Math.min(5, 60 * fromScreen.marked),
          `${key}: PNG and screen differ by ${fromScreen.mean}`,
        );
      }
      assert.deepEqual(await page.problems(), []);
    },
  );

pageTest('the picture beside the words of a step is a file too', async (page) => {
  for (const [step, shapes, text] of /** @type {const} */ ([
    ['law', 4, 'asked for'],
    ['stability', 9, 'V 0'],
    ['limits', 8, 'done'],
    ['cost', 12, 'lowest'],
    ['sigma', 20, 'born'],
    ['duel', 60, 'parked'],
    ['disturbance', 5, 'Seen from above'],
  ])) {
    await page.open(`#lesson&step=${step}`);
    await page.until(
      'it is drawn',
      (wanted) =>
        document.getElementById('stage')?.textContent?.includes(wanted) ||
        document.querySelector('#stage canvas'),
      text,
    );
    await page.click('#keep-button');
    const { bytes } = await saved(page, 'The picture of this step: save as SVG');
    const { error, names, texts } = await readSvg(page, bytes.toString('utf8'));
    assert.equal(error, null, step);
    assert.ok(names.filter((one) => one === 'path').length >= shapes, `${step}: ${names.length} shapes`);
    assert.ok(texts.join(' ').includes(text), `${step}: ${texts}`);
    assert.doesNotMatch(bytes.toString('utf8'), /color\(/, step);
  }
});
