// What the pictures of several parts are drawn with.
/** @import { Paint, Size } from '../kit/canvas.js' */
import { createLayer } from '../kit/canvas.js';
import { textFont } from '../kit/fonts.js';
import { watch } from '../kit/memo.js';
import { colour } from '../kit/palette.js';

/** A layer that is drawn when what it shows is another. @param {HTMLCanvasElement} canvas */
export function createWatchedLayer(canvas) {
  const layer = createLayer(canvas);
  const changed = watch();
  /** @param {Size} size The same object while nobody resizes it. @param {readonly unknown[]} shown All else that the picture depends on. @param {Paint} paint It may be called again, to the same end. */
  return (size, shown, paint) => {
    if (size.width > 0 && changed(size, ...shown)) layer.draw(size, paint);
  };
}

/** A text as it is; on a piece of paper it is a name (kit/names.js). @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {{ token?: string, font?: string, align?: CanvasTextAlign, baseline?: CanvasTextBaseline }} [look] */
export function drawText(context, text, px, py, look = {}) {
  const { token = '--muted', font = textFont, align = 'left', baseline = 'middle' } = look;
  context.font = font;
  context.fillStyle = colour(token);
  context.textAlign = align;
  context.textBaseline = baseline;
  context.fillText(text, px, py);
}
