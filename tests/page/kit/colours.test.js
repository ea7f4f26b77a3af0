import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import { askedAlpha } from '../../../www/parts/curves/plots.js';
import { test } from '../harness/once.js';

const sheet = readFileSync(new URL('../../../www/kit/style.css', import.meta.url), 'utf8');
const [lit, dark] = sheet.split('@media screen and (prefers-color-scheme: dark)');

/** Red, green and blue as light, of each token. @param {string} css @returns {Map<string, number[]>} */
const coloursOf = (css) =>
  new Map(
    [...css.matchAll(/--([\w-]+): #([\da-f]{6});/g)].map(([, name, hex]) => [
      name,
      [0, 2, 4].map((from) => {
        const part = Number.parseInt(hex.slice(from, from + 2), 16) / 255;
        return part <= 0.04045 ? part / 12.92 : ((part + 0.055) / 1.055) ** 2.4;
      }),
    ]),
  );

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

test('what the law asked for is seen on paper, though its line is thin', () => {
  /** As the screen mixes them, which is not by their light. @param {number} part */
  const codeOf = (part) => (part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055);
  const lightOf = (/** @type {number} */ code) =>
    code <= 0.04045 ? code / 12.92 : ((code + 0.055) / 1.055) ** 2.4;
  for (const css of [lit, dark.split('@media')[0]]) {
    const colours = coloursOf(css);
    const paper = /** @type {number[]} */ (colours.get('paper'));
    for (const name of ['energy', 'omega']) {
      const line = /** @type {number[]} */ (colours.get(name)).map((part, i) =>
        lightOf(askedAlpha * codeOf(part) + (1 - askedAlpha) * codeOf(paper[i])),
      );
      assert.ok(contrast(line, paper) >= 3, `${name}: ${contrast(line, paper)}`);
    }
  }
});
