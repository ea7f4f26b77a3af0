// Canvases on the pixels of the screen, and lines there.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { createLayer, sharpLine } from '../../../www/kit/canvas.js';
import { test } from '../harness/once.js';

/** With a screen of so many pixels in one of CSS. @template T @param {number} density @param {() => T} act @returns {T} */
function onScreen(density, act) {
  const before = globalThis.devicePixelRatio;
  globalThis.devicePixelRatio = density;
  try {
    return act();
  } finally {
    globalThis.devicePixelRatio = before;
  }
}

const blankCanvas = () => {
  const context = { setTransform() {}, clearRect() {}, save() {}, restore() {} };
  const canvas = { width: 0, height: 0, getContext: () => context };
  return /** @type {HTMLCanvasElement} */ (/** @type {unknown} */ (canvas));
};

/** A line on a layer of so many pixels of the screen in one of CSS. @param {number} density @param {number} width @returns {ReturnType<typeof sharpLine>} */
const lineAt = (density, width) =>
  onScreen(density, () => {
    /** @type {ReturnType<typeof sharpLine>[]} */
    const lines = [];
    createLayer(blankCanvas()).draw({ width: 300, height: 200 }, (own) => lines.push(sharpLine(own, width)));
    return lines[0];
  });

const place = fc.double({ min: -50, max: 2000, noNaN: true });

test('a line covers whole pixels of the screen, of any density, and lies within one pixel of its place', () => {
  fc.assert(
    fc.property(fc.constantFrom(1, 1.1, 1.25, 1.5, 1.75, 2, 2.5, 3), place, (density, at) => {
      const { width, middle } = lineAt(density, 1);
      for (const edge of [middle(at) - width / 2, middle(at) + width / 2])
        assert.ok(Math.abs(edge * density - Math.round(edge * density)) < 1e-6, `${edge} at ${density}`);
      assert.ok(Math.abs(width - 1) <= 0.5 && Math.abs(middle(at) - at - 0.5) <= 0.5);
      // What is drawn over it once more is no other.
      assert.equal(lineAt(density, width).width, width);
    }),
  );
});

test('of whole pixels, and where it is written down, a line is as wide as asked and on a whole pixel', () => {
  const written = sharpLine(/** @type {CanvasRenderingContext2D} */ ({}), 1);
  for (const { width, middle } of [lineAt(1, 1), lineAt(2, 1), written])
    assert.deepEqual([width, middle(7.4), middle(7.6), middle(7.6, 0)], [1, 7.5, 8.5, 8]);
  assert.equal(lineAt(2, 1.5).width, 1.5);
});

/** A layer of which the browser tells how many pixels it covers. */
function toldLayer() {
  /** @type {((entries: object[]) => void)[]} */
  const heard = [];
  const all = /** @type {Record<string, unknown>} */ (/** @type {unknown} */ (globalThis));
  all.ResizeObserverEntry = { prototype: { devicePixelContentBoxSize: [] } };
  all.ResizeObserver = class {
    /** @param {(entries: object[]) => void} hear */
    constructor(hear) {
      heard.push(hear);
    }
    observe() {}
  };
  const canvas = blankCanvas();
  const layer = createLayer(canvas);
  delete all.ResizeObserverEntry;
  delete all.ResizeObserver;
  /** @param {number} inlineSize @param {number} blockSize */
  const tell = (inlineSize, blockSize) =>
    heard[0]([{ devicePixelContentBoxSize: [{ inlineSize, blockSize }] }]);
  return { canvas, layer, tell };
}

test('a canvas has as many pixels as it covers, where that is told, and else as many as its size has', () => {
  onScreen(1.5, () => {
    const { canvas, layer, tell } = toldLayer();
    let drawn = 0;
    const draw = (/** @type {number} */ width, /** @type {number} */ height) => {
      layer.draw({ width, height }, () => {
        drawn += 1;
      });
      return [canvas.width, canvas.height];
    };
    assert.deepEqual(draw(313, 132), [470, 198]);
    // Of 312.5 × 131.6 pixels.
    tell(469, 197);
    assert.deepEqual([canvas.width, canvas.height, drawn], [469, 197, 2]);
    tell(469, 197);
    assert.equal(drawn, 2);
    assert.deepEqual(draw(313, 132), [469, 197]);
    assert.deepEqual(draw(400, 132), [600, 198], 'of another size');
    tell(599, 197);
    assert.deepEqual([canvas.width, canvas.height, drawn], [599, 197, 5]);
    tell(0, 0);
    assert.deepEqual([canvas.width, canvas.height, drawn], [600, 198, 6], 'not in sight');
  });
});
