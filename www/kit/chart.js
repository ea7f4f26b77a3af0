// Line charts on canvases: axes, lines, bands and a cursor. Names at the lines are in names.js.
import { circle, createLayer, sharpLine } from './canvas.js';
import { followSize } from './size.js';
import { outlineOf } from './extent.js';
import { setLettering } from './lettering.js';
import { standingFree } from './names.js';
import { watch } from './memo.js';
import { colour } from './palette.js';
import { multiples, roundStep, sameDigits } from './steps.js';

/** @typedef {import('./canvas.js').Size} Size */
/** @typedef {import('d3-scale').ScaleContinuousNumeric<number, number>} Scale */
/** @typedef {{ left: number, right: number, top: number, bottom: number }} Frame */
/** @typedef {{ x: Scale, y: Scale, frame: Frame }} Axes */
/** @typedef {{ token: string, width: number, dash?: readonly number[] }} Stroke */

/**
 * A canvas that fills an element, drawn when what it shows or its size is another.
 * @template {object} M
 * @param {HTMLElement} root @param {(context: CanvasRenderingContext2D, size: Size, model: M) => void} draw
 */
export function createChart(root, draw) {
  const canvas = root.appendChild(document.createElement('canvas'));
  root.classList.add('chart');
  const layer = createLayer(canvas);
  const changed = watch();
  /** @type {M | null} */
  let shown = null;
  const show = (/** @type {Size} */ size) => {
    const model = shown;
    if (!model || size.width === 0) return;
    // In whole pixels, because a canvas that is stretched by a part of one is blurred.
    canvas.style.setProperty('--wide', `${size.width}px`);
    canvas.style.setProperty('--high', `${size.height}px`);
    layer.draw(size, (context) => draw(context, size, model));
  };
  const sizeOf = followSize(root, show);
  return {
    canvas,
    /** @param {M} model @returns {boolean} whether it is another */
    draw(model) {
      if (!changed(...Object.values(model))) return false;
      shown = model;
      show(sizeOf());
      return true;
    },
  };
}

/** Where the lines are: beside numbers on the left, above those of the other axis. @param {Size} size @param {{ top?: number, right: number }} margin @returns {Frame} */
export const frameIn = ({ width, height }, { top = 8, right }) => ({
  left: 52,
  right: width - right,
  top,
  bottom: height - 28,
});

/**
 * Round numbers on an axis, at least so many pixels apart.
 * @param {Scale} scale @param {number} space @param {{ factors?: readonly number[], least?: number }} [steps] Which multiples of powers of ten, from which on.
 */
export function ticksOn(scale, space, { factors = [1, 2, 2.5, 5], least = 0 } = {}) {
  const [from, to] = scale.domain();
  const [start, end] = scale.range();
  const wanted = Math.max(least, (space * (to - from)) / Math.max(1, Math.abs(end - start)));
  const step = roundStep(wanted, factors);
  // No number tells how far apart the ends are.
  return Number.isFinite(step) ? multiples(from, to, step) : [];
}

/** Round numbers on an upright axis; closer where else one alone would not tell how far apart they are. @param {Scale} scale */
export function levelsOn(scale) {
  const ticks = ticksOn(scale, 32);
  return ticks.length > 1 ? ticks : ticksOn(scale, 14);
}

/** Whole numbers, as generations are. @param {Scale} scale */
export const wholeTicks = (scale) => ticksOn(scale, 56, { factors: [1, 2, 5], least: 1 });

/** A straight line on the pixels, as wide as was taken. @param {CanvasRenderingContext2D} context @param {readonly [number, number]} from @param {readonly [number, number]} to */
export function line(context, from, to) {
  const { width, middle } = sharpLine(context, context.lineWidth);
  context.lineWidth = width;
  context.moveTo(middle(from[0]), middle(from[1]));
  context.lineTo(middle(to[0]), middle(to[1]));
}

/** @param {CanvasRenderingContext2D} context @param {Stroke} stroke */
export function take(context, { token, width, dash = [] }) {
  context.strokeStyle = colour(token);
  context.lineWidth = width;
  context.setLineDash([...dash]);
}

