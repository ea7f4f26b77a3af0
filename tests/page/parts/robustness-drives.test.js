import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { middleOf } from '../harness/reading.js';
import { cellOf, ep, headings, openMap, pointOf, worst } from './robustness-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** How many pixels of the marks are as red as a drive that misses, and how many are white. @param {Page} page */
const marksOf = (page) =>
  page.evaluate(() => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('robustness-marks'));
    const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(
      ...[0, 0, canvas.width, canvas.height],
    );
    let [red, white] = [0, 0];
    for (let i = 0; i < data.length; i += 4) {
      if (data[i] > 150 && data[i + 1] < 80 && data[i + 2] < 80 && data[i + 3] > 200) red += 1;
      if (data[i] > 240 && data[i + 1] > 240 && data[i + 2] > 240 && data[i + 3] > 200) white += 1;
    }
    return { red, white };
  });

/** Waits until the marks are as wanted. @param {Page} page @param {string} what @param {(marks: { red: number, white: number }) => boolean} isSo */
async function marksUntil(page, what, isSo) {
  let marks = await marksOf(page);
  for (let i = 0; i < 100 && !isSo(marks); i += 1) {
    await page.evaluate(() => new Promise((resolve) => requestAnimationFrame(resolve)));
    marks = await marksOf(page);
  }
  assert.ok(isSo(marks), `${what}: ${JSON.stringify(marks)}`);
}

/** @param {Page} page @param {{ x: number, y: number }} point @param {string} type @param {string} pointerType @param {string} [id] */
const pointAt = (page, point, type, pointerType, id = 'robustness-map') =>
  page.evaluate(
    (name, { x, y }, kind, pointer) => {
      const element = /** @type {HTMLElement} */ (document.getElementById(name));
      const { left, top } = element.getBoundingClientRect();
      element.dispatchEvent(
        new PointerEvent(kind, {
          ...{ clientX: left + x, clientY: top + y, pointerType: pointer, pointerId: 1 },
          bubbles: kind !== 'pointerleave',
        }),
      );
    },
    ...[id, point, type, pointerType],
  );

pageTest(
  'where one points, the map shows the drives in all headings, and those that miss apart',
  async (page) => {
    await openMap(page);
    const rest = await marksOf(page);
    assert.equal(rest.red, 0);
    for (const [start, move, end] of [
      ['pointermove', 'mouse', 'pointerleave'],
      ['pointerdown', 'touch', 'pointerleave'],
    ]) {
      // None arrives from (4.00, 1.00), all from (−1.00, 1.00).
      await pointAt(page, await pointOf(page, 60, 30), start, move);
      await marksUntil(page, `${move}: those that miss`, ({ red }) => red > 200);
      await pointAt(page, await pointOf(page, 10, 10), 'pointermove', move);
      await marksUntil(
        page,
        `${move}: all arrive`,
        ({ red, white }) => red === 0 && white > rest.white + 400,
      );
      await pointAt(page, { x: 0, y: 0 }, end, move);
      await marksUntil(
        page,
        `${move}: nothing is pointed at`,
        ({ red, white }) => red === 0 && white === rest.white,
      );
    }
    await page.focus('#robustness-map');
    await page.press(Key.ARROW_RIGHT);
    await marksUntil(page, 'the cursor of the keyboard', ({ white }) => white > rest.white + 100);
    await page.press(Key.ESCAPE);
    await marksUntil(page, 'Escape', ({ white }) => white === rest.white);
  },
);

pageTest(
  'what would be driven from a place is lit on the dial, and what is pointed at there on the map',
  async (page) => {
    await openMap(page);
    assert.ok(ep().arrivals(cellOf(60, 30)) === 0);
    await pointAt(page, await pointOf(page, 60, 30), 'pointermove', 'mouse');
    const lit = () =>
      page.evaluate(() =>
        [...document.querySelectorAll('#robustness-rose path')].findIndex((one) => one.matches('.lit')),
      );
    await page.until('a heading is lit', () => document.querySelector('#robustness-rose .lit'));
    assert.equal(await lit(), worst(ep(), cellOf(60, 30)));
    await pointAt(page, { x: 0, y: 0 }, 'pointerleave', 'mouse');
    await page.until('none is lit', () => !document.querySelector('#robustness-rose .lit'));

    const rest = await marksOf(page);
    const { x, y } = await middleOf(page, 'robustness-rose', 'robustness-rose');
    await pointAt(page, { x: x - 30, y }, 'pointermove', 'mouse', 'robustness-rose');
    await page.until('it is lit', () => document.querySelector('#robustness-rose .lit'));
    assert.equal(await lit(), headings / 2);
    await marksUntil(
      page,
      'the drives of the place that is watched',
      ({ white }) => white > rest.white + 100,
    );
  },
);

pageTest('on a laptop the map of starts is as large as the plane', async (page) => {
  await page.open('#robustness');
  for (const [width, height] of [
    [1366, 768],
    [1440, 900],
    [1920, 1080],
  ]) {
    await page.resize(width, height);
    const [map, plane] = await page.evaluate(async () => {
      await pageFrames.settled();
      return ['robustness-map', 'plane'].map((id) => {
        const { width: wide, height: high } = /** @type {HTMLElement} */ (
          document.getElementById(id)
        ).getBoundingClientRect();
        return [wide, high];
      });
    });
    const side = Math.min(map[0] - 60, map[1] - 52);
    assert.ok(side ** 2 >= plane[0] * plane[1], `${side} px beside ${plane} at ${width} × ${height}`);
  }
});
