// The three parts of the error over time: what is measured on one canvas, the robots' clock on another.
/** @import { Size } from '../../kit/canvas.js' */
/** @import { ErrorParts, Measured } from './request.js' */
/** @import { PartName } from './summary.js' */
import { scaleLinear, scaleSymlog } from 'd3-scale';
import { createWatchedLayer, fillTextWithHalo } from '../../kit/canvas.js';
import {
  drawCursorDot,
  drawCursorLine,
  line,
  pointsOf,
  strokeThrough,
  take,
  through,
} from '../../kit/chart.js';
import { followSize } from '../../kit/size.js';
import { largest } from '../../kit/extent.js';
import { setLettering } from '../../kit/lettering.js';
import { colour, pale } from '../../kit/palette.js';
import { sampleBefore } from '../../lab/track.js';
import { typed } from '../../words/numbers.js';
import { numbersApart } from '../drawing.js';
import words from './words/index.js';
import { arePositive, parts } from './summary.js';

/** @typedef {{ measured: Measured, time: number, theme: number }} PlotsModel */
/** @typedef {ReturnType<typeof axesOf>} Axes */

const margin = { left: 44, right: 8, top: 5 };
/** Below this the axis is nearly even, above it nearly logarithmic. */
const evenUpTo = 0.01;
const decades = [0, 0.01, 0.1, 1, 10, 100, 1000];
const labelHeight = 15;

/** @param {HTMLElement} element @param {() => void} onResize */
export function createPlots(element, onResize) {
  const roots = /** @type {NodeListOf<HTMLElement>} */ (element.querySelectorAll('.remains-plot'));
  const plots = parts.map((part, i) => createPlot(part, roots[i], onResize));
  return {
    /** @param {PlotsModel} model */
    draw(model) {
      const { runs } = model.measured;
      const most = Math.max(3, ...runs.flatMap((run) => [run.x[0], run.y[0]]));
      for (const plot of plots) plot.draw(model, most);
    },
  };
}

/** @param {PartName} part @param {HTMLElement} root @param {() => void} onResize */
function createPlot(part, root, onResize) {
  const [lines, clock] = Array.from(root.querySelectorAll('canvas'), createWatchedLayer);
  const isLast = part === 'theta';
  const sizeOf = followSize(root, onResize);
  return {
    /** @param {PlotsModel} model @param {number} most The largest distance on the axis. */
    draw({ measured, time, theme }, most) {
      const size = sizeOf();
      if (size.width === 0) return;
      const axes = axesOf(measured, size, part === 'theta' ? 1 : most, isLast);
      lines(size, [measured, most, theme], (context) => drawLines(context, axes, measured, part, isLast));
      clock(size, [measured, most, theme, time], (context) =>
        drawClock(context, axes, measured.runs[0], part, time),
      );
    },
  };
}

/** @param {Measured} measured @param {Size} size @param {number} most @param {boolean} isLast */
function axesOf({ spec }, { width, height }, most, isLast) {
  const frame = {
    ...margin,
    right: width - margin.right,
    bottom: height - (isLast ? 22 : 5),
  };
  const { horizon } = spec.experiment;
  return {
    frame,
    horizon,
    x: scaleLinear([0, horizon], [frame.left, frame.right]),
    /** What lies beyond the axis is drawn at its end. */
    y: scaleSymlog([0, most], [frame.bottom, frame.top]).constant(evenUpTo).clamp(true),
  };
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Measured} measured @param {PartName} part @param {boolean} isLast */
function drawLines(context, axes, measured, part, isLast) {
  const { spec, runs } = measured;
  const { frame } = axes;
  const since = axes.x(axes.horizon - spec.seconds);
  context.fillStyle = colour('--panel');
  context.fillRect(since, frame.top, frame.right - since, frame.bottom - frame.top);
  const { law } = spec.experiment;
  const hasSet = words.isPromised({ law, isPositive: arePositive(spec.gains) });
  drawAxes(context, axes, hasSet ? measured.disturbed.sets[part][0] : 0, isLast);
  if (hasSet) drawSet(context, axes, measured, part);

  context.lineJoin = 'round';
  context.strokeStyle = colour('--muted');
  context.lineWidth = 1;
  context.globalAlpha = pale;
  context.beginPath();
  for (const run of runs.slice(1)) trace(context, axes, ...crests(run.time, run[part]));
  context.stroke();
  context.globalAlpha = 1;
  strokeThrough(context, pointsOf(axes, runs[0].time, runs[0][part]), { token: '--ink', width: 2 });
  if (part === 'x') nameLast(context, frame, since, words.lastText(spec.seconds));
}

/** What the last seconds are called, in their band. @param {CanvasRenderingContext2D} context @param {Axes['frame']} frame @param {number} since @param {string} text */
function nameLast(context, { right, top }, since, text) {
  context.textAlign = 'center';
  context.textBaseline = 'top';
  // Narrow, it would be cut at the edge.
  const half = context.measureText(text).width / 2;
  const px = Math.min((since + right) / 2, right - half - 2);
  fillTextWithHalo(context, text, px, top + 2, {
    fill: colour('--muted'),
    halo: colour('--panel'),
    width: 3,
  });
}

