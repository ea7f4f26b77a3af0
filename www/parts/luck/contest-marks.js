// What the pictures of a contest have in common: round distances, and the names at the ends of the lines.
/** @import { Frame } from '../../kit/chart.js' */
/** @import { Size } from '../../kit/canvas.js' */
/** @import { Standings } from './contest-summary.js' */
import { colour } from '../../kit/palette.js';
import { textFont } from '../../kit/lettering.js';
import { drawName, gutterOf, isNarrow, spreadBeside } from '../../kit/names.js';
import { drawMark } from '../../kit/swatch.js';
import { styles } from '../../run/pins.js';
import words from './words/index.js';

/** In pixels, the height of a number, and what stands between two. */
const roomForNumber = 16;

/** All powers of ten, or on an axis those whose numbers have room above each other. @param {readonly [number, number]} range @param {number} [height] In pixels. */
export function powersIn([from, to], height = Infinity) {
  const first = Math.ceil(Math.log10(from) - 1e-9);
  const last = Math.floor(Math.log10(to) + 1e-9);
  const each = Math.max(1, Math.ceil((roomForNumber * Math.log10(to / from)) / Math.max(1, height)));
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => first + i)
    .filter((power) => power % each === 0)
    .map((power) => 10 ** power);
}

/** @param {readonly number[]} powers */
export const powerNames = (powers) => powers.map((power) => words.powerOfTen(Math.round(Math.log10(power))));

/** In pixels, from the end of a line to its name. */
const aside = 8;

/** With room for names at its right. @typedef {Frame & { hasNames: boolean }} NamedFrame */

/** The room that the names at the right need. @param {CanvasRenderingContext2D} context @param {Size} size @param {Standings | null} standings */
export function gutterFor(context, size, standings) {
  const usual = gutterOf(size);
  if (isNarrow(size) || !standings) return usual;
  context.font = textFont;
  const widths = standings.lines.map(({ name }) => context.measureText(words.shortName(name)).width);
  return Math.max(usual, ...widths.map((width) => aside + width + 6));
}

/** At the right edge; a line that is not there has no height. @param {CanvasRenderingContext2D} context @param {NamedFrame} frame @param {Standings} standings @param {readonly number[]} heights */
export function drawNamesAt(context, frame, standings, heights) {
  const places = heights.flatMap((height, i) => {
    if (!Number.isFinite(height)) return [];
    const at = Math.min(Math.max(height, frame.top), frame.bottom);
    return [{ at, y: at, style: styles[i], text: words.shortName(standings.lines[i].name) }];
  });
  if (places.length === 0) return;
  const edge = colour('--paper');
  for (const { at, style } of places)
    drawMark(context, style.mark, frame.right, at, { fill: colour(style.token), edge });
  // Where there is no room beside the lines, their marks say whose they are.
  if (!frame.hasNames) return;
  spreadBeside(places, frame);
  for (const { text, y, style } of places)
    drawName(context, { text, x: frame.right + aside, y, token: style.token });
}
