// Pictures of what is on screen: each is offered, looks like the screen, and says where it comes from.
import assert from 'node:assert/strict';
import { engineTest, pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { samples } from '../parts/samples.js';
import { difference, isPlain, placeOf, readPng, readSvg, saved } from './picture-files.js';

const margin = 12;
const base64 = (/** @type {string} */ type, /** @type {Buffer} */ bytes) =>
  `data:${type};base64,${bytes.toString('base64')}`;

test('the pictures of every part are tried', () => {
  for (const [name, { pictures }] of Object.entries(samples))
    assert.ok(pictures.length > 0, `${name} has no pictures in tests/page/parts/samples/`);
});

/** Lines and letters, and a map: in every engine. */
const inAll = ['fitness', 'landscape'];

const shown = Object.entries(samples).flatMap(([name, { pictures }]) =>
  pictures.map((one) => ({ name, ...one })),
);

for (const { name, setUp, pictures } of shown)
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
        await pageFrames.settled();
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
          [png, svg].map((file) => file.name.replace(stem, '').replace(/-[0-9a-f]{8}\./, '.')),
          key === 'generation'
            ? ['generation-drive.png', 'generation-drive.svg']
            : [`${key}.png`, `${key}.svg`],
        );

        const place = await placeOf(page, key);
        const inPng = readPng(png.bytes);
        assert.equal(inPng.width, 2 * Math.ceil(place.right - place.left + 2 * margin));
        if (!apart) assert.equal(inPng.height, 2 * Math.ceil(place.bottom - place.top + 2 * margin));
        assert.equal(inPng.texts.Title, title);
        assert.equal(inPng.texts.Source, link);
        assert.match(inPng.texts.Software, /^ep-locomotion \d+\.\d+\.\d+$/);

        isPlain(svg.bytes.toString('utf8'));
        const inSvg = await readSvg(page, svg.bytes.toString('utf8'));
        assert.equal(inSvg.error, null);
        assert.deepEqual(
          [inSvg.title, inSvg.link, inSvg.creator, inSvg.description],
          [title, link, inPng.texts.Software, inPng.texts.Description],
        );
        assert.deepEqual(inSvg.outside, []);
        assert.ok(!inSvg.names.includes('script'));
        const shapes = inSvg.names.filter((one) => one === 'path').length;
        assert.ok(shapes >= lines, `${key}: ${shapes} shapes, not ${lines}`);
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
  // As wide as the strip of the law needs.
  await page.resize(1300, 900);
  for (const [step, shapes, text, ...also] of /** @type {const} */ ([
    // Letters of formulas, which lean, lines of fractions, and on both sides of the bars the limits.
    [
      ...['law', 4, 'the sum of all'],
      [/font-style="italic"[^>]*>k</g, 5],
      [/<path d="M([\d.]+) [\d.]+L\1 [\d.]+" fill="none" stroke="rgb\(89, 98, 109\)" [^>]*dasharray/g, 18],
      [/<path d="M[\d.]+ ([\d.]+)L[\d.]+ \1" fill="none" stroke="rgb\(27, 31, 36\)" stroke-width="1"\/>/g, 2],
    ],
    // Its letters are scaled with the rest.
    [
      ...['stability', 9, 'V 0'],
      [/<path [^>]*stroke-opacity="0.45"/g, 5],
      [/font-size="\d+\.\d+"[^>]*>V 0</g, 1],
    ],
    ['limits', 8, 'done'],
    // Names that can be pressed.
    ['cost', 12, 'lowest', [/>Paper: EP<|>Paper: arbitrary<|>Gentle<|>By hand</g, 4]],
    // The lines of descent, none stretched, through bells that one sees through, on an edge.
    [
      ...['sigma', 20, 'born'],
      [/fill="none" stroke="[^>]*stroke-width="1.5" stroke-dasharray="2 3"/g, 3],
      [/<path d="M[\d. L]*" fill="[^>]* fill-opacity="0.14"/g, 30],
      [/<path d="M[\d. ]*L[\d. ]*" fill="none" stroke="rgb\(217, 220, 214\)"/g, 3],
    ],
    ['duel', 60, 'parked'],
    ['disturbance', 5, 'Seen from above', [/fill-opacity="0.14"[^>]*stroke-dasharray="5 4"/g, 2]],
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
    const { bytes, name } = await saved(page, 'The picture of this step: save as SVG');
    const { error, names, texts } = await readSvg(page, bytes.toString('utf8'));
    assert.equal(error, null, step);
    assert.ok(names.filter((one) => one === 'path').length >= shapes, `${step}: ${names.length} shapes`);
    assert.ok(texts.join(' ').includes(text), `${step}: ${texts}`);
    assert.doesNotMatch(bytes.toString('utf8'), /color\(/, step);
    isPlain(bytes.toString('utf8'));
    assert.match(name, new RegExp(`-step-${step}-[0-9a-f]{8}\\.svg$`));
    for (const [what, least] of also)
      assert.ok((bytes.toString('utf8').match(what) ?? []).length >= least, `${step}: ${what}`);
  }
});

pageTest('pictures of different things have different names', async (page) => {
  const names = [];
  for (const [link, title] of [
    ['lab&v=1', 'The plane'],
    ['lab&v=1&goal.x=1', 'The plane'],
    ['lab&v=1&drives=hand&gains=3,1,5', 'The plane'],
    ['generation&v=1&generation=4&phase=mutation', 'The generation'],
    ['generation&v=1&generation=4&phase=tournament', 'The generation'],
    ['generation&v=1&generation=4&phase=mutation&evolution.method=cma-es', 'The generation'],
  ]) {
    await page.open(`#${link}`);
    await page.click('#keep-button');
    const { name } = await saved(page, `${title}: save as SVG`);
    assert.match(name, /^[a-z0-9-]+\.svg$/);
    names.push(name);
  }
  assert.equal(new Set(names).size, names.length, names.join('\n'));
  assert.match(names[4], /-generation-tournament-/);
});

pageTest('where a browser gives noise for what a page has drawn, no file of noise is saved', async (page) => {
  await page.open('#lab');
  await page.evaluate(() => {
    const { prototype } = CanvasRenderingContext2D;
    const { getImageData } = prototype;
    prototype.getImageData = function (...given) {
      const image = getImageData.apply(this, given);
      return new ImageData(
        image.data.map((_, i) => (37 * i) % 256),
        image.width,
      );
    };
  });
  await page.click('#keep-button');
  await page.click('#keep-pictures li:first-child button:first-of-type');
  await page.until('it is said', () =>
    /was not saved: .*SVG/.test(document.getElementById('keep-status')?.textContent ?? ''),
  );
});
