// What a person sees in a part of the page, as marks: canvases, SVG, and the boxes and texts of HTML.
/** @import { Font, Look, Mark, Stroke } from './marks.js' */
/** @import { Place } from './vectors.js' */
import { pictureOn } from '../kit/canvas.js';
import { Outline } from './marks.js';
import { drawnMarks, measured } from './recording.js';
import { lookAt, strokeOf, vectorMarks } from './vectors.js';

/** @typedef {{ left: number, top: number, width: number, height: number }} Box */

/** Controls and hints are no part of a picture, but a name that can be pressed is. */
const left = 'button:not(.on-paper), input, select, fieldset, label, progress, .hint, .visually-hidden';
const haloWidth = 5;

/** @param {Element} element @param {Place} place @returns {Mark[]} */
export function marksOf(element, place) {
  const style = getComputedStyle(element);
  if (element.matches(left) || style.display === 'none' || style.visibility === 'hidden') return [];
  const here = { ...place, alpha: place.alpha * Number(style.opacity) };
  if (here.alpha === 0) return [];
  if (element instanceof HTMLCanvasElement) return canvasMarks(element, here);
  const own =
    element instanceof SVGElement && !(element instanceof SVGSVGElement)
      ? vectorMarks(element, style, here)
      : boxMarks(element, style, here);
  const children = inOrder(element).flatMap((node) =>
    node instanceof Element
      ? marksOf(node, here)
      : node instanceof window.Text
        ? textMarks(node, style, here)
        : [],
  );
  return [...own, ...children];
}

/** The children in the order in which they lie on each other. @param {Element} element */
function inOrder(element) {
  const level = (/** @type {Node} */ node) =>
    node instanceof Element ? Number(getComputedStyle(node).zIndex) || 0 : 0;
  return [...element.childNodes].sort((a, b) => level(a) - level(b));
}

/** @param {HTMLCanvasElement} canvas @param {Place} place @returns {Mark[]} */
function canvasMarks(canvas, { x, y, alpha }) {
  const { left, top, width, height } = canvas.getBoundingClientRect();
  const picture = pictureOn(canvas);
  if (width === 0 || !picture) return [];
  const { size, paint } = picture;
  const matrix = new DOMMatrix().translate(left - x, top - y).scale(width / size.width, height / size.height);
  const inPicture = (/** @type {DOMMatrix} */ own) => matrix.multiply(own);
  return drawnMarks(paint).map((mark) => ({
    ...mark,
    matrix: inPicture(mark.matrix),
    clips: mark.clips.map(({ d, matrix: own }) => ({ d, matrix: inPicture(own) })),
    alpha: alpha * mark.alpha,
  }));
}

/** @param {Element} element @param {CSSStyleDeclaration} style @param {Place} place @returns {Mark[]} */
function boxMarks(element, style, place) {
  const { left, top, width, height } = element.getBoundingClientRect();
  const box = { left: left - place.x, top: top - place.y, width, height };
  return [
    ...decorated(style, box, place),
    ...marksBefore(element, place),
    ...barOf(element, style, box, place),
  ];
}

/** The line of a fraction. @param {Element} element @param {CSSStyleDeclaration} style @param {Box} box @param {Place} place @returns {Mark[]} */
function barOf({ localName, children: [above, below] }, { color }, { left, width }, place) {
  if (localName !== 'mfrac') return [];
  const y = (above.getBoundingClientRect().bottom + below.getBoundingClientRect().top) / 2 - place.y;
  const line = new Outline(2);
  line.moveTo(left, y);
  line.lineTo(left + width, y);
  return [
    shape(line, lookAt(place), { stroke: { paint: color, width: 1, dash: [], cap: 'butt', join: 'miter' } }),
  ];
}

