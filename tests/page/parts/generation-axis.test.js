// The axes of the picture of a generation, without a browser.
import assert from 'node:assert/strict';
import { parseHTML } from 'linkedom';
import { drawCostAxis } from '../../../www/parts/generation/cost-axis.js';
import { dissect } from '../../../www/parts/generation/record.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { test } from '../harness/once.js';
import { recordOf, velocityLimits } from './generation-page.js';

/** @typedef {import('../../../www/parts/generation/record.js').Phase} Phase */

const sizes = [180, 245, 320].map((height) => ({ width: 2.2 * height, height }));

/** @param {number} generation @param {Phase} phase @param {typeof sizes[number]} size @param {typeof velocityLimits} [from] */
function axisOf(generation, phase, size, from = velocityLimits) {
  const { document } = globalThis;
  globalThis.document = parseHTML('<svg></svg>').document;
  try {
    const layer = globalThis.document.documentElement;
    const anatomy = dissect(recordOf(generation, from), from.evolution);
    drawCostAxis(layer, { anatomy, phase, chosen: 0, still: true }, size);
    const all = (/** @type {string} */ selector) => [...layer.querySelectorAll(selector)];
    return { all, texts: all('text').map(({ textContent }) => textContent ?? '') };
  } finally {
    globalThis.document = document;
  }
}

test('below those that stay stand their ranks', () => {
  for (const [method, generation] of /** @type {const} */ ([
    ['de', 9],
    ['de', 0],
    ['random', 9],
  ])) {
    const from = { ...velocityLimits, evolution: { ...velocityLimits.evolution, method } };
    const { texts } = axisOf(generation, 'survivors', sizes[0], from);
    assert.ok(texts.includes('rank'), `${method}, generation ${generation}: ${texts}`);
    assert.equal(ko.survivorAxis(method), '순위');
  }
});

test('each line of J lies within half a pixel of its number', () => {
  for (const size of sizes) {
    const { all } = axisOf(1, 'drive', size);
    const attributesOf = (/** @type {string} */ selector, /** @type {string} */ name) =>
      all(selector).map((one) => Number(one.getAttribute(name)));
    const lines = attributesOf('line:not([class])', 'y1');
    // Letters stand on a line 4 pixels below their middle.
    const numbers = attributesOf('text.end', 'y').map((y) => y - 4);
    const nearest = lines.map((line) => Math.min(...numbers.map((number) => Math.abs(number - line))));
    assert.ok(nearest.length > 1 && Math.max(...nearest) <= 0.5, nearest.join(', '));
  }
});

test('what stands at the limit of the axis is no number of a line below it', () => {
  const { starts, goal } = velocityLimits;
  const far = {
    ...velocityLimits,
    starts: [{ ...starts[0], x: -1000, y: -1000, theta: 0 }],
    goal: { ...goal, x: 1000, y: 1000 },
  };
  for (const size of sizes)
    for (const [generation, from] of /** @type {const} */ ([
      [1, velocityLimits],
      [2, velocityLimits],
      [5, velocityLimits],
      [3, far],
    ])) {
      const texts = [...new Set(axisOf(generation, 'ranking', size, from).texts)];
      const limit = texts.find((text) => text.endsWith('↑'))?.replace(' ↑', '') ?? '';
      assert.ok(limit !== '' && !texts.includes(limit), texts.join(', '));
      // As long as the others, in thousands and millions where they are.
      const ends = texts.filter((text) => /^\d.*\d[kMG]?$/.test(text) && text !== '0');
      const longest = Math.max(...ends.map((text) => text.length));
      assert.ok(limit.length <= longest + 2, texts.join(', '));
      if (from === far) assert.match(limit, /[kMG]$/, texts.join(', '));
    }
});
