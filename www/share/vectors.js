// Shapes of SVG on the screen, as marks.
/** @import { Clip, Look, Mark, Stroke } from './marks.js' */

/** @typedef {{ x: number, y: number, alpha: number }} Place Pixels of the picture's corner, and how opaque what is around is. */

/** @param {Place} place @returns {Look} */
export const lookAt = ({ alpha }) => ({
  matrix: new DOMMatrix(),
  clips: [],
  alpha,
  fill: null,
  stroke: null,
});

/** @param {SVGElement} element @param {CSSStyleDeclaration} style @param {Place} place @returns {Mark[]} */
export function vectorMarks(element, style, place) {
  const own = element instanceof SVGGraphicsElement && element.getScreenCTM();
  const d = shapeOf(element);
  if (!own || d === null) return [];
  const matrix = new DOMMatrix().translate(-place.x, -place.y).multiply(DOMMatrix.fromMatrix(own));
  const look = {
    ...lookAt(place),
    clips: clipsOf(element, place),
    fill: element instanceof SVGLineElement || style.fill === 'none' ? null : style.fill,
    fillOpacity: Number(style.fillOpacity),
    stroke: strokeOf(style),
  };
  // Not every program knows of strokes that are not stretched.
  if (style.vectorEffect === 'non-scaling-stroke') return [{ kind: 'shape', ...look, d: moved(d, matrix) }];
  return [{ kind: 'shape', ...look, d, matrix }];
}

/** Where a matrix takes an outline of absolute pairs. @param {string} d @param {DOMMatrix} matrix */
const moved = (d, matrix) =>
  d.replace(/(-?[\d.e-]+)[ ,](-?[\d.e-]+)/g, (_, x, y) => {
    const point = matrix.transformPoint({ x: Number(x), y: Number(y) });
    return `${point.x.toFixed(2)} ${point.y.toFixed(2)}`;
  });

/** @param {SVGElement} element @returns {string | null} */
function shapeOf(element) {
  const numbers = (/** @type {SVGAnimatedLength[]} */ ...lengths) =>
    lengths.map(({ baseVal }) => +baseVal.value.toFixed(3));
  if (element instanceof SVGPathElement) return element.getAttribute('d') ?? '';
  if (element instanceof SVGPolylineElement)
    return `M${Array.from(element.points, ({ x, y }) => `${x} ${y}`).join('L')}`;
  if (element instanceof SVGLineElement) {
    const [x1, y1, x2, y2] = numbers(element.x1, element.y1, element.x2, element.y2);
    return `M${x1} ${y1}L${x2} ${y2}`;
  }
  if (element instanceof SVGRectElement) {
    const [x, y, width, height] = numbers(element.x, element.y, element.width, element.height);
    return `M${x} ${y}h${width}v${height}h${-width}Z`;
  }
  const isCircle = element instanceof SVGCircleElement;
  if (!isCircle && !(element instanceof SVGEllipseElement)) return null;
  const [cx, cy, rx, ry] = isCircle
    ? numbers(element.cx, element.cy, element.r, element.r)
    : numbers(element.cx, element.cy, element.rx, element.ry);
  return `M${cx - rx} ${cy}a${rx} ${ry} 0 1 0 ${2 * rx} 0a${rx} ${ry} 0 1 0 ${-2 * rx} 0Z`;
}

/** The edge of its SVG, if nothing is seen beyond it. @param {SVGElement} element @param {Place} place @returns {Clip[]} */
function clipsOf(element, { x, y }) {
  const all = element.ownerSVGElement;
  if (!all || getComputedStyle(all).overflow === 'visible') return [];
  const { left, top, width, height } = all.getBoundingClientRect();
  return [{ d: `M${left - x} ${top - y}h${width}v${height}h${-width}Z`, matrix: new DOMMatrix() }];
}

/** @param {CSSStyleDeclaration} style @returns {Stroke | null} */
export function strokeOf(style) {
  const { stroke, strokeDasharray } = style;
  if (stroke === 'none') return null;
  const dash = strokeDasharray === 'none' ? [] : strokeDasharray.split(/[ ,]+/).map(Number.parseFloat);
  return {
    paint: stroke,
    opacity: Number(style.strokeOpacity),
    width: Number.parseFloat(style.strokeWidth),
    dash,
    cap: style.strokeLinecap,
    join: style.strokeLinejoin,
  };
}
