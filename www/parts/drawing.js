// What the pictures of several parts are drawn with.
import { setLettering } from '../kit/lettering.js';

/** Between two numbers. */
const apart = 8;

/** A text as it is; on a piece of paper it is a name (kit/names.js). @param {CanvasRenderingContext2D} context @param {string} text @param {number} px @param {number} py @param {Parameters<typeof setLettering>[1]} [look] */
export function drawText(context, text, px, py, look = {}) {
  setLettering(context, look);
  context.fillText(text, px, py);
}

/**
 * Round numbers below an axis, as many as stand apart there, and how they are written.
 * @param {import('d3-scale').ScaleLinear<number, number>} scale @param {number} most @param {(ticks: readonly number[]) => readonly string[]} write @param {(text: string) => number} widthOf
 */
export function numbersApart(scale, most, write, widthOf) {
  for (let count = most; ; count -= 1) {
    const ticks = count > 0 ? scale.ticks(count) : scale.ticks(1).slice(0, 1);
    const texts = write(ticks);
    const room = ticks.length > 1 ? scale(ticks[1]) - scale(ticks[0]) : Number.POSITIVE_INFINITY;
    if (count === 0 || Math.max(...texts.map(widthOf)) + apart <= room)
      return ticks.map((tick, i) => ({ tick, text: texts[i] }));
  }
}
