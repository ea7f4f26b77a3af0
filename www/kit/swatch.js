// How a line looks that has a dash and a mark of its own, as a pinned run has: a piece of it for lists and tables.
import { styles } from '../run/pins.js';

const namespace = 'http://www.w3.org/2000/svg';

/** The mark is a path around (0, 0). @typedef {{ token: string, dash: readonly number[], mark: string }} Look */

/** @param {number} slot */
export const createSwatch = (slot) => swatchOf(styles[slot]);

/** @param {Look} look */
export function swatchOf({ token, dash, mark }) {
  const svg = part('svg', { viewBox: '0 -8 40 16', width: '40', height: '16', class: 'swatch' });
  svg.setAttribute('aria-hidden', 'true');
  svg.style.color = `var(${token})`;
  svg.append(
    part('path', { d: 'M0 0H40', 'stroke-dasharray': dash.join(' ') }),
    part('path', { d: mark, transform: 'translate(20)', class: 'mark' }),
  );
  return svg;
}

/** @param {string} name @param {Record<string, string>} attributes */
function part(name, attributes) {
  const element = /** @type {SVGElement} */ (document.createElementNS(namespace, name));
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  return element;
}

/** The mark of a pinned run on a canvas. @param {CanvasRenderingContext2D} context @param {number} slot @param {number} px @param {number} py @param {{ fill: string, edge: string }} colours */
export const drawMark = (context, slot, px, py, colours) =>
  drawPath(context, styles[slot].mark, px, py, colours);

/** @param {CanvasRenderingContext2D} context @param {string} path @param {number} px @param {number} py @param {{ fill: string, edge: string }} colours */
export function drawPath(context, path, px, py, { fill, edge }) {
  const mark = new Path2D(path);
  context.save();
  context.translate(px, py);
  context.setLineDash([]);
  context.lineJoin = 'round';
  context.lineWidth = 3;
  context.strokeStyle = edge;
  context.fillStyle = fill;
  context.stroke(mark);
  context.fill(mark);
  context.restore();
}
