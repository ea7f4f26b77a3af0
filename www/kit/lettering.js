// How texts look on a canvas, and where they stand beside their points.
import { textFont } from './fonts.js';
import { colour } from './palette.js';

/** Of all texts that follow. @param {CanvasRenderingContext2D} context @param {{ token?: string, font?: string, align?: CanvasTextAlign, baseline?: CanvasTextBaseline }} look */
export function setLettering(
  context,
  { token = '--muted', font = textFont, align = 'left', baseline = 'middle' },
) {
  context.fillStyle = colour(token);
  context.font = font;
  context.textAlign = align;
  context.textBaseline = baseline;
}
