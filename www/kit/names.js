// The names at the lines of a chart, on its canvas.
/** @import { Size } from './canvas.js' */
/** @import { Frame } from './chart.js' */
import { setLettering, italicFont, strongFont, symbolFont, textFont } from './lettering.js';
import { colour } from './palette.js';

/**
 * @typedef {object} Name
 * @property {string | readonly string[]} text Of several pieces, every second one is a subscript.
 * @property {number} x
 * @property {number} y Of the middle.
 * @property {'left' | 'right'} [align] Which of its sides is at x.
 * @property {string} [token]
 * @property {boolean} [isStrong]
 */

export const labelHeight = 17;
const [padding, high] = [3, 13];

/** Where a chart is narrower, the names of its lines stand within it. */
const roomForNames = 300;

/** @param {Size} size */
export const isNarrow = ({ width }) => width < roomForNames;

/** The room for names beside the lines, or for the half of a number below their end. @param {Size} size */
export const gutterOf = (size) => (isNarrow(size) ? 18 : 100);

/** A name on a piece of paper. @param {CanvasRenderingContext2D} context @param {Name} name @param {number} [opacity] Of the paper. */
export function drawName(context, { text, x, y, align = 'left', token = '--muted', isStrong }, opacity = 1) {
  const pieces = typeof text === 'string' ? [text] : text;
  // A letter by itself is a symbol, as in formulas.
  const font = /^[A-Za-z]$/.test(pieces.join('')) ? symbolFont : isStrong ? strongFont : textFont;
  const fonts = pieces.map((_, i) => (i % 2 ? font.replace('13px', '11px') : font));
  const widths = pieces.map((piece, i) => {
    context.font = fonts[i];
    return context.measureText(piece).width;
  });
  const width = widths.reduce((sum, one) => sum + one, 2 * padding);
  let left = align === 'left' ? x : x - width;
  context.globalAlpha = opacity;
  context.fillStyle = colour('--paper');
  context.fillRect(left, y - high / 2, width, high);
  context.globalAlpha = 1;
  setLettering(context, { token });
  left += padding;
  for (const [i, piece] of pieces.entries()) {
    context.font = fonts[i];
    if (piece) context.fillText(piece, left, Math.round(y + 1.5) + (i % 2 ? 4 : 0));
    left += widths[i];
  }
}

/** A letter with its index, as in formulas. @param {CanvasRenderingContext2D} context @param {{ letter: string, index: string }} symbol @param {string} token @param {number} x @param {number} y Of the line it stands on. */
export function drawSymbol(context, { letter, index }, token, x, y) {
  setLettering(context, { token, font: italicFont(18), baseline: 'alphabetic' });
  context.fillText(letter, x, y);
  context.font = italicFont(13);
  context.fillText(index, x + 9, y + 4);
}

/**
 * Names at the ends of their lines; in a narrow chart above them, at its edge.
 * @param {CanvasRenderingContext2D} context @param {Size} size @param {Frame} frame @param {readonly Name[]} names
 */
export function drawNames(context, size, frame, names) {
  for (const name of names)
    if (isNarrow(size)) {
      const y = Math.max(name.y, frame.top + labelHeight) - high / 2;
      drawName(context, { ...name, x: frame.right, y, align: 'right' }, 0.72);
    } else drawName(context, name);
}

/** What the axes show: beside the lower one and the half of its last number, and at the top of the other. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {{ x?: string, y?: string }} names */
export function drawAxisNames(context, frame, { x, y }) {
  if (x) drawName(context, { text: x, x: frame.right + 20, y: frame.bottom + 6 + high / 2 });
  if (y) drawName(context, { text: y, x: frame.left - 50, y: frame.top + high / 2 }, 0);
}

/** Which of several numbers at one side do not touch one before them in the list. @param {readonly number[]} heights @returns {number[]} */
export function standingFree(heights) {
  /** @type {number[]} */
  const free = [];
  for (const [i, height] of heights.entries())
    if (free.every((other) => Math.abs(heights[other] - height) >= high)) free.push(i);
  return free;
}

/** So far above the lower end of a chart the lowest name beside it leaves that of the axis alone. */
const aboveAxis = 5;

/** Moves names apart at the side of a chart. @param {{ y: number }[]} places @param {Frame} frame */
export const spreadBeside = (places, { top, bottom }) => spread(places, top, bottom - aboveAxis);

/**
 * Moves names apart that would lie on each other, as little up as down, keeps them between two heights and leaves the others alone.
 * @param {{ y: number }[]} places @param {number} top @param {number} bottom
 */
export function spread(places, top, bottom) {
  const sorted = [...places].sort((a, b) => a.y - b.y);
  /** Those that push each other, by where the first of all would be. @type {{ mean: number, count: number }[]} */
  const groups = [];
  for (const [i, { y }] of sorted.entries()) {
    let group = { mean: y - i * labelHeight, count: 1 };
    for (let above = groups.at(-1); above && above.mean > group.mean; above = groups.at(-1)) {
      groups.pop();
      const count = above.count + group.count;
      group = { mean: (above.mean * above.count + group.mean * group.count) / count, count };
    }
    groups.push(group);
  }
  const lowest = bottom - (sorted.length - 1) * labelHeight;
  const means = groups.flatMap(({ mean, count }) => Array(count).fill(mean));
  for (const [i, place] of sorted.entries())
    place.y = Math.min(Math.max(means[i], top), lowest) + i * labelHeight;
}
