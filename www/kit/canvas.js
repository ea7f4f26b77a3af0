// Canvases that are drawn on in CSS pixels at the screen's own density, and what is on them, to be drawn once more elsewhere.
import { watch } from './memo.js';
import { followPixels } from './size.js';

/** @typedef {{ width: number, height: number }} Size */
/** @typedef {(context: CanvasRenderingContext2D) => void} Paint */

/** @type {WeakMap<HTMLCanvasElement, { size: Size, paint: Paint }>} */
const pictures = new WeakMap();

/** What was drawn last on a canvas of a layer. @param {HTMLCanvasElement} canvas */
export const pictureOn = (canvas) => pictures.get(canvas) ?? null;

/** @type {WeakMap<Path2D, string>} */
const outlines = new WeakMap();

/** A path that can be told again. @param {string} outline As SVG writes it. */
export function pathOf(outline) {
  const path = new Path2D(outline);
  outlines.set(path, outline);
  return path;
}

/** @param {Path2D} path From pathOf(). */
export const outlineOf = (path) => /** @type {string} */ (outlines.get(path));

/** Pixels of the screen in one of CSS, of contexts that draw there. @type {WeakMap<CanvasRenderingContext2D, number>} */
const densities = new WeakMap();

/**
 * A straight line that covers whole pixels of the screen: how wide it is, and where its middle lies, as near to its place as can be.
 * Where one pixel of CSS is no whole number of them, its width is moved as little as it takes; else it lies on pixels of CSS.
 * @param {CanvasRenderingContext2D} context @param {number} width
 */
export function sharpLine(context, width) {
  const density = densities.get(context) ?? 1;
  const [unit, pixels] = Number.isInteger(density)
    ? [1, width]
    : [density, Math.max(1, Math.round(width * density))];
  const middle = (/** @type {number} */ at) => (Math.round(at * unit - pixels / 2) + pixels / 2) / unit;
  return { width: pixels / unit, middle };
}

/** @param {HTMLCanvasElement} canvas */
export function createLayer(canvas) {
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const covered = followPixels(canvas, () => {
    const picture = pictures.get(canvas);
    if (!picture) return;
    const [width, height] = pixelsOf(picture.size, devicePixelRatio);
    if (canvas.width !== width || canvas.height !== height) layer.draw(picture.size, picture.paint);
  });
  /** Of another size than the one that is drawn what is covered says nothing. @param {Size} size @param {number} density */
  const pixelsOf = ({ width, height }, density) =>
    [width, height].map((length, axis) => {
      const [pixels, own] = [Math.round(length * density), covered()[axis]];
      return Math.abs(own - pixels) <= Math.max(1, density / 2) ? own : pixels;
    });
  const layer = {
    /** Fits the canvas to its size in CSS pixels, empties it, and draws. @param {Size} size @param {Paint} paint It may be called again, to the same end. */
    draw(size, paint) {
      const density = globalThis.devicePixelRatio || 1;
      const [width, height] = pixelsOf(size, density);
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      densities.set(context, density);
      context.setTransform(1, 0, 0, 1, 0, 0);
      context.clearRect(0, 0, width, height);
      context.setTransform(density, 0, 0, density, 0, 0);
      context.save();
      paint(context);
      context.restore();
      pictures.set(canvas, { size, paint });
    },
    /** Draws on what stands there already. @param {Paint} more @param {Paint} whole Both together, to be drawn once more elsewhere. */
    add(more, whole) {
      context.save();
      more(context);
      context.restore();
      const picture = pictures.get(canvas);
      if (picture) picture.paint = whole;
    },
  };
  return layer;
}

/** A layer that is drawn when what it shows is another. @param {HTMLCanvasElement} canvas */
export function createWatchedLayer(canvas) {
  const layer = createLayer(canvas);
  const changed = watch();
  /** @param {Size} size The same object while nobody resizes it. @param {readonly unknown[]} shown All else that the picture depends on. @param {Paint} paint It may be called again, to the same end. */
  return (size, shown, paint) => {
    if (size.width > 0 && changed(size, ...shown)) layer.draw(size, paint);
  };
}

/** Strokes the path with one colour on another, so that it is seen on anything. @param {CanvasRenderingContext2D} context @param {readonly [colour: string, width: number]} wide @param {readonly [colour: string, width: number]} narrow @param {Path2D} [path] Else the current one. */
export function strokeTwice(context, wide, narrow, path) {
  for (const [style, width] of [wide, narrow]) {
    context.strokeStyle = style;
    context.lineWidth = width;
    if (path) context.stroke(path);
    else context.stroke();
  }
}

/** Begins a path: a circle. @param {CanvasRenderingContext2D} context @param {number} px @param {number} py @param {number} radius */
export function circle(context, px, py, radius) {
  context.beginPath();
  context.arc(px, py, radius, 0, 2 * Math.PI);
}

/** A text with a halo, to be read on anything. @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {{ fill: string, halo: string, width?: number }} look */
export function fillTextWithHalo(context, text, px, py, { fill, halo, width = 5 }) {
  context.lineWidth = width;
  context.strokeStyle = halo;
  context.fillStyle = fill;
  context.strokeText(text, px, py);
  context.fillText(text, px, py);
}