/** The background of a box and its edges. @param {CSSStyleDeclaration} style @param {Box} box @param {Place} place @returns {Mark[]} */
function decorated(style, { left, top, width, height }, place) {
  if (width === 0) return [];
  const look = lookAt(place);
  const [right, bottom] = [left + width, top + height];
  const edges = /** @type {const} */ ([
    ['Top', left, top, right, top],
    ['Right', right, top, right, bottom],
    ['Bottom', right, bottom, left, bottom],
    ['Left', left, bottom, left, top],
  ]);
  const lines = edges.map(([side]) => lineOf(style, side));
  const [{ paint, width: thick }] = lines;
  const inside = thick / 2;
  const box = /** @type {const} */ ([left + inside, top + inside, right - inside, bottom - inside]);
  const frame = frameOf(box, style.borderTopLeftRadius);
  const background = gradientOf(style.backgroundImage, left, width) ?? style.backgroundColor;
  const marks = height > 0 && isVisible(background) ? [shape(frame, look, { fill: background })] : [];
  if (thick > 0 && height > 0 && lines.every((one) => one.paint === paint && one.width === thick))
    return [...marks, shape(frame, look, { stroke: lines[0] })];
  for (const [i, [, x0, y0, x1, y1]] of edges.entries()) {
    const { width: own } = lines[i];
    if (own === 0) continue;
    // Clockwise: what is to the right of an edge is inside.
    const [dx, dy] = [(-Math.sign(y1 - y0) * own) / 2, (Math.sign(x1 - x0) * own) / 2];
    const line = new Outline(2);
    line.moveTo(x0 + dx, y0 + dy);
    line.lineTo(x1 + dx, y1 + dy);
    marks.push(shape(line, look, { stroke: lines[i] }));
  }
  return marks;
}

/** @param {Outline} outline @param {Look} look @param {Partial<Look>} paint @returns {Mark} */
const shape = ({ d }, look, paint) => ({ kind: 'shape', d, ...look, ...paint });

/** @param {CSSStyleDeclaration} style @param {'Top' | 'Right' | 'Bottom' | 'Left'} side @returns {Stroke} Of no width, if it is not seen. */
function lineOf(style, side) {
  const [kind, paint] = [style[`border${side}Style`], style[`border${side}Color`]];
  const isSeen = kind !== 'none' && kind !== 'hidden' && isVisible(paint);
  const width = isSeen ? Number.parseFloat(style[`border${side}Width`]) : 0;
  const dash = { dotted: [0, 2 * width], dashed: [2 * width, width] }[kind] ?? [];
  return { paint, width, dash, cap: kind === 'dotted' ? 'round' : 'butt', join: 'miter' };
}

/** A box with round corners. @param {readonly [number, number, number, number]} sides @param {string} radius */
function frameOf([left, top, right, bottom], radius) {
  const outline = new Outline(2);
  const half = Math.min(right - left, bottom - top) / 2;
  const r = Math.max(0, Math.min(half, radius.endsWith('%') ? half : Number.parseFloat(radius)));
  for (const [x, y, turn] of /** @type {const} */ ([
    [right - r, top + r, -0.5],
    [right - r, bottom - r, 0],
    [left + r, bottom - r, 0.5],
    [left + r, top + r, 1],
  ]))
    if (r > 0) outline.arc(x, y, r, turn * Math.PI, (turn + 0.5) * Math.PI);
    else outline.lineTo(x, y);
  outline.closePath();
  return outline;
}

const isVisible = (/** @type {import('./marks.js').Paint} */ paint) =>
  typeof paint !== 'string' || !/^rgba\(.*, 0\)$|^transparent$/.test(paint);

/** Even steps of colours from the left to the right. @param {string} image @param {number} left @param {number} width */
function gradientOf(image, left, width) {
  if (!image.startsWith('linear-gradient(to right')) return null;
  const colours = image.match(/rgba?\([^)]*\)/g) ?? [];
  return {
    from: /** @type {const} */ ([left, 0]),
    to: /** @type {const} */ ([left + width, 0]),
    stops: colours.map(
      (colour, i) => /** @type {[number, string]} */ ([i / Math.max(1, colours.length - 1), colour]),
    ),
  };
}

