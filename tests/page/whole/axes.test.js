// The numbers of every axis are read as they are, also where they are long.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { keepCut, takeCut } from './cut.js';
import { follow } from './surround.js';

const far = 'start=-1000,-1000,0&goal.x=1000&goal.y=1000';
const shaken = 'disturbance.kind=random&disturbance.linear=100&disturbance.angular=100';

pageTest('no number of an axis loses its sign or its first digit at the edge', async (page) => {
  await page.resize(1440, 900);
  await page.open();
  await page.evaluate(keepCut);
  for (const link of [
    'curves&v=1&goal.x=-2&goal.y=-2&goal.theta=-170deg',
    `curves&v=1&${far}`,
    'curves&v=1&weights.velocity=1000000,1000000',
    `curves&v=1&view=stability&${shaken}`,
    'curves&v=1&view=stability&drives=hand&gains=0.000001,0.000001,0.000001',
    `lab&v=1&${far}`,
  ]) {
    await follow(page, link);
    await page.evaluate(() => pageFrames.settled());
    assert.deepEqual(await page.evaluate(takeCut), [], link);
  }
});

pageTest('no two lines of the map of starts have the same number', async (page) => {
  await page.resize(1440, 900);
  await page.open();
  await page.evaluate(() => {
    const { fillText } = CanvasRenderingContext2D.prototype;
    /** @type {Map<number, Set<string>>} */
    const below = new Map();
    Object.assign(window, { below });
    CanvasRenderingContext2D.prototype.fillText = function (text, x, y) {
      if (this.canvas.closest('.robustness')) below.set(x, (below.get(x) ?? new Set()).add(text));
      fillText.call(this, text, x, y);
    };
  });
  await follow(page, 'robustness&v=1&half=2&goal.x=2.3&goal.y=2.1');
  const numbers = await page.until('the map has its axes', () => {
    const { below } = /** @type {{ below: Map<number, Set<string>> }} */ (/** @type {unknown} */ (window));
    const all = [...below.values()].flatMap((texts) => (texts.size === 1 ? [...texts] : []));
    return all.length > 3 && all;
  });
  assert.deepEqual([...new Set(numbers)], numbers);
});
