// V and V̇ against time: what is drawn of them, and the cursor in it.
/** @import { Experiment, Stability } from '../../../core/engine.js' */
/** @import { Axes } from '../../../kit/chart.js' */
/** @import { Plots } from '../picture.js' */
/** @import { Layout } from './layout.js' */
import { circle } from '../../../kit/canvas.js';
import {
  drawBand,
  drawCursorDot,
  drawCursorLine,
  drawGrid,
  line,
  pointsOf,
  strokeThrough,
  take,
  within,
} from '../../../kit/chart.js';
import { drawTimeAxis, ticksUp, timeTicks } from '../axes.js';
import { drawPinMark, linesOf } from '../plots.js';
import { createReady } from '../ready.js';
import { outlineOf } from '../../../kit/extent.js';
import { symbolFont } from '../../../kit/lettering.js';
import { drawText } from '../../drawing.js';
import { sampleBefore } from '../../../lab/track.js';
import { colour } from '../../../kit/palette.js';
import words from './words/index.js';
import { drawnOf, layoutOf, rangeOf } from './layout.js';
import { drawPartNames } from './part-names.js';
import { risesOf } from './summary.js';

/**
 * @typedef {object} StabilityModel
 * @property {Stability} driving
 * @property {Experiment['law']} law
 * @property {Stability} comparison
 * @property {import('../../../run/pins.js').Pins} pins
 * @property {readonly Stability[]} pinned One for each pin.
 * @property {boolean} isLog
 * @property {number} theme
 */

const curvesReady = createReady((/** @type {Stability} */ run) => [
  () => rangeOf(run),
  () => outlineOf(run.lyapunov),
]);
const rateReady = (/** @type {boolean} */ isLog) =>
  createReady(function* (/** @type {Stability} */ run) {
    yield () => drawnOf(run, isLog);
    const { rate, promised, areas } = drawnOf(run, isLog);
    for (const column of [rate, promised, ...areas.flatMap(({ from, to }) => [from, to])])
      yield () => outlineOf(column);
  });
const [rateReadyOnEven, rateReadyOnLog] = [false, true].map(rateReady);

/** @type {Plots<StabilityModel, Layout>} */
export const plotsOfStability = {
  makeReady({ driving, comparison, pinned, isLog }) {
    curvesReady([driving, comparison, ...pinned]);
    (isLog ? rateReadyOnLog : rateReadyOnEven)([driving]);
  },
  layoutOf: (size, { driving, comparison, pinned, isLog }) =>
    layoutOf(size, driving, [comparison, ...pinned], isLog),
  drawLines(context, layout, model) {
    drawLyapunov(context, layout, model);
    drawRate(context, layout, model.driving);
    drawTimeAxis(context, layout.time, layout.rate.frame.bottom);
  },
  drawCursor: (context, layout, { driving }, time) => drawCursor(context, layout, driving, time),
};

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {StabilityModel} model */
function drawLyapunov(context, { lyapunov: axes, isLog }, model) {
  const { driving, law } = model;
  drawTicks(context, axes, isLog);
  within(context, axes.frame, () => {
    drawLimited(context, axes, driving, 3);
    for (const { run, token, dash, width, slot } of linesOf(model)) {
      strokeThrough(context, pointsOf(axes, run.time, run.lyapunov), {
        token: token ?? '--ink',
        width,
        dash,
      });
      const last = run.time.length - 1;
      if (slot !== null) drawPinMark(context, slot, axes.x(run.time[last]), axes.y(run.lyapunov[last]));
    }
    drawRises(context, axes, driving);
  });
  const title = words.lyapunovFormula(law, driving.headingWeight !== null);
  drawText(context, title, axes.frame.left, axes.frame.top - 6, { baseline: 'alphabetic' });
  drawName(context, axes, driving.lyapunov[driving.time.length - 1]);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {boolean} isLog */
function drawTicks(context, axes, isLog) {
  const ticks = isLog ? decadesOf(axes) : ticksUp(axes);
  const texts = ticks.map((tick) => words.tickText(tick, isLog));
  drawGrid(context, axes, { x: timeTicks(axes.x), y: ticks }, texts);
}

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Stability} driving */
function drawRate(context, { rate: axes, isLog }, driving) {
  const { rate, promised, areas } = drawnOf(driving, isLog);
  const { frame, y: scale } = axes;
  drawTicks(context, axes, false);
  within(context, axes.frame, () => {
    for (const { token, from, to } of areas) {
      const outer = pointsOf(axes, driving.time, to);
      drawBand(context, outer, pointsOf(axes, driving.time, from), token, 0.28);
      strokeThrough(context, outer, { token, width: 1 });
    }
    drawLimited(context, axes, driving);
    take(context, { token: '--muted', width: 1 });
    context.beginPath();
    line(context, [frame.left, scale(0)], [frame.right, scale(0)]);
    context.stroke();
    if (areas.length > 0)
      strokeThrough(context, pointsOf(axes, driving.time, promised), {
        token: '--muted',
        width: 1,
        dash: [4, 3],
      });
    strokeThrough(context, pointsOf(axes, driving.time, rate), { token: '--ink', width: 2.25 });
  });
  drawPartNames(context, axes, driving.time, areas);
  drawName(context, axes, rate[driving.time.length - 1], isLog ? words.relative : '');
}