/** Lines at the ticks, and the numbers on the left. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {{ x: readonly number[], y: readonly number[] }} ticks @param {readonly string[]} texts */
export function drawGrid(context, { x, y, frame }, ticks, texts) {
  take(context, { token: '--hairline', width: 1 });
  context.beginPath();
  for (const tick of ticks.x) line(context, [x(tick), frame.top], [x(tick), frame.bottom]);
  for (const tick of ticks.y) line(context, [frame.left, y(tick)], [frame.right, y(tick)]);
  context.stroke();
  drawNumbersBeside(context, y, frame.left - 6, ticks.y, texts);
}

/** Numbers on the left, which end there, or begin at the edge; one that would touch another before it in the list is left out. @param {CanvasRenderingContext2D} context @param {(value: number) => number} y @param {number} right @param {readonly number[]} ticks @param {readonly string[]} texts */
export function drawNumbersBeside(context, y, right, ticks, texts) {
  setLettering(context, { align: 'right' });
  for (const i of standingFree(ticks.map(y)))
    context.fillText(texts[i], Math.max(right, context.measureText(texts[i]).width + 1), y(ticks[i]));
}

/** The numbers below. @param {CanvasRenderingContext2D} context @param {(value: number) => number} x @param {number} bottom @param {readonly number[]} ticks @param {readonly string[]} texts */
export function drawNumbersBelow(context, x, bottom, ticks, texts) {
  setLettering(context, { align: 'center', baseline: 'top' });
  for (const [i, tick] of ticks.entries()) context.fillText(texts[i], x(tick), bottom + 7);
}

/** A grid over whole numbers, such as generations, with these levels on the left. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {readonly number[]} levels @param {readonly string[]} [texts] */
export function drawGridOverWholes(context, axes, levels, texts = sameDigits(levels)) {
  const wholes = wholeTicks(axes.x);
  drawGrid(context, axes, { x: wholes, y: levels }, texts);
  drawNumbersBelow(context, axes.x, axes.frame.bottom, wholes, wholes.map(String));
}

/** What is drawn stays within the frame. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {() => void} draw */
export function within(context, frame, draw) {
  context.save();
  context.beginPath();
  context.rect(frame.left, frame.top, frame.right - frame.left, frame.bottom - frame.top);
  context.clip();
  context.lineJoin = 'round';
  draw();
  context.restore();
}

/** A figure that opens may be narrower than its margins. @param {Frame} frame */
const widthOf = (frame) => Math.max(1, frame.right - frame.left);

/** Where a curve has more samples than this for each pixel, most of them cannot be seen. */
const crowded = 4;

/**
 * The samples of a curve that make its picture: all, or where they are crowded of each half pixel the first, the last, and those
 * with the least and the largest value; none after one without a value.
 * @param {number} first @param {number} count @param {ArrayLike<number>} values @param {number} width In pixels.
 */
function seenSamples(first, count, values, width) {
  if (count - first <= crowded * width) return Array.from({ length: count - first }, (_, i) => first + i);
  const outline = values instanceof Float64Array && values.length === count ? outlineOf(values) : null;
  const half = Math.ceil((count - first) / (2 * width));
  const isOutlined = outline !== null && half >= outline.stretch;
  // In whole stretches of its outline.
  const each = isOutlined ? Math.ceil(half / outline.stretch) * outline.stretch : half;
  /** @type {number[]} */
  const seen = [];
  for (let from = first; from < count; from += each) {
    const end = Math.min(from + each, count);
    let [least, most, low, high] = [from, from, values[from], values[from]];
    const last = isOutlined ? 2 * Math.ceil(end / outline.stretch) : end;
    for (let at = isOutlined ? (2 * from) / outline.stretch : from + 1; at < last; at += 1) {
      const i = isOutlined ? outline.ends[at] : at;
      const value = values[i];
      if (value < low) [least, low] = [i, value];
      else if (value > high) [most, high] = [i, value];
      else if (Number.isNaN(value)) return [...seen, from, i];
    }
    for (const i of [from, Math.min(least, most), Math.max(least, most), end - 1])
      if (i !== seen[seen.length - 1]) seen.push(i);
  }
  return seen;
}

/**
 * Where a curve goes, without the steps too small to see: from where it is a number to where it is none.
 * @param {Axes} axes @param {ArrayLike<number>} xs @param {ArrayLike<number>} values @param {boolean} [isHeld] until the next sample
 */
