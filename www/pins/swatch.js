// How a pinned run looks: a piece of its line with its mark, for lists and tables.
import { styles } from './pins.js';

const namespace = 'http://www.w3.org/2000/svg';

/** @param {number} slot */
export function createSwatch(slot) {
  const { token, dash, mark } = styles[slot];
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

/** The mark on a canvas. @param {CanvasRenderingContext2D} context @param {number} slot @param {number} px @param {number} py @param {{ fill: string, edge: string }} colours */
export function drawMark(context, slot, px, py, { fill, edge }) {
  const mark = new Path2D(styles[slot].mark);
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