/** Where the limits cut the command: grey, and above V a bar, for grey so pale is lost on a projector. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Stability} driving @param {number} [bar] */
function drawLimited(context, { x: across, frame }, { time, limited }, bar = 0) {
  for (let from = 0; from < time.length; from += 1) {
    if (!limited[from]) continue;
    let to = from;
    while (to + 1 < time.length && limited[to]) to += 1;
    const [left, right] = [across(time[from]), across(time[to])];
    const wide = Math.max(0, right - left);
    context.globalAlpha = 0.06;
    context.fillStyle = colour('--ink');
    context.fillRect(left, frame.top, wide, frame.bottom - frame.top);
    context.globalAlpha = 1;
    context.fillStyle = colour('--muted');
    context.fillRect(left, frame.top, wide, bar);
    from = to;
  }
}

/** Where V rises, over its line, and below it, where a short rise is seen, too. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Stability} driving */
function drawRises(context, { x: across, y: scale, frame }, driving) {
  const { time, lyapunov } = driving;
  const isRising = risesOf(driving);
  context.strokeStyle = colour('--error');
  context.lineWidth = 3.5;
  context.beginPath();
  for (let i = 0; i + 1 < time.length; i += 1) {
    if (!isRising(i)) continue;
    if (i === 0 || !isRising(i - 1)) context.moveTo(across(time[i]), scale(lyapunov[i]));
    context.lineTo(across(time[i + 1]), scale(lyapunov[i + 1]));
  }
  context.stroke();
  context.fillStyle = colour('--error');
  for (let i = 0; i + 1 < time.length; i += 1)
    if (isRising(i)) context.fillRect(across(time[i]) - 1, frame.bottom - 7, 2, 7);
}

/** Powers of ten, not too close; where there are hardly any, 1, 2 and 5 times each. @param {Axes} axes */
function decadesOf({ frame, y: scale }) {
  const [from, to] = scale.domain();
  const [low, high] = [Math.log10(from), Math.log10(to)];
  const every = Math.max(1, Math.ceil(((high - low) * 22) / (frame.bottom - frame.top)));
  const first = Math.floor(low / every) * every;
  const powers = Array.from(
    { length: Math.ceil((high - first) / every) },
    (_, i) => 10 ** (first + i * every),
  );
  const factors = high - low < 2 ? [1, 2, 5] : [1];
  return powers
    .flatMap((power) => factors.map((factor) => factor * power))
    .filter((tick) => tick >= from && tick <= to);
}

/** V at the end of its line, or V with a dot. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number} end @param {string} [after] What follows V with a dot. */
function drawName(context, { frame, y: scale }, end, after) {
  const half = 10;
  const px = frame.right + 8;
  const wanted = Number.isFinite(end) ? scale(end) : frame.top;
  const py = Math.min(Math.max(wanted, frame.top + half), frame.bottom - half);
  const letter = words.lyapunovSymbol;
  drawText(context, letter, px, py, { font: symbolFont, token: '--ink' });
  if (after === undefined) return;
  const { width, actualBoundingBoxAscent: ascent } = context.measureText(letter);
  context.fillText(after, px + width, py);
  // Not every font puts a dot over its letter.
  circle(context, px + 0.6 * width, py - ascent - 2.5, 1.3);
  context.fill();
}

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Stability} driving @param {number} now */
function drawCursor(context, { time, lyapunov, rate, isLog }, driving, now) {
  const i = sampleBefore(driving, now);
  const px = time(driving.time[i]);
  drawCursorLine(context, px, lyapunov.frame.top, rate.frame.bottom);
  const drawn = drawnOf(driving, isLog);
  drawCursorDot(context, lyapunov.frame, px, lyapunov.y(driving.lyapunov[i]), '--ink');
  for (const { token, to } of drawn.areas) drawCursorDot(context, rate.frame, px, rate.y(to[i]), token);
  drawCursorDot(context, rate.frame, px, rate.y(drawn.rate[i]), '--ink');
}
