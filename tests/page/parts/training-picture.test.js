import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { experiment, paperGains, simulate, startsOnCircle } from '../harness/core.js';
import { read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page */
async function openTraining(page) {
  await page.open('#training&v=1&population=4&evolve=50');
  await page.until('the paper’s gains have driven', () =>
    document.getElementById('training-unseen-title')?.textContent?.startsWith('Never seen: 250'),
  );
}

pageTest(
  'a start that is pressed is driven from, and a press beside all of them changes nothing',
  async (page) => {
    await openTraining(page);
    const head = await page.evaluate(() => document.querySelector('#training-table th')?.textContent);
    assert.match(head ?? '', /kx\s*ky\s*kθ$/, 'whose the three numbers of a row are');
    // The goal is in the middle; the outermost circle of those never seen begins at its right.
    const { x, y } = experiment('velocity-limits').goal;
    const radius = (4 * 17.5) / 18;
    const [start] = startsOnCircle({ x, y, radius, count: 108, seed: 1017 });
    const press = async (/** @type {number} */ right, /** @type {number} */ up) => {
      const { width, height } = await page.evaluate(() => {
        const { clientWidth, clientHeight } = /** @type {Element} */ (
          document.getElementById('training-unseen')
        );
        return { width: clientWidth, height: clientHeight };
      });
      const metre = Math.min(width, height) / 8.6;
      await page.drag('#training-unseen', [{ x: width / 2 + right * metre, y: height / 2 - up * metre }]);
      return read(page);
    };
    const usual = experiment('velocity-limits');
    const run = simulate({ ...usual, starts: [start] }, paperGains('velocity-limits', 'ep'));
    const way = Array.from(run.x, (along, i) => [along - x, run.y[i] - y]).filter(
      // On the goal its sign lies over it.
      (from, i) => i % 5 === 0 && Math.hypot(...from) > 0.6,
    );
    /** Which share of its way is drawn in ink. */
    const drawn = () =>
      page.evaluate((points) => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('training-unseen'));
        const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
        const metre = Math.min(canvas.width, canvas.height) / 8.6;
        const isInk = (/** @type {number[]} */ [right, up]) => {
          const at = [canvas.width / 2 + right * metre, canvas.height / 2 - up * metre];
          const [red, green, blue, alpha] = context.getImageData(at[0], at[1], 1, 1).data;
          return alpha > 200 && Math.max(red, green, blue) < 100;
        };
        return points.filter(isInk).length / points.length;
      }, way);
    const before = await drawn();
    const pressed = await press(radius, 0);
    const after = await drawn();
    assert.ok(before < 0.6 && after > 0.9, `${before} of its way, then ${after}`);
    assert.deepEqual(pressed.start, {
      x: Number(start.x.toFixed(2)),
      y: Number(start.y.toFixed(2)),
      degrees: Math.round((start.theta * 180) / Math.PI),
    });
    // In a corner, far outside of the circles.
    assert.deepEqual(await press(3.9, 3.9), pressed);
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest(
  'a thousand starts have room, and those that miss are pale, and red, beside those that arrive',
  async (page) => {
    await openTraining(page);
    for (const [width, height, side] of [
      [1366, 768, 320],
      [1280, 720, 300],
      [390, 844, 340],
    ]) {
      await page.resize(width, height);
      const seen = await page.evaluate(() => {
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('training-unseen'));
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(
          ...[0, 0, canvas.width, canvas.height],
        );
        let [red, grey, strongest, inked] = [0, 0, 0, 0];
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3] > 60) {
            if (data[i] > data[i + 1] + 60 && data[i] > data[i + 2] + 60) {
              red += 1;
              strongest = Math.max(strongest, data[i + 3]);
            } else if (data[i + 3] > 215 && Math.abs(data[i] - data[i + 1]) < 20) {
              grey += 1;
              inked = Math.max(inked, data[i + 3]);
            }
          }
        return { side: Math.min(canvas.clientWidth, canvas.clientHeight), red, grey, strongest, inked };
      });
      assert.ok(seen.side >= side, `${seen.side} px at ${width} × ${height}`);
      // 750 miss, 250 arrive.
      assert.ok(seen.red > 750 && seen.grey > 250, JSON.stringify(seen));
      // Without colour they differ, too; where two cross they are stronger.
      assert.ok(seen.strongest < 215 && seen.inked > 240, JSON.stringify(seen));
    }
  },
);

pageTest('one start alone has less room than many, until others are there to compare', async (page) => {
  await openTraining(page);
  const heights = () =>
    page.evaluate(() =>
      ['seen', 'unseen'].map(
        (name) => /** @type {HTMLElement} */ (document.getElementById(`training-${name}`)).clientHeight,
      ),
    );
  for (const [width, height] of [
    [1440, 900],
    [390, 844],
  ]) {
    await page.resize(width, height);
    const [one, beside] = await heights();
    await page.click('#training-circle .training-name');
    const [many, unseen] = await heights();
    assert.ok(one < 0.8 * many && beside >= unseen, `${one}, ${beside} and ${many}, ${unseen}`);
    await page.click('#training-paper-ep .training-name');
  }
  await page.click('#training-evolve');
  await page.until(
    'all have evolved',
    () => document.getElementById('training-evolve')?.textContent === 'Evolve again',
  );
  await page.click('#training-circle .training-name');
  const many = await heights();
  await page.click('#training-one .training-name');
  assert.match(await page.text('#training-seen-title'), /^Trained on: \d of 1$/);
  assert.deepEqual(await heights(), many);
});
