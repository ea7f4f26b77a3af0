// What plots against time share: their axes, their lines, the cursor, and the pointer that moves it.
import { textFont } from '../../kit/fonts.js';
import { sameDigits } from '../../kit/plot.js';
import { colour } from '../../kit/palette.js';
import { curves as words } from '../../words/index.js';

/** @typedef {import('../../core/engine.js').Run} Run */
/** @typedef {import('d3-scale').ScaleContinuousNumeric<number, number>} Scale */
/** @typedef {{ left: number, right: number, top: number, bottom: number }} Frame */
/** @typedef {{ time: Scale, frame: Frame, scale: Scale }} Axes */
/** @typedef {(i: number) => number} Value At a sample. */

/** So many times as long as the run in question others may take before they leave the picture. */
const longest = 2;

/** The end of the time axis, in steps, so that it does not move at each generation. @param {Pick<Run, 'time'>} driving @param {readonly Pick<Run, 'time'>[]} others */
export function endOf(driving, others) {
  const own = driving.time[driving.time.length - 1];
  const last = Math.max(own, ...others.map(({ time }) => time[time.length - 1]));
  const end = Math.max(0.01, Math.min(last, longest * own));
  const step = [0.01, 0.05, 0.25, 0.5, 1, 5].find((one) => end / one <= 12) ?? 10;
  return Math.ceil(end / step - 1e-9) * step;
}

/** As many as there is room to name. @param {Scale} time */
function timeTicks(time) {
  const [left, right] = time.range();
  const count = [6, 4].find((most) => time.ticks(most).length * 36 <= right - left) ?? 2;
  return time.ticks(count);
}

/** A straight line on the pixels. @param {CanvasRenderingContext2D} context @param {readonly [number, number]} from @param {readonly [number, number]} to */
export function line(context, from, to) {
  context.moveTo(Math.round(from[0]) + 0.5, Math.round(from[1]) + 0.5);
  context.lineTo(Math.round(to[0]) + 0.5, Math.round(to[1]) + 0.5);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {readonly number[]} ticks @param {readonly string[]} texts */
export function drawGrid(context, { time, frame, scale }, ticks, texts) {
  context.font = textFont;
  context.fillStyle = colour('--muted');
  context.strokeStyle = colour('--hairline');
  context.lineWidth = 1;
  context.setLineDash([]);
  context.beginPath();
  for (const t of timeTicks(time)) line(context, [time(t), frame.top], [time(t), frame.bottom]);
  for (const tick of ticks) line(context, [frame.left, scale(tick)], [frame.right, scale(tick)]);
  context.stroke();
  context.textAlign = 'right';
  context.textBaseline = 'middle';
  for (const [i, tick] of ticks.entries()) context.fillText(texts[i], frame.left - 6, scale(tick));
}

/** @param {CanvasRenderingContext2D} context @param {Scale} time @param {number} bottom */
export function drawTimeAxis(context, time, bottom) {
  const ticks = timeTicks(time);
  const texts = sameDigits(/** @type {any} */ (null), ticks);
  context.font = textFont;
  context.fillStyle = colour('--muted');
  context.textAlign = 'center';
  context.textBaseline = 'top';
  for (const [i, t] of ticks.entries()) context.fillText(words.seconds(texts[i]), time(t), bottom + 7);
}

/**
 * Where a curve goes, without the steps too small to see; it ends where it is no number.
 * @param {Axes} axes @param {ArrayLike<number>} times @param {Value} value @param {boolean} [isHeld] until the next sample
 */
export function pointsOf({ time, frame, scale }, times, value, isHeld = false) {
  const least = 0.5;
  const last = times.length - 1;
  const height = frame.bottom - frame.top;
  // A canvas draws nothing of what is too far outside.
  const inside = (/** @type {number} */ py) =>
    Math.min(Math.max(py, frame.top - 3 * height), frame.bottom + 3 * height);
  let [fromX, fromY] = [time(0), inside(scale(value(0)))];
  /** @type {[number, number][]} */
  const points = [[fromX, fromY]];
  for (let i = 1; i <= last; i += 1) {
    const [px, py] = [time(times[i]), inside(scale(value(i)))];
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

/** @param {CanvasRenderingContext2D} context @param {number} px @param {number} top @param {number} bottom */
export function drawCursorLine(context, px, top, bottom) {
  context.strokeStyle = colour('--ink');
  context.globalAlpha = 0.55;
  context.lineWidth = 1;
  context.beginPath();
  line(context, [px, top], [px, bottom]);
  context.stroke();
  context.globalAlpha = 1;
}

/** The value at the cursor, unless it is outside. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {number} px @param {number} py @param {string} token */
export function drawCursorDot(context, frame, px, py, token) {
  if (!(py >= frame.top - 1 && py <= frame.bottom + 1)) return;
  context.lineWidth = 2;
  context.strokeStyle = colour('--paper');
  context.fillStyle = colour(token);
  context.beginPath();
  context.arc(px, py, 5, 0, 2 * Math.PI);
  context.fill();
  context.stroke();
}

/** The time of the sample next to a time. @param {Pick<Run, 'time'>} run @param {number} time */
export function sampleTime({ time: samples }, time) {
  const last = samples.length - 1;
  if (last < 1) return 0;
  return samples[Math.min(last, Math.max(0, Math.round(time / samples[1])))];
}

/** The mouse over a picture, or a finger or the mouse that drags on it. @param {HTMLElement} element @param {(px: number) => void} onPoint */
export function followPointer(element, onPoint) {
  const point = (/** @type {PointerEvent} */ event) =>
    onPoint(event.clientX - element.getBoundingClientRect().left);
  element.addEventListener('pointerdown', (event) => {
    if (event.button !== 0) return;
    element.setPointerCapture(event.pointerId);
    point(event);
  });
  element.addEventListener('pointermove', (event) => {
    if (event.pointerType !== 'touch' || element.hasPointerCapture(event.pointerId)) point(event);
  });
}
