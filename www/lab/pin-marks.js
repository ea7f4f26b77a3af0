// How pinned runs look: a piece of the line for lists and tables, and its mark on a canvas.
import { drawPath, swatchOf } from '../kit/swatch.js';
import { styles } from '../run/pins.js';

/** @param {number} slot */
export const createSwatch = (slot) => swatchOf(styles[slot]);

/** @param {CanvasRenderingContext2D} context @param {number} slot @param {number} px @param {number} py @param {{ fill: string, edge: string }} colours */
export const drawMark = (context, slot, px, py, colours) =>
  drawPath(context, styles[slot].mark, px, py, colours);
