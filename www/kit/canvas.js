// Canvases that are drawn on in CSS pixels at the screen's own density, and what is on them, to be drawn once more elsewhere.

/** @typedef {{ width: number, height: number }} Size */
/** @typedef {(context: CanvasRenderingContext2D) => void} Paint */
/** @typedef {ReturnType<typeof createLayer>} Layer */

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

/** @param {HTMLCanvasElement} canvas */
export function createLayer(canvas) {
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  return {
    /** Fits the canvas to its size in CSS pixels, empties it, and draws. @param {Size} size @param {Paint} paint It may be called again, to the same end. */
    draw(size, paint) {
      const density = globalThis.devicePixelRatio || 1;
      const [width, height] = [Math.round(size.width * density), Math.round(size.height * density)];
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      context.setTransform(density, 0, 0, density, 0, 0);
      context.clearRect(0, 0, size.width, size.height);
      context.save();
      paint(context);
      context.restore();
      pictures.set(canvas, { size, paint });
    },
  };
}
