// Lines that lie on the pixels of the screen.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { createLayer, sharpLine } from '../../../www/kit/canvas.js';
import { engineTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';

/** A line on a layer of so many pixels of the screen in one of CSS. @param {number} density @param {number} width @returns {ReturnType<typeof sharpLine>} */
function lineAt(density, width) {
  const before = globalThis.devicePixelRatio;
  const context = { setTransform() {}, clearRect() {}, save() {}, restore() {} };
  const canvas = { getContext: () => context };
  globalThis.devicePixelRatio = density;
  /** @type {ReturnType<typeof sharpLine>[]} */
  const lines = [];
  createLayer(/** @type {HTMLCanvasElement} */ (/** @type {unknown} */ (canvas))).draw(
    { width: 300, height: 200 },
    (own) => lines.push(sharpLine(own, width)),
  );
  globalThis.devicePixelRatio = before;
  return lines[0];
}

const place = fc.double({ min: -50, max: 2000, noNaN: true });

test('a line covers whole pixels of the screen, of any density, and lies within half a pixel of its place', () => {
  fc.assert(
    fc.property(fc.constantFrom(1, 1.1, 1.25, 1.5, 1.75, 2, 2.5, 3), place, (density, at) => {
      const { width, middle } = lineAt(density, 1);
      for (const edge of [middle(at) - width / 2, middle(at) + width / 2])
        assert.ok(Math.abs(edge * density - Math.round(edge * density)) < 1e-6, `${edge} at ${density}`);
      assert.ok(Math.abs(width - 1) <= 0.5 && Math.abs(middle(at) - at) <= 0.5 + 1e-9);
      // What is drawn over it once more is no other.
      assert.equal(lineAt(density, width).width, width);
    }),
  );
});

test('of whole pixels, and where it is written down, a line is as wide as asked and on a whole pixel', () => {
  const written = sharpLine(/** @type {CanvasRenderingContext2D} */ ({}), 1);
  for (const { width, middle } of [lineAt(1, 1), lineAt(2, 1), written])
    assert.deepEqual([width, middle(7), middle(7.4), middle(7.6)], [1, 7.5, 7.5, 7.5]);
  const wide = lineAt(1, 2);
  assert.deepEqual([wide.middle(7.4), wide.middle(7.6)], [7, 8]);
  assert.equal(lineAt(2, 1.5).width, 1.5);
});

engineTest(
  'a picture has the pixels of the screen that it covers, also where its edges lie between two',
  async (page) => {
    // Its browser does not tell them.
    if (page.engine === 'webkit') return;
    await page.resize(1440, 900);
    await page.open('#disturbance&v=1&under=slip,0.1,0.2');
    const canvases = await page.until('all are drawn as they are seen', async () => {
      const seen = [...document.querySelectorAll('canvas')].filter((one) => one.checkVisibility());
      /** @type {[number, number, number][]} */
      const sizes = await Promise.all(
        seen.map(
          (canvas) =>
            new Promise((resolve) => {
              new ResizeObserver(([{ devicePixelContentBoxSize }], observer) => {
                const [{ inlineSize, blockSize }] = devicePixelContentBoxSize;
                observer.disconnect();
                resolve([
                  canvas.width - inlineSize,
                  canvas.height - blockSize,
                  canvas.getBoundingClientRect().width,
                ]);
              }).observe(canvas, { box: 'device-pixel-content-box' });
            }),
        ),
      );
      return sizes.every(([across, down]) => across === 0 && down === 0) && sizes.map(([, , width]) => width);
    });
    assert.ok(canvases.length > 3 && canvases.some((width) => !Number.isInteger(width)), canvases.join(', '));
  },
);
