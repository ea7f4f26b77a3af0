// In the reader's own colours, and where more contrast is asked for, nothing loses what it says by its colour.
import assert from 'node:assert/strict';
import { Key } from 'selenium-webdriver';
import { pageTest } from '../harness/browsers.js';
import { saved } from '../share/picture-files.js';
import { endSurrounding, follow, surround } from './surround.js';

/** The grounds of what a selector finds that shows its ground alone. @param {import('../harness/browsers.js').Page} page @param {string} selector @param {string} [pseudo] */
const groundsOf = (page, selector, pseudo) =>
  page.evaluate(
    (wanted, before) =>
      [...document.querySelectorAll(wanted)]
        .filter((element) => element.checkVisibility())
        .map((element) => {
          const { backgroundColor, backgroundImage } = getComputedStyle(element, before);
          return `${backgroundColor} ${backgroundImage}`;
        }),
    selector,
    pseudo,
  );

/** @param {readonly string[]} grounds */
const differ = (grounds) => {
  assert.ok(grounds.length > 1);
  assert.equal(new Set(grounds).size, grounds.length, `${grounds}`);
};

pageTest("colours that mean something outlast the reader's own", async (page) => {
  if (page.engine !== 'chromium') return;
  try {
    await surround(page, [1440, 900], { 'forced-colors': 'active' });
    await page.open('#lab&v=1&generation=3');
    differ(await groundsOf(page, '.cost-segment'));
    differ(await groundsOf(page, '.cost-parts li', '::before'));
    differ([...new Set(await groundsOf(page, '#drives span'))]);
    assert.equal(
      await page.evaluate(
        () =>
          getComputedStyle(/** @type {Element} */ (document.getElementById('slider-kx'))).forcedColorAdjust,
      ),
      'none',
    );
    await follow(page, 'generation&v=1&generation=3');
    differ(await groundsOf(page, '.generation-key .key', '::before'));
    await follow(page, 'robustness&v=1');
    await page.until('the shades are there', () => document.querySelector('.legend-bar'));
    assert.match((await groundsOf(page, '.legend-bar'))[0], /gradient/);
  } finally {
    await endSurrounding(page);
  }
});

pageTest(
  'names in charts stand on the ground of the reader, and what cannot be pressed looks so',
  async (page) => {
    if (page.engine !== 'chromium') return;
    try {
      await surround(page, [1440, 900], { 'forced-colors': 'active', 'prefers-color-scheme': 'dark' });
      await page.open('#lab&v=1&generation=20');
      const { ground, grounds } = await page.evaluate(() => {
        const ground = getComputedStyle(document.body).backgroundColor;
        /** How often which colour covers what is under it. @type {Map<string, number>} */
        const counts = new Map();
        for (const canvas of document.querySelectorAll('#curve canvas')) {
          const { width, height } = /** @type {HTMLCanvasElement} */ (canvas);
          const context = /** @type {HTMLCanvasElement} */ (canvas).getContext('2d');
          const { data } = /** @type {CanvasRenderingContext2D} */ (context).getImageData(
            0,
            0,
            width,
            height,
          );
          for (let at = 0; at < data.length; at += 4) {
            const [red, green, blue, alpha] = data.slice(at, at + 4);
            const name = `rgb(${red}, ${green}, ${blue})`;
            if (alpha === 255) counts.set(name, (counts.get(name) ?? 0) + 1);
          }
        }
        return { ground, grounds: [...counts].sort(([, a], [, b]) => b - a).map(([name]) => name) };
      });
      assert.ok(grounds.slice(0, 2).includes(ground), `${ground} is not among ${grounds.slice(0, 4)}`);

      // What is saved is for readers with other colours.
      await page.click('#keep-button');
      const { bytes } = await saved(page, 'The fitness curve: save as SVG');
      assert.doesNotMatch(bytes.toString('utf8'), /"Canvas/);
      await page.press(Key.ESCAPE);
      await follow(page, 'park');
      await page.until('there is something to press', () => document.getElementById('park-evolve'));
      const looks = await page.evaluate(() => {
        const [evolve, again] = ['#park-evolve', '#park-again'].map(
          (one) => /** @type {Element} */ (document.querySelector(one)),
        );
        // However far the film is.
        again.ariaDisabled = 'true';
        return [evolve, again].map((button) => {
          const { color, borderTopColor, opacity } = getComputedStyle(button);
          const isDisabled = button.matches(':disabled, [aria-disabled="true"]');
          return [isDisabled, color, borderTopColor, opacity].join(' ');
        });
      });
      assert.match(looks[0], /^true/);
      assert.equal(looks[1], looks[0]);
    } finally {
      await endSurrounding(page);
    }
  },
);

pageTest('where more contrast is asked for, the edges of controls are as dark as letters', async (page) => {
  if (page.engine !== 'chromium') return;
  const edges = () =>
    page.evaluate(() => {
      const [edge, letters] = ['#one-generation', '#gains-note'].map((one) =>
        getComputedStyle(/** @type {Element} */ (document.querySelector(one))),
      );
      return [edge.borderTopColor, letters.color];
    });
  const [usual, letters] = await edges();
  assert.notEqual(usual, letters);
  try {
    await surround(page, [1440, 900], { 'prefers-contrast': 'more' });
    assert.deepEqual(await edges(), [letters, letters]);
  } finally {
    await endSurrounding(page);
  }
});
