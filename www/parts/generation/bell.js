// The density of N(0, 1) as a small picture, with the draw on it.
import { svg } from '../../kit/elements.js';

const width = 84;
const height = 40;
const base = height - 6;
const reach = 3.3;

const x = (/** @type {number} */ draw) =>
  ((Math.max(-reach, Math.min(reach, draw)) + reach) / (2 * reach)) * width;
const y = (/** @type {number} */ draw) => base - (base - 4) * Math.exp(-0.5 * draw * draw);

const outline = Array.from({ length: 45 }, (_, i) => {
  const draw = -reach + (2 * reach * i) / 44;
  return `${x(draw).toFixed(1)} ${y(draw).toFixed(1)}`;
}).join('L');

/** @param {number | null} draw Null: nothing has been drawn yet. */
export function createBell(draw) {
  const picture = svg('svg', { viewBox: `0 0 ${width} ${height}`, class: 'bell', 'aria-hidden': 'true' });
  picture.append(
    svg('path', { d: `M${outline}`, class: 'density' }),
    svg('path', { d: `M0 ${base}H${width}M${width / 2} ${base}v4`, class: 'base' }),
  );
  if (draw !== null)
    picture.append(
      svg('path', { d: `M${x(draw)} ${base}V${Math.min(y(draw), base - 8)}`, class: 'draw' }),
      svg('circle', { cx: String(x(draw)), cy: String(base), r: '3.5', class: 'drawn' }),
    );
  return picture;
}
