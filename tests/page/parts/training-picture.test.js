import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

pageTest(
  'a thousand starts have room, and those that miss differ by colour from those that arrive',
  async (page) => {
    await page.open('#training');
    await page.until('the paper’s gains have driven', () =>
      document.getElementById('training-unseen-title')?.textContent?.startsWith('Never seen: 250'),
    );
    for (const [width, height, side] of [
      [1366, 768, 320],
      [1280, 720, 300],
      [390, 844, 340],
    ]) {
      await page.resize(width, height);
      const seen = await page.evaluate(async () => {
        for (let frame = 0; frame < 3; frame++)
          await new Promise((resolve) => requestAnimationFrame(resolve));
        const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('training-unseen'));
        const { data } = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d')).getImageData(
          ...[0, 0, canvas.width, canvas.height],
        );
        let [red, grey] = [0, 0];
        for (let i = 0; i < data.length; i += 4)
          if (data[i + 3] > 120) {
            if (data[i] > data[i + 1] + 60 && data[i] > data[i + 2] + 60) red += 1;
            else if (Math.abs(data[i] - data[i + 1]) < 20) grey += 1;
          }
        return { side: Math.min(canvas.clientWidth, canvas.clientHeight), red, grey };
      });
      assert.ok(seen.side >= side, `${seen.side} px at ${width} × ${height}`);
      // 750 miss, 250 arrive.
      assert.ok(seen.red > 750 && seen.grey > 250, JSON.stringify(seen));
    }
  },
);
