// Pictures of what is on screen: each is offered, looks like the screen, and says where it comes from.
import assert from 'node:assert/strict';
import { crc32 } from 'node:zlib';
import { links } from '../../../www/lesson/links.js';
import { engineTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';

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
];

/** What a button saves, and under which name. @param {Page} page @param {string} label @returns {Promise<{ name: string, type: string, bytes: Buffer }>} */
async function saved(page, label) {
  const { name, type, url } = await page.evaluate(async (button) => {
    const { createObjectURL } = URL;
    const { click } = HTMLAnchorElement.prototype;
    /** @type {Blob} */
    let blob = new Blob();
    URL.createObjectURL = (object) => {
      blob = /** @type {Blob} */ (object);
      return createObjectURL(object);
    };
    /** @type {string} */
    const download = await new Promise((resolve) => {
      // WebKit's test browser would open a list of downloads, which makes the page narrower.
      HTMLAnchorElement.prototype.click = function () {
        resolve(this.download);
      };
      /** @type {HTMLElement} */ (document.querySelector(`#keep-pictures [aria-label="${button}"]`)).click();
    });
    URL.createObjectURL = createObjectURL;
    HTMLAnchorElement.prototype.click = click;
    /** @type {string} */
    const data = await new Promise((resolve) => {
      const reader = new FileReader();
      reader.onload = () => resolve(String(reader.result));
      reader.readAsDataURL(blob);
    });
    return { name: download, type: blob.type, url: data };
  }, label);
  return { name, type, bytes: Buffer.from(url.slice(url.indexOf(',') + 1), 'base64') };
}

/** The texts in a PNG, and its size; throws if a chunk is damaged. @param {Buffer} png */
function readPng(png) {
  assert.equal(png.subarray(0, 8).toString('latin1'), '\x89PNG\r\n\x1a\n');
  /** @type {Record<string, string>} */
  const texts = {};
  for (let at = 8; at < png.length; ) {
    const length = png.readUInt32BE(at);
    const type = png.toString('latin1', at + 4, at + 8);
    const data = png.subarray(at + 8, at + 8 + length);
    assert.equal(png.readUInt32BE(at + 8 + length), crc32(png.subarray(at + 4, at + 8 + length)), type);
    if (type === 'iTXt') {
      const [keyword, text] = data.toString('utf8').split('\0\0\0\0\0');
      texts[keyword] = text;
    }
    at += 12 + length;
  }
  return { width: png.readUInt32BE(16), height: png.readUInt32BE(20), texts };
}

/** Where a picture is on the screen. @param {Page} page @param {string} key */
const placeOf = (page, key) =>
  page.evaluate((name) => {
    const boxes = [...document.querySelectorAll(`[data-picture="${name}"]`)].map((one) =>
      one.getBoundingClientRect(),
    );
    const seen = boxes.filter(({ width, height }) => width > 0 && height > 0);
    return {
      left: Math.min(...seen.map(({ left }) => left)),
      top: Math.min(...seen.map(({ top }) => top)),
      right: Math.max(...seen.map(({ right }) => right)),
      bottom: Math.max(...seen.map(({ bottom }) => bottom)),
    };
  }, key);

/** How far two pictures differ, from 0 to 255 at a pixel on average, and how much of the first is not blank. @param {Page} page @param {string} first @param {string} second Their addresses. @param {{ x: number, y: number }} offset Where the first one's corner is in the second. @param {number} density Of the first. @param {number} secondDensity */
const difference = (page, first, second, offset, density, secondDensity) =>
  page.evaluate(
    async (one, other, { x, y }, dense, otherDense) => {
      const [image, screen] = await Promise.all(
        [one, other].map(async (src) => {
          const loaded = new Image();
          loaded.src = src;
          await loaded.decode();
          return loaded;
        }),
      );
      const [width, height] = [image.naturalWidth / dense, image.naturalHeight / dense];
      const pixels = [image, screen].map((source, i) => {
        const canvas = document.createElement('canvas');
        [canvas.width, canvas.height] = [width, height];
        const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        context.imageSmoothingQuality = 'high';
        if (i === 0) context.drawImage(source, 0, 0, width, height);
        else
          context.drawImage(
            source,
            -x,
            -y,
            source.naturalWidth / otherDense,
            source.naturalHeight / otherDense,
          );
        return context.getImageData(0, 0, width, height).data;
      });
      let [sum, marked] = [0, 0];
      for (let i = 0; i < pixels[0].length; i += 4) {
        const [a, b] = pixels;
        sum += (Math.abs(a[i] - b[i]) + Math.abs(a[i + 1] - b[i + 1]) + Math.abs(a[i + 2] - b[i + 2])) / 3;
        if (a[i] !== a[0] || a[i + 1] !== a[1] || a[i + 2] !== a[2]) marked += 1;
      }
      const count = pixels[0].length / 4;
      return { mean: sum / count, marked: marked / count };
    },
    first,
    second,
    offset,
    density,
    secondDensity,
  );

/** What is in an SVG, read as the browser reads it. @param {Page} page @param {string} text */
const readSvg = (page, text) =>
  page.evaluate((source) => {
    const svg = new DOMParser().parseFromString(source, 'image/svg+xml');
    const all = [...svg.querySelectorAll('*')];
    const texts = (/** @type {string} */ name) =>
      [...svg.getElementsByTagName(name)].map((one) => one.textContent);
    const addresses = all.flatMap((one) => [one.getAttribute('href'), one.getAttribute('xlink:href')]);
    return {
      error: svg.querySelector('parsererror')?.textContent ?? null,
      names: all.map(({ localName }) => localName),
      texts: texts('text'),
      title: texts('title')[0],
      description: texts('desc')[0],
      creator: texts('dc:creator')[0],
      link: texts('dc:source')[0],
      outside: addresses.filter((one) => one !== null && !one.startsWith('data:image/png')),
    };
  }, text);

const margin = 12;
const base64 = (/** @type {string} */ type, /** @type {Buffer} */ bytes) =>
  `data:${type};base64,${bytes.toString('base64')}`;

test('the pictures of every part are tried', () => {
  assert.deepEqual(
    pageNames.filter((name) => parts.every(({ page }) => page !== name)),
    [],
  );
});

for (const { page: name, setUp, pictures } of parts)
  engineTest(`${name}: ${pictures.map((one) => one.key).join(', ')} as files`, async (page) => {
    await page.open(`#${name}`);
    await setUp?.(page);
    await page.evaluate(async () => {
      const scrub = /** @type {HTMLInputElement} */ (document.getElementById('scrub'));
      scrub.value = '1';
      scrub.dispatchEvent(new Event('input', { bubbles: true }));
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
  });
