// A canvas that is drawn on in CSS pixels or in metres, at the screen's own density.

/** @typedef {import('./transform.js').View} View */
/** @typedef {ReturnType<typeof createLayer>} Layer */

/** @param {HTMLCanvasElement} canvas */
export function createLayer(canvas) {
  const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
  const pixels = () => globalThis.devicePixelRatio || 1;
  return {
    context,
    /** Fits the canvas to its size in CSS pixels, and empties it. @param {{ width: number, height: number }} size */
    clear({ width: wide, height: high }) {
      const [width, height] = [Math.round(wide * pixels()), Math.round(high * pixels())];
      if (canvas.width !== width || canvas.height !== height) [canvas.width, canvas.height] = [width, height];
      this.inPixels();
      context.clearRect(0, 0, wide, high);
      context.setLineDash([]);
    },
    inPixels: () => context.setTransform(pixels(), 0, 0, pixels(), 0, 0),
    /** @param {View} view */
    inMetres(view) {
      const scale = pixels() * view.scale;
      context.setTransform(scale, 0, 0, -scale, pixels() * view.originX, pixels() * view.originY);
    },
  };
}
