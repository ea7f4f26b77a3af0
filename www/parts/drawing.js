// What the pictures of several parts are drawn with.
/** @import { Paint, Size } from '../kit/canvas.js' */
import { createLayer } from '../kit/canvas.js';
import { setLettering } from '../kit/lettering.js';
import { watch } from '../kit/memo.js';

/** A layer that is drawn when what it shows is another. @param {HTMLCanvasElement} canvas */
export function createWatchedLayer(canvas) {
  const layer = createLayer(canvas);
  const changed = watch();
  /** @param {Size} size The same object while nobody resizes it. @param {readonly unknown[]} shown All else that the picture depends on. @param {Paint} paint It may be called again, to the same end. */
  return (size, shown, paint) => {
    if (size.width > 0 && changed(size, ...shown)) layer.draw(size, paint);
  };
}

/** A text as it is; on a piece of paper it is a name (kit/names.js). @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {Parameters<typeof setLettering>[1]} [look] */
export function drawText(context, text, px, py, look = {}) {
  setLettering(context, look);
  context.fillText(text, px, py);
}