/** Where the numbers of an axis stand: that of the bound first, and no two on each other. @param {Axes} axes @param {number} bound @returns {{ text: string, place: number }[]} */
function numbersOf({ y, frame }, bound) {
  const most = y.domain()[1];
  const isSmall = bound > most || Number(typed(bound, 3)) === 0;
  const wanted = [...(isSmall ? [] : [bound]), ...decades.filter((one) => one <= most)];
  /** @type {{ text: string, place: number }[]} */
  const numbers = [];
  for (const value of wanted) {
    const place = Math.max(frame.top + 5, Math.min(y(value), frame.bottom - 5));
    if (numbers.every((other) => Math.abs(other.place - place) >= labelHeight))
      numbers.push({ text: value > 0 && value === bound ? typed(bound, 3) : String(value), place });
  }
  return numbers;
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number} bound Of the set. @param {boolean} isLast With the numbers of time. */
function drawAxes(context, axes, bound, isLast) {
  const { frame } = axes;
  setLettering(context, { align: 'right' });
  take(context, { token: '--hairline', width: 1 });
  context.beginPath();
  for (const value of decades.filter((one) => one <= axes.y.domain()[1])) {
    line(context, [frame.left, axes.y(value)], [frame.right, axes.y(value)]);
  }
  for (const { text, place } of numbersOf(axes, bound)) context.fillText(text, frame.left - 6, place);
  context.textAlign = 'center';
  const most = frame.right - frame.left < 200 ? 2 : 5;
  // The last one stands within the edge, up to half of its width nearer to the others.
  const halfOf = (/** @type {string} */ text) => context.measureText(text).width / 2;
  for (const { tick, text } of numbersApart(axes.x, most, words.timeTicks, (text) => 3 * halfOf(text))) {
    const px = axes.x(tick);
    line(context, [px, frame.top], [px, frame.bottom]);
    const last = frame.right - Math.max(8, halfOf(text) - margin.right);
    if (isLast) context.fillText(text, Math.min(Math.round(px) + 0.5, last), frame.bottom + 12);
  }
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Measured} measured @param {PartName} part */
function drawSet(context, axes, measured, part) {
  const { frame } = axes;
  const reach = measured.disturbed.sets[part][0];
  context.fillStyle = colour(`--${part}`);
  context.strokeStyle = colour(`--${part}`);
  context.lineWidth = 1.5;
  context.setLineDash([5, 4]);
  context.beginPath();
  if (part === 'y') trace(context, axes, ...edgeOf(measured));
  else {
    context.moveTo(frame.left, axes.y(reach));
    context.lineTo(frame.right, axes.y(reach));
  }
  context.stroke();
  context.setLineDash([]);
  context.lineTo(frame.right, frame.bottom);
  context.lineTo(frame.left, frame.bottom);
  context.globalAlpha = 0.14;
  context.fill();
  context.globalAlpha = 1;
}

/** The set of y over time: as it is, but where it trembles. @param {Pick<Measured, 'spec' | 'runs'>} measured @returns {[ArrayLike<number>, ArrayLike<number>]} */
export function edgeOf({ spec, runs: [{ time, ySet }] }) {
  return spec.experiment.disturbance.kind === 'random' ? crests(time, ySet) : [time, ySet];
}

/** The largest of each fifth of a second, because what trembles would hide the rest; what is left at the end is no shorter. @param {Float64Array} times @param {Float64Array} sizes @returns {[number[], number[]]} */
export function crests(times, sizes) {
  const each = Math.max(1, Math.round(words.crestSeconds / (times[1] - times[0])));
  const last = times.length - 1;
  /** @type {[number[], number[]]} */
  const [crestTimes, crestSizes] = [[], []];
  for (let from = 0; from < last; from += each) {
    const first = Math.max(0, Math.min(from, last - each));
    crestTimes.push(times[from]);
    crestSizes.push(largest(sizes.subarray(first, first + each + 1)));
  }
  crestTimes.push(times[last]);
  crestSizes.push(crestSizes[crestSizes.length - 1]);
  return [crestTimes, crestSizes];
}

/** Adds a curve to the path. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {ArrayLike<number>} times @param {ArrayLike<number>} sizes */
const trace = (context, axes, times, sizes) => through(context, pointsOf(axes, times, sizes));

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {ErrorParts} run @param {PartName} part @param {number} time */
function drawClock(context, axes, run, part, time) {
  const { frame } = axes;
  const now = sampleBefore(run, time);
  const px = axes.x(Math.min(time, axes.horizon));
  drawCursorLine(context, px, frame.top, frame.bottom);
  drawCursorDot(context, frame, px, axes.y(run[part][now]), '--ink');
}
