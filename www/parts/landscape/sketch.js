// What a method sees, drawn on the map.
/** @import { Place } from '../../kit/ellipse.js' */
/** @import { Sketch } from './method.js' */
/** @import { Axes } from './view.js' */
import { strokeTwice } from '../../kit/canvas.js';
import { dark, light } from '../../kit/map.js';

/** @param {CanvasRenderingContext2D} context @param {Pick<Axes, 'x' | 'y'>} axes @param {Sketch} sketch */
export function drawSketch(context, { x, y }, { rings, lines, faint }) {
  const at = (/** @type {Place} */ [px, py]) => /** @type {const} */ ([x.at(px), y.at(py)]);
  const trace = (/** @type {Sketch['lines']} */ pairs) => {
    context.beginPath();
    for (const [from, to] of pairs) {
      context.moveTo(...at(from));
      context.lineTo(...at(to));
    }
  };
  context.save();
  context.setLineDash([3, 4]);
  trace(faint);
  context.globalAlpha = 0.6;
  context.strokeStyle = light;
  context.lineWidth = 1;
  context.stroke();
  context.restore();
  trace(lines);
  strokeTwice(context, [dark, 4], [light, 2]);
  for (const ring of rings) {
    context.beginPath();
    for (const place of ring) context.lineTo(...at(place));
    context.closePath();
    strokeTwice(context, [dark, 4], [light, 2]);
  }
}
