// Before anything of the map is computed, its axes and all that stands around it are where they will be.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { delayWorkers, releaseWorkers } from '../harness/workers.js';
import { gridAround } from '../../../www/parts/robustness/grid.js';
import { axesOf } from '../../../www/parts/robustness/view.js';

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
    // Coarse drives have the same places, and come sooner.
    for (const link of ['lab&v=1&sampleTime=0.05', 'lab&v=1&sampleTime=0.05&lang=ko']) {
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
