import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { pale } from '../../../www/kit/palette.js';
import { askedAlpha } from '../../../www/parts/curves/plots.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';

const read = (/** @type {string} */ path) =>
  readFileSync(new URL(`../../../www/${path}`, import.meta.url), 'utf8');
const sheet = read('kit/style.css');
const [lit, dark] = sheet.split('@media screen and (prefers-color-scheme: dark)');

/** Red, green and blue. @param {string} hex */
const partsOf = (hex) => [1, 3, 5].map((from) => Number.parseInt(hex.slice(from, from + 2), 16) / 255);

/** As light. @param {number[]} parts */
const lightOf = (parts) =>
  parts.map((part) => (part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4));

/** Each token. @param {string} css @returns {Map<string, string>} */
const tokensOf = (css) =>
  new Map([...css.matchAll(/--([\w-]+): (#[\da-f]{6});/g)].map(([, name, hex]) => [name, hex]));

/** Red, green and blue as light, of each token. @param {string} css @returns {Map<string, number[]>} */
const coloursOf = (css) => new Map([...tokensOf(css)].map(([name, hex]) => [name, lightOf(partsOf(hex))]));

/** How different they look: the distance in Oklab, by Björn Ottosson. @param {number[]} a @param {number[]} b */
function distance(a, b) {
  const [one, other] = [a, b].map(([red, green, blue]) => {
    const [l, m, s] = [
      0.4122214708 * red + 0.5363325363 * green + 0.0514459929 * blue,
      0.2119034982 * red + 0.6806995451 * green + 0.1073969566 * blue,
      0.0883024619 * red + 0.2817188376 * green + 0.6299787005 * blue,
    ].map(Math.cbrt);
    return [
      0.2104542553 * l + 0.793617785 * m - 0.0040720468 * s,
      1.9779984951 * l - 2.428592205 * m + 0.4505937099 * s,
      0.0259040371 * l + 0.7827717662 * m - 0.808675766 * s,
    ];
  });
  return Math.hypot(...one.map((value, i) => value - other[i]));
}

/** @param {number[]} a @param {number[]} b */
function contrast(a, b) {
  const [low, high] = [a, b]
    .map(([red, green, blue]) => 0.2126 * red + 0.7152 * green + 0.0722 * blue)
    .sort((one, other) => one - other);
  return (high + 0.05) / (low + 0.05);
}

test('pinned drives are read on every ground, and the first looks like no other colour', () => {
  for (const css of [lit, dark.split('@media')[0]]) {
    const colours = coloursOf(css);
    const of = (/** @type {string} */ name) => /** @type {number[]} */ (colours.get(name));
    for (const pin of ['pin-1', 'pin-2', 'pin-3', 'pin-4'])
      for (const ground of ['paper', 'panel']) assert.ok(contrast(of(pin), of(ground)) >= 4.9, pin);
    for (const other of [
      ...['ink', 'muted', 'x', 'y', 'theta', 'energy', 'omega', 'path', 'final', 'error'],
      ...['pin-2', 'pin-3', 'pin-4'],
    ])
      assert.ok(
        distance(of('pin-1'), of(other)) > 0.12,
        `pin-1 ${distance(of('pin-1'), of(other))} from ${other}`,
      );
  }
});

test('what is not reached on a map is no bright area in the dark, and what stands on it is read', () => {
  for (const [css, isDark] of /** @type {const} */ ([
    [lit, false],
    [dark.split('@media')[0], true],
  ])) {
    const colours = coloursOf(css);
    const of = (/** @type {string} */ name) => /** @type {number[]} */ (colours.get(name));
    assert.ok(contrast(of('unreached'), of('on-unreached')) >= 4.9);
    if (isDark) assert.ok(contrast(of('unreached'), of('ink')) > 4.5, 'in the dark it is no bright area');
  }
});

/** How much a colour stands out from its ground when so much of it is drawn. @param {string} ground @param {string} hex @param {number} alpha */
function contrastOn(ground, hex, alpha) {
  const [under, over] = [ground, hex].map(partsOf);
  const mixed = under.map((part, i) => part * (1 - alpha) + over[i] * alpha);
  return contrast(lightOf(mixed), lightOf(under));
}

test('what the law asked for is seen on paper, though its line is thin', () => {
  for (const css of [lit, dark.split('@media')[0]]) {
    const of = (/** @type {string} */ name) => /** @type {string} */ (tokensOf(css).get(name));
    for (const name of ['energy', 'omega']) {
      const seen = contrastOn(of('paper'), of(name), askedAlpha);
      assert.ok(seen >= 3, `${name}: ${seen}`);
    }
  }
});

test('what stands back is seen in both themes, also on a weak projector, and stands back', () => {
  const marks = read('parts/generation/style.css');
  const faint = Number(/\.mark:is\(\.fallen, \.falls, \.faint\) {\s+opacity: ([\d.]+);/.exec(marks)?.[1]);
  const swatch = Number(/\.thin::before {\s+opacity: ([\d.]+);/.exec(read('lab/plane.css'))?.[1]);
  assert.equal(swatch, pale, 'the legend shows the line that is on the plane');
  for (const css of [lit, dark.split('@media')[0]]) {
    const of = (/** @type {string} */ name) => /** @type {string} */ (tokensOf(css).get(name));
    for (const [name, alpha] of /** @type {const} */ ([
      ['muted', pale],
      ['ink', faint],
    ])) {
      const seen = contrastOn(of('paper'), of(name), alpha);
      assert.ok(seen > 2 && seen < contrastOn(of('paper'), of(name), 1) / 2, `${name}: ${seen}`);
    }
  }
});

/** Pictures with what stands back in them, each with its canvas. */
const paleLines = {
  'lab&v=1&generation=12': '#plane-paths',
  'disturbance&v=1&generation=12&under=slip,0.1,0,1': '.remains canvas',
  'training&v=1&generation=12': '#training-unseen',
  'lesson&step=cost': '.small-drive canvas',
  'lesson&step=duel': '.swarm-picture canvas',
};

/** @typedef {{ canvas: HTMLCanvasElement, colour: string, alpha: number, width: number }} Stroke */
/** In the page: what is drawn from now on. */
function recordStrokes() {
  const { prototype } = CanvasRenderingContext2D;
  const { stroke } = prototype;
  /** @type {Stroke[]} */
  const strokes = [];
  prototype.stroke = function (/** @type {any[]} */ ...path) {
    const { a, b } = this.getTransform();
    const width = (this.lineWidth * Math.hypot(a, b)) / devicePixelRatio;
    const { canvas, strokeStyle, globalAlpha } = this;
    strokes.push({ canvas, colour: String(strokeStyle), alpha: globalAlpha, width });
    stroke.apply(this, /** @type {any} */ (path));
  };
  Object.assign(window, { strokes });
}

pageTest('no line of a drive is so pale that a weak projector loses it', async (page) => {
  const ground = /** @type {string} */ (tokensOf(lit).get('paper'));
  await page.open('#luck');
  await page.evaluate(recordStrokes);
  for (const [link, selector] of Object.entries(paleLines)) {
    await follow(page, link);
    const strokes = /** @type {Stroke[]} */ (
      await page.until(
        `something pale on ${link}`,
        (wanted) => {
          const { strokes: all } = /** @type {{ strokes: Stroke[] }} */ (/** @type {unknown} */ (window));
          const here = all.filter(({ canvas }) => canvas.matches(wanted));
          return here.some(({ alpha }) => alpha < 0.9) && here.map(({ canvas, ...look }) => look);
        },
        selector,
      )
    );
    // Lines of the axes are as pale as they should be.
    for (const { colour, alpha, width } of strokes.filter((one) => contrastOn(ground, one.colour, 1) > 4.5)) {
      const seen = contrastOn(ground, colour, alpha * Math.min(1, width));
      // What is small as well as thin needs more.
      assert.ok(seen > (width < 0.99 ? 3 : 2), `${link}: ${colour} at ${alpha}, ${width} px: ${seen}`);
    }
  }
});
