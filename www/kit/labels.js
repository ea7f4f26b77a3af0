// Plain texts on canvases; names on pieces of paper are in names.js.
import { textFont } from './fonts.js';
import { colour } from './palette.js';

/** @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {{ token?: string, font?: string, align?: CanvasTextAlign, baseline?: CanvasTextBaseline }} [look] */
export function drawText(context, text, px, py, look = {}) {
  const { token = '--muted', font = textFont, align = 'left', baseline = 'middle' } = look;
  context.font = font;
  context.fillStyle = colour(token);
  context.textAlign = align;
  context.textBaseline = baseline;
  context.fillText(text, px, py);
}
