// Means of those that arrive: whose they are is said, and marked where few do.
import assert from 'node:assert/strict';
import { tally } from '../../../www/parts/robustness/grid.js';
import { createShading } from '../../../www/parts/robustness/scale.js';
import * as en from '../../../www/parts/robustness/words/en.js';
import * as ko from '../../../www/parts/robustness/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { cellOf, count, ep, finished, headings, pointOf } from './robustness-page.js';

test('a mean is marked where fewer than half arrive, and nothing else is', () => {
  const runs = ep();
  const survey = /** @type {any} */ ({ runs, tally: tally(runs) });
  const few = Array.from({ length: count ** 2 }, (_, cell) => cell).filter((cell) => {
    const arrivals = runs.arrivals(cell);
    return arrivals > 0 && arrivals < headings / 2;
  });
  assert.ok(few.length > 300);
  for (const quantity of /** @type {const} */ (['time', 'cost'])) {
    assert.deepEqual(createShading(survey, quantity, null).few, few);
    assert.deepEqual(createShading(survey, quantity, 3).few, []);
  }
  for (const heading of [null, 3]) assert.deepEqual(createShading(survey, 'share', heading).few, []);
});

test('whose mean it is, is said in the legend and of each place where some fail', () => {
  for (const quantity of /** @type {const} */ (['time', 'cost'])) {
    assert.match(en.legendTitle(quantity, true), /of those that arrive$/);
    assert.match(ko.legendTitle(quantity, true), /^도착한 주행의 평균/);
    for (const words of [en, ko]) assert.doesNotMatch(words.legendTitle(quantity, false), /those|도착/);
  }
  const told = (/** @type {number} */ arrived) =>
    [en, ko].map((words) =>
      words
        .cellText({ x: 0, y: 0 }, { arrived, headings: 18, time: 0.87, cost: 3.2 })
        .replace(/^[^:]*: /, ''),
    );
  assert.deepEqual(told(0), ['none of 18 headings arrives.', '방향각 18개 모두 미도착.']);
  assert.deepEqual(told(1), [
    '1 of 18 headings arrives, in 0.87 s, J\u00a03.20.',
    '방향각 18개 중 1개 도착, 0.87초, J\u00a03.20.',
  ]);
  assert.deepEqual(told(5), [
    '5 of 18 headings arrive, these in 0.87 s on average, J\u00a03.20.',
    '방향각 18개 중 5개 도착, 도착한 주행의 평균 0.87초, J\u00a03.20.',
  ]);
  assert.deepEqual(told(18), [
    'all 18 headings arrive, in 0.87 s on average, J\u00a03.20.',
    '방향각 18개 모두 도착, 평균 0.87초, J\u00a03.20.',
  ]);
});

pageTest(
  'places from which few arrive are hatched over their shade, and the legend says so',
  async (page) => {
    await page.open('#robustness&v=1&drives=paper-ep&horizon=4&colour=time');
    await finished(page, 'paper’s EP gains');
    // A block of 3 × 3 places is wider than a stripe is apart from the next.
    const blockOf = (/** @type {(arrivals: number) => boolean} */ isSo) => {
      for (let row = 1; row < count - 1; row += 1)
        for (let column = 1; column < count - 1; column += 1) {
          const offsets = [-1, 0, 1];
          const cells = offsets.flatMap((up) => offsets.map((right) => cellOf(column + right, row + up)));
          const isFree = Math.hypot(column - 40, row - 40) > 12 && Math.hypot(column - 20, row - 20) > 16;
          if (isFree && cells.every((cell) => isSo(ep().arrivals(cell)))) return pointOf(page, column, row);
        }
      throw new Error('no such block');
    };
    const points = [
      await blockOf((arrivals) => arrivals > 0 && arrivals < headings / 2),
      await blockOf((arrivals) => arrivals === headings),
    ];
    const spread = () =>
      page.evaluate((places) => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('robustness-picture'));
        const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        const pixels = canvas.width / canvas.clientWidth;
        return places.map(({ x, y }) => {
          const side = Math.round(8 * pixels);
          const { data } = context.getImageData(
            Math.round(x * pixels) - side / 2,
            Math.round(y * pixels) - side / 2,
            side,
            side,
          );
          const reds = [...data].filter((_, i) => i % 4 === 0);
          return Math.max(...reds) - Math.min(...reds);
        });
      }, points);
    const legend = () =>
      page.evaluate(() => document.querySelector('#robustness-few')?.parentElement?.checkVisibility());
    const [few, all] = await spread();
    assert.ok(few > 60 && all < 30, `${few}, ${all}`);
    assert.equal(await legend(), true);
    // In grey a shade can be that of the places from which none arrives.
    const rises = await page.evaluate(() =>
      ['never', 'few'].map((name) => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById(`robustness-${name}`));
        const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        const { data } = context.getImageData(0, 0, canvas.width, canvas.height);
        /** How far a pixel is from the next one on a line that goes up, or down. */
        const apart = (/** @type {number} */ next) =>
          data.reduce((sum, value, i) => sum + Math.abs(value - (data[i + 4 * next] ?? value)), 0);
        return apart(1 - canvas.width) < apart(1 + canvas.width);
      }),
    );
    assert.deepEqual(rises, [true, false]);
    await page.click('#robustness-quantity-share');
    await page.until(
      'the legend is another',
      () => !document.querySelector('#robustness-few')?.checkVisibility(),
    );
    assert.deepEqual(await page.problems(), []);
  },
);
