// V and V̇ against time: the lines on one canvas, redrawn when they change; the cursor, which is the robots' clock, on another.
/** @import { Experiment, Stability } from '../../../core/engine.js' */
/** @import { Axes } from '../../../kit/chart.js' */
/** @import { Layout } from './layout.js' */
import { createLayer } from '../../../kit/canvas.js';
import {
  drawCursorDot,
  drawCursorLine,
  drawGrid,
  line,
  pointsOf,
  through,
  within,
} from '../../../kit/chart.js';
import { drawTimeAxis, timeTicks } from '../axes.js';
import { linesOf } from '../plots.js';
import { createReady } from '../ready.js';
import { outlineOf } from '../../../kit/extent.js';
import { symbolFont, textFont } from '../../../kit/fonts.js';
import { styles } from '../../../run/pins.js';
import { drawMark } from '../../../kit/swatch.js';
import { sampleBefore } from '../../../lab/track.js';
import { colour } from '../../../kit/palette.js';
import { watch } from '../../../kit/memo.js';
import words from './words/index.js';
import { drawnOf, layoutOf, rangeOf } from './layout.js';
import { risesOf } from './summary.js';

/**
 * @typedef {object} StabilityModel
 * @property {Stability} driving
 * @property {Experiment['law']} law
 * @property {Stability} comparison
 * @property {import('../../../run/pins.js').Pins} pins
 * @property {readonly Stability[]} pinned One for each pin.
 * @property {boolean} isLog
 * @property {number} time
 * @property {{ width: number, height: number }} size
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

/** @param {{ lines: HTMLCanvasElement, cursor: HTMLCanvasElement }} elements */
export function createPlots({ lines, cursor }) {
  const under = createLayer(lines);
  const over = createLayer(cursor);
  const linesChanged = watch();
  const cursorChanged = watch();
  /** @type {Layout | null} */
  let layout = null;
  return {
    /** @param {StabilityModel} model */
    draw(model) {
      const { driving, law, comparison, pinned, isLog, time, size, theme } = model;
      if (size.width === 0) return;
      curvesReady([driving, comparison, ...pinned]);
      (isLog ? rateReadyOnLog : rateReadyOnEven)([driving]);
      if (linesChanged(driving, law, comparison, pinned, isLog, size, theme) || !layout) {
        layout = layoutOf(size, driving, [comparison, ...pinned], isLog);
        const drawn = layout;
        under.draw(size, (context) => {
          drawLyapunov(context, drawn, model);
          drawRate(context, drawn, driving);
          drawTimeAxis(context, drawn.time, drawn.rate.frame.bottom);
        });
      }
      if (cursorChanged(layout, time)) {
        const drawn = layout;
        over.draw(size, (context) => drawCursor(context, drawn, driving, time));
      }
    },
    /** The time at a place of the picture. @param {number} px */
    timeAt: (px) => layout?.time.invert(px) ?? 0,
  };
}

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {StabilityModel} model */
function drawLyapunov(context, { lyapunov: axes, isLog }, model) {
  const { driving, law } = model;
  const ticks = isLog ? decadesOf(axes) : ticksOf(axes);
  drawGrid(
    context,
    axes,
    { x: timeTicks(axes.x), y: ticks },
    ticks.map((tick) => words.tickText(tick, isLog)),
  );
  within(context, axes.frame, () => {
    drawLimited(context, axes, driving);
    for (const { run, colour: own, dash, width, slot } of linesOf(model)) {
      context.lineWidth = width;
      context.setLineDash([...dash]);
      context.strokeStyle = own ?? colour('--ink');
      context.beginPath();
      through(context, pointsOf(axes, run.time, run.lyapunov));
      context.stroke();
      const last = run.time.length - 1;
      if (slot !== null)
        drawMark(context, styles[slot].mark, axes.x(run.time[last]), axes.y(run.lyapunov[last]), {
          fill: String(own),
          edge: colour('--paper'),
        });
    }
    drawRises(context, axes, driving);
  });
  drawTitle(context, axes, words.lyapunovFormula(law, driving.headingWeight !== null));
  drawName(context, axes, driving.lyapunov[driving.time.length - 1]);
}

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Stability} driving */
function drawRate(context, { rate: axes, isLog }, driving) {
  const { rate, promised, areas } = drawnOf(driving, isLog);
  const { frame, y: scale } = axes;
  const ticks = ticksOf(axes);
  drawGrid(
    context,
    axes,
    { x: timeTicks(axes.x), y: ticks },
    ticks.map((tick) => words.tickText(tick, false)),
  );
  within(context, axes.frame, () => {
    for (const { token, from, to } of areas) {
      const outer = pointsOf(axes, driving.time, to);
      context.beginPath();
      through(context, [...outer, ...pointsOf(axes, driving.time, from).reverse()]);
      context.globalAlpha = 0.28;
      context.fillStyle = colour(token);
      context.fill();
      context.globalAlpha = 1;
      context.strokeStyle = colour(token);
      context.lineWidth = 1;
      context.setLineDash([]);
      context.beginPath();
      through(context, outer);
      context.stroke();
    }
    drawLimited(context, axes, driving);
    context.strokeStyle = colour('--muted');
    context.lineWidth = 1;
    context.beginPath();
    line(context, [frame.left, scale(0)], [frame.right, scale(0)]);
    context.stroke();
    context.setLineDash([4, 3]);
    context.beginPath();
    if (areas.length > 0) through(context, pointsOf(axes, driving.time, promised));
    context.stroke();
    context.setLineDash([]);
    context.strokeStyle = colour('--ink');
    context.lineWidth = 2.25;
    context.beginPath();
    through(context, pointsOf(axes, driving.time, rate));
    context.stroke();
  });
  drawName(context, axes, rate[driving.time.length - 1], isLog ? words.relative : '');
}

/** Where the limits cut the command. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Stability} driving */
function drawLimited(context, { x: across, frame }, { time, limited }) {
  context.fillStyle = colour('--ink');
  context.globalAlpha = 0.06;
  for (let from = 0; from < time.length; from += 1) {
    if (!limited[from]) continue;
    let to = from;
    while (to + 1 < time.length && limited[to]) to += 1;
    const [left, right] = [across(time[from]), across(time[to])];
    context.fillRect(left, frame.top, Math.max(0, right - left), frame.bottom - frame.top);
    from = to;
  }
  context.globalAlpha = 1;
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

/** @param {Axes} axes */
const ticksOf = ({ frame, y: scale }) =>
  scale.ticks(Math.max(2, Math.floor((frame.bottom - frame.top) / 30)));

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

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {string} text */
function drawTitle(context, { frame }, text) {
  context.font = textFont;
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillStyle = colour('--muted');
  context.fillText(text, frame.left, frame.top - 6);
}

/** V at the end of its line, or V with a dot. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number} end @param {string} [after] What follows V with a dot. */
function drawName(context, { frame, y: scale }, end, after) {
  const half = 10;
  const px = frame.right + 8;
  const wanted = Number.isFinite(end) ? scale(end) : frame.top;
  const py = Math.min(Math.max(wanted, frame.top + half), frame.bottom - half);
  const letter = words.lyapunovSymbol;
  context.font = symbolFont;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  context.fillStyle = colour('--ink');
  context.fillText(letter, px, py);
  if (after === undefined) return;
  const { width, actualBoundingBoxAscent: ascent } = context.measureText(letter);
  context.fillText(after, px + width, py);
  // Not every font puts a dot over its letter.
  context.beginPath();
  context.arc(px + 0.6 * width, py - ascent - 2.5, 1.3, 0, 2 * Math.PI);
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