/** What stands before a text: a sign, or in a legend a little box. @param {Element} element @param {Place} place @returns {Mark[]} */
function marksBefore(element, place) {
  const style = getComputedStyle(element, '::before');
  const [, sign] = /^"(.*)"$/.exec(style.content) ?? [];
  if (sign === undefined || style.display !== (sign ? 'inline' : 'inline-block')) return [];
  const range = document.createRange();
  range.selectNodeContents(element);
  const [text] = range.getClientRects();
  if (!text) return [];
  if (sign) {
    const font = fontOf(style);
    const [x, y] = [text.left - place.x, text.top + ascentOf(font) - place.y];
    return [{ kind: 'text', ...lookAt(place), fill: style.color, text: sign, x, y, anchor: 'end', font }];
  }
  const px = (/** @type {string} */ length) => Number.parseFloat(length) || 0;
  const outer = getComputedStyle(element);
  const width = px(style.width) + px(style.borderLeftWidth) + px(style.borderRightWidth);
  const height = px(style.height) + px(style.borderTopWidth) + px(style.borderBottomWidth);
  const bottom = text.top + ascentOf(fontOf(outer)) - px(style.verticalAlign);
  const box = {
    left: text.left - px(style.marginRight) - width - place.x,
    top: bottom - height - place.y,
    width,
    height,
  };
  return decorated(style, box, { ...place, alpha: place.alpha * Number(style.opacity) });
}

/** @param {Text} node @param {CSSStyleDeclaration} style @param {Place} place @returns {Mark[]} */
function textMarks(node, style, place) {
  const parent = /** @type {Element} */ (node.parentElement);
  const font = fontOf(style);
  // A letter in a formula leans, though its style does not say so.
  if (parent.localName === 'mi' && node.length === 1) font.style = 'italic';
  const isVector = parent instanceof SVGElement;
  const { a, b } = (parent instanceof SVGGraphicsElement && parent.getScreenCTM()) || { a: 1, b: 0 };
  font.size *= Math.hypot(a, b);
  const ascent = ascentOf(font);
  const anchor = isVector ? style.textAnchor : style.textAlign;
  const side = /** @type {'start' | 'middle' | 'end'} */ (
    { middle: 'middle', center: 'middle', right: 'end', end: 'end' }[anchor] ?? 'start'
  );
  return linesOf(node).map(({ text, left, right, top }) => ({
    kind: 'text',
    ...lookAt(place),
    fill: isVector ? style.fill : style.color,
    fillOpacity: Number(style.fillOpacity),
    stroke: isVector ? strokeOf(style) : haloOf(style),
    text,
    x: { start: left, middle: (left + right) / 2, end: right }[side] - place.x,
    y: top + ascent - place.y,
    anchor: side,
    font,
  }));
}

/** The lines that a text is broken into. @param {Text} node */
function linesOf(node) {
  /** @type {{ text: string, left: number, right: number, top: number }[]} */
  const lines = [];
  const range = document.createRange();
  for (const { 0: word, index } of node.data.matchAll(/\S+/g)) {
    range.setStart(node, index);
    range.setEnd(node, index + word.length);
    const { left, right, top, width } = range.getBoundingClientRect();
    if (width === 0) continue;
    const last = lines[lines.length - 1];
    if (last && Math.abs(last.top - top) < 2) Object.assign(last, { text: `${last.text} ${word}`, right });
    else lines.push({ text: word, left, right, top });
  }
  return lines;
}

/** What keeps a text legible on what lies under it. @param {CSSStyleDeclaration} style @returns {Stroke | null} */
function haloOf({ textShadow }) {
  const [paint] = textShadow.match(/rgba?\([^)]*\)/) ?? [];
  return paint ? { paint, width: haloWidth, dash: [], cap: 'round', join: 'round' } : null;
}

/** @param {CSSStyleDeclaration} style @returns {Font} */
const fontOf = ({ fontStyle, fontWeight, fontSize, fontFamily }) => ({
  style: fontStyle,
  weight: fontWeight,
  size: Number.parseFloat(fontSize),
  family: fontFamily,
});

/** @param {Font} font */
const cssFont = ({ style, weight, size, family }) => `${style} ${weight} ${size}px ${family}`;

/** Firefox before 116 cannot tell it. @param {Font} font */
const ascentOf = (font) =>
  measured(cssFont(font), 'alphabetic', 'x').fontBoundingBoxAscent ?? 0.93 * font.size;
