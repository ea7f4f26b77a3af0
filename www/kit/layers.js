// Canvases that are drawn only when what they show is another.
/** @import { Paint, Size } from './canvas.js' */
import { createLayer } from './canvas.js';
import { watch } from './memo.js';

/** @param {HTMLCanvasElement} canvas */
export function createWatchedLayer(canvas) {
  const layer = createLayer(canvas);
  const changed = watch();
  /** @param {Size} size The same object while nobody resizes it. @param {readonly unknown[]} shown All else that the picture depends on. @param {Paint} paint It may be called again, to the same end. */
  return (size, shown, paint) => {
    if (size.width > 0 && changed(size, ...shown)) layer.draw(size, paint);
  };
}
