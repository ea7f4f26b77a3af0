// What the pictures of several parts are drawn with.
import { setLettering } from '../kit/lettering.js';

/** A text as it is; on a piece of paper it is a name (kit/names.js). @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {Parameters<typeof setLettering>[1]} [look] */
export function drawText(context, text, px, py, look = {}) {
  setLettering(context, look);
  context.fillText(text, px, py);
}
