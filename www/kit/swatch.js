// How a line looks that has a dash and a mark of its own: a piece of it for lists and tables.
import { pathOf } from './canvas.js';
import { svg } from './elements.js';

/** The mark is an outline around (0, 0). @typedef {{ token: string, dash: readonly number[], mark: string }} Look */

/** @param {Look} look */
export function createSwatch({ token, dash, mark }) {
  const picture = svg(
    'svg',
    { viewBox: '0 -8 40 16', width: 40, height: 16, class: 'swatch', 'aria-hidden': 'true' },
    svg('path', { d: 'M0 0H40', 'stroke-dasharray': dash.join(' ') }),
    svg('path', { d: mark, transform: 'translate(20)', class: 'mark' }),
  );
  picture.style.color = `var(${token})`;
  return picture;
}

/** @param {CanvasRenderingContext2D} context @param {string} outline As SVG writes it, around (0, 0). @param {number} px @param {number} py @param {{ fill: string, edge: string }} colours */
export function drawMark(context, outline, px, py, { fill, edge }) {
  const mark = pathOf(outline);
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