export function pointsOf({ x, y, frame }, xs, values, isHeld = false) {
  const least = 0.5;
  const last = xs.length - 1;
  const height = frame.bottom - frame.top;
  // A canvas draws nothing of what is too far outside.
  const inside = (/** @type {number} */ py) =>
    Math.min(Math.max(py, frame.top - 3 * height), frame.bottom + 3 * height);
  let first = 0;
  while (first < last && Number.isNaN(values[first])) first += 1;
  let [fromX, fromY] = [x(xs[first]), inside(y(values[first]))];
  /** @type {[number, number][]} */
  const points = [[fromX, fromY]];
  for (const i of seenSamples(first, xs.length, values, widthOf(frame)).slice(1)) {
    const [px, py] = [x(xs[i]), inside(y(values[i]))];
    if (Number.isNaN(py)) break;
    if (i < last && Math.abs(px - fromX) + Math.abs(py - fromY) < least) continue;
    if (isHeld) points.push([px, fromY]);
    points.push([px, py]);
    [fromX, fromY] = [px, py];
  }
  return points;
}

/** Adds points to the path. @param {CanvasRenderingContext2D} context @param {readonly (readonly [number, number])[]} points */
export function through(context, points) {
  const [first, ...rest] = points;
  context.moveTo(...first);
  for (const point of rest) context.lineTo(...point);
}

/** @param {CanvasRenderingContext2D} context @param {readonly (readonly [number, number])[]} points @param {Stroke} stroke */
export function strokeThrough(context, points, stroke) {
  take(context, stroke);
  context.beginPath();
  through(context, points);
  context.stroke();
}

/** A line that is sharp where it is level. @param {CanvasRenderingContext2D} context @param {readonly (readonly [number, number])[]} points @param {Stroke} stroke */
export function drawCurve(context, points, stroke) {
  const { width, middle } = sharpLine(context, stroke.width);
  const onPixels = points.map(([px, py]) => /** @type {const} */ ([middle(px), middle(py)]));
  strokeThrough(context, onPixels, { ...stroke, width });
}

/** A line from one side to the other. @param {CanvasRenderingContext2D} context @param {Pick<Frame, 'left' | 'right'>} frame @param {number} py @param {Stroke} stroke */
export function drawLevel(context, { left, right }, py, stroke) {
  const ends = [left, right].map((px) => /** @type {const} */ ([px, py]));
  drawCurve(context, ends, stroke);
  context.setLineDash([]);
}

/** What lies between two curves. @param {CanvasRenderingContext2D} context @param {readonly (readonly [number, number])[]} upper @param {readonly (readonly [number, number])[]} lower @param {string} token @param {number} alpha */
export function drawBand(context, upper, lower, token, alpha) {
  context.beginPath();
  through(context, [...upper, ...[...lower].reverse()]);
  context.globalAlpha = alpha;
  context.fillStyle = colour(token);
  context.fill();
  context.globalAlpha = 1;
}

/** @param {CanvasRenderingContext2D} context @param {number} px @param {Pick<Frame, 'top' | 'bottom'>} frame @param {Stroke} stroke */
export function drawUpright(context, px, { top, bottom }, stroke) {
  take(context, stroke);
  context.beginPath();
  line(context, [px, top], [px, bottom]);
  context.stroke();
  context.setLineDash([]);
}

/** @param {CanvasRenderingContext2D} context @param {number} px @param {number} top @param {number} bottom */
export function drawCursorLine(context, px, top, bottom) {
  context.globalAlpha = 0.55;
  drawUpright(context, px, { top, bottom }, { token: '--ink', width: 1 });
  context.globalAlpha = 1;
}

/** The value at the cursor, unless it is outside. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {number} px @param {number} py @param {string} token */
export function drawCursorDot(context, frame, px, py, token) {
  if (!(py >= frame.top - 1 && py <= frame.bottom + 1)) return;
  context.lineWidth = 2;
  context.strokeStyle = colour('--paper');
  context.fillStyle = colour(token);
  circle(context, px, py, 5);
  context.fill();
  context.stroke();
}

/** A line of one sample. @param {CanvasRenderingContext2D} context @param {number} px @param {number} py @param {string} token */
export function drawDot(context, px, py, token) {
  if (!Number.isFinite(py)) return;
  context.fillStyle = colour(token);
  circle(context, px, py, 3.5);
  context.fill();
}
