// Before anything of the map is computed, its axes and all that stands around it are where they will be.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { delayWorkers, releaseWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';
import { gridAround } from '../../../www/parts/robustness/grid.js';
import { axesOf } from '../../../www/parts/robustness/view.js';
import * as en from '../../../www/parts/robustness/words/en.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

test('the map of every survey, and the empty one, has the same axes', () => {
  const [width, height] = [560, 560];
  for (const goal of [
    { x: 2, y: 2 },
    { x: -1.5, y: 0.25 },
  ])
    for (const half of [2, 4, 8]) {
      const ends = [2, 25, 81].map((count) => {
        const { x, y, frame, cell } = axesOf({
          grid: gridAround(goal, half, count),
          size: { width, height },
        });
        const apart = x(goal.x + (2 * half) / (count - 1)) - x(goal.x);
        assert.ok(Math.abs(cell - apart) < 1e-9, `${count} on an edge: cells of ${cell}, ${apart} apart`);
        return [frame.left, frame.right].map(x.invert).concat([frame.bottom, frame.top].map(y.invert));
      });
      for (const one of ends) assert.deepEqual(one, ends[0]);
      const [left, right] = ends[0];
      assert.ok(left <= goal.x - half && left > goal.x - 1.02 * half, `${left} at ${half} m`);
      assert.ok(right >= goal.x + half && right < goal.x + 1.02 * half, `${right} at ${half} m`);
    }
});

/** Where all that is seen of the part and of what is beside it begins. @param {Page} page @returns {Promise<[string, number][]>} */
const places = (page) =>
  page.evaluate(() =>
    [
      ...['#plane', '.driver', '.robustness > .heading', '#robustness-share', '#robustness-summary'],
      ...['.survey-bar', '#robustness-map', '.survey-side', '#robustness-rose', '#robustness-readout'],
    ].map((selector) => {
      const box = document.querySelector(selector)?.getBoundingClientRect();
      return [selector, Math.round(scrollY + (box?.top ?? 0))];
    }),
  );

pageTest('what comes of the map moves nothing of what stands there already', async (page) => {
  for (const [width, height] of /** @type {const} */ ([
    [1440, 900],
    [1024, 768],
    [390, 844],
  ])) {
    await page.resize(width, height);
    // Shorter drives have the same places, and come sooner.
    for (const link of ['lab&v=1&horizon=4', 'lab&v=1&horizon=4&lang=ko']) {
      await page.open(`#${link}`);
      await delayWorkers(page);
      await page.click('#page-robustness');
      await page.until('it is being computed', () =>
        document.getElementById('robustness-rival')?.textContent?.includes('…'),
      );
      const before = await places(page);
      await releaseWorkers(page);
      await page.until('all numbers are there', () =>
        ['share', 'rival'].every((name) => {
          const text = document.getElementById(`robustness-${name}`)?.textContent ?? '';
          return /\d/.test(text) && !text.includes('…');
        }),
      );
      assert.deepEqual(await places(page), before, `${link} at ${width} × ${height}`);
    }
  }
});

pageTest('that the reference moves is said no more once it does not', async (page) => {
  const still = 'robustness&v=1&horizon=4';
  const noted = (/** @type {string} */ what) =>
    page.until(what, (one) => document.getElementById('robustness-note')?.textContent?.includes(one), what);
  await page.open(`#${still}&referenceVelocity.linear=0.3`);
  await noted(' starts');
  assert.equal(await page.text('#robustness-summary'), en.tracking);
  await delayWorkers(page);
  await follow(page, still);
  await noted(en.computing);
  const waiting = await page.text('#robustness-summary');
  assert.notEqual(waiting, en.tracking);
  assert.equal(await page.text('#robustness-share'), en.waits);
  await releaseWorkers(page);
  await noted(' starts');
  assert.equal(await page.text('#robustness-summary'), waiting);
});

/** Where the numbers of both axes are drawn when the map is drawn anew. @param {Page} page @returns {Promise<{ across: number[], up: number[] }>} */
const numbersDrawn = (page) =>
  page.until('the axes are drawn', () => {
    /** @type {[string, number, number][]} */
    const drawn = Reflect.get(globalThis, 'drawn');
    // A number below has its top at its place.
    const placesIn = (/** @type {string} */ baseline, /** @type {1 | 2} */ axis) => {
      const places = drawn
        .filter(([own]) => own === baseline)
        .map((one) => Math.round(100 * one[axis]) / 100);
      // It may be drawn twice.
      return [...new Set(places)].sort((a, b) => a - b);
    };
    const found = { across: placesIn('top', 1), up: placesIn('middle', 2) };
    return found.across.length > 1 && found.up.length > 1 && found;
  });

pageTest('each number of an axis stands at its place, the last as well', async (page) => {
  await page.resize(1440, 900);
  await page.open('#lab&v=1&horizon=4&goal.x=2&goal.y=2');
  await page.evaluate(() => {
    /** @type {[string, number, number][]} */
    const drawn = [];
    Object.assign(globalThis, { drawn });
    const { prototype } = CanvasRenderingContext2D;
    const { fillText } = prototype;
    prototype.fillText = function (text, x, y) {
      if (this.canvas.closest('#robustness-map') && /^−?[\d.]+$/.test(text))
        drawn.push([this.textBaseline, x, y]);
      fillText.call(this, text, x, y);
    };
  });
  for (const half of ['4', '2']) {
    await page.evaluate((own) => {
      Reflect.set(Reflect.get(globalThis, 'drawn'), 'length', 0);
      location.hash = `#robustness&v=1&horizon=4&half=${own}`;
    }, half);
    const { across, up } = await numbersDrawn(page);
    for (const places of [across, up]) {
      const apart = places.slice(1).map((place, i) => place - places[i]);
      for (const one of apart) assert.ok(Math.abs(one - apart[0]) < 0.1, `±${half} m: ${places}`);
    }
  }
});

test('the name of the upright axis has its own room, however long the numbers beside it are', () => {
  const leftOf = (/** @type {number} */ middle, /** @type {number} */ half) => {
    const range = { from: middle - half, to: middle + half, count: 81 };
    const size = { width: 600, height: 600 };
    return axesOf({ grid: { x: range, y: range, headings: 18 }, size }).frame.left;
  };
  assert.equal(leftOf(2, 4), 52);
  // The numbers end 8 pixels beside the frame, the name 18 beside the edge.
  for (const [middle, half, text] of /** @type {const} */ ([
    [-150, 4, '−150'],
    [996, 4, '1000'],
    [900.5, 2, '900.5'],
    [0, 2, '−0.5'],
  ]))
    assert.ok(leftOf(middle, half) - 8 - 8 * text.length >= 18, text);
});
