// Runs against time: the lines on one canvas, redrawn when they change; the cursor, which is the robots' clock, on another.
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Pins } from '../../run/pins.js' */
/** @import { Column, Layout, Plot, PlotName } from './layout.js' */
import { createLayer } from '../../kit/canvas.js';
import { outlineOf } from '../../kit/extent.js';
import { drawMark } from '../../kit/swatch.js';
import { styles } from '../../run/pins.js';
import { sampleBefore } from '../../lab/track.js';
import {
  drawCursorDot,
  drawCursorLine,
  drawGrid,
  line,
  pointsOf,
  sameDigits,
  through,
  within,
} from '../../kit/chart.js';
import { colour } from '../../kit/palette.js';
import { rememberEach, watch } from '../../kit/memo.js';
import words from './words/index.js';
import { drawTimeAxis, timeTicks } from './axes.js';
import { curvesOf, extentsOf, layoutOf } from './layout.js';
import { drawNames, parts, tokens } from './plot-names.js';
import { createReady } from './ready.js';

/** @template [R=Run] @typedef {{ run: R, colour: string | null, dash: readonly number[], width: number, slot: number | null }} Line Without a colour: that of what is drawn. */
/**
 * @typedef {object} PlotsModel
 * @property {Run} driving
 * @property {Run} comparison
 * @property {Pins} pins
 * @property {Run[]} pinned One for each pin.
 * @property {Experiment['limits']} limits
 * @property {boolean} isFigure Whether the paper has a figure of it.
 * @property {number} time
 * @property {{ width: number, height: number }} size
 * @property {number} theme
 */

/** What was asked for where the limits gave less, and elsewhere what they gave. @param {Float64Array} asked @param {Float64Array} given */
const cut = (asked, given) => asked.map((value, i) => (Math.abs(value - given[i]) > 1e-9 ? value : given[i]));
/** What the velocity limits cut. @type {Readonly<Partial<Record<PlotName, Column>>>} */
const commands = {
  linear: rememberEach((run) => cut(run.commandLinear, run.linear)),
  angular: rememberEach((run) => cut(run.commandAngular, run.angular)),
};
/** The curves of all runs. */
const curvesReady = createReady((/** @type {Run} */ run) =>
  Object.values(extentsOf).map((extent) => () => extent(run)),
);
/** What the run on screen has besides. */
const partsReady = createReady((/** @type {Run} */ run) =>
  [...parts.map(([, , column]) => column), ...Object.values(commands)].map(
    (column) => () => outlineOf(column(run)),
  ),
);

/** @param {{ lines: HTMLCanvasElement, cursor: HTMLCanvasElement }} elements */
export function createPlots({ lines, cursor }) {
  const under = createLayer(lines);
  const over = createLayer(cursor);
  const linesChanged = watch();
  const cursorChanged = watch();
  /** @type {Layout | null} */
  let layout = null;
  return {
    /** @param {PlotsModel} model */
    draw(model) {
      const { driving, comparison, pinned, limits, isFigure, time, size, theme } = model;
      if (size.width === 0) return;
      curvesReady([driving, comparison, ...pinned]);
      partsReady([driving]);
      if (linesChanged(driving, comparison, pinned, limits, isFigure, size, theme) || !layout) {
        layout = layoutOf(size, driving, [comparison, ...pinned], limits, isFigure);
        const { time: scale, plots } = layout;
        const drawn = layout;
        under.draw(size, (context) => {
          for (const plot of plots) drawPlot(context, drawn, plot, model);
          drawTimeAxis(context, scale, plots[plots.length - 1].frame.bottom);
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

/**
 * The runs in the order in which they are drawn.
 * @template R @param {{ driving: R, comparison: R, pins: Pins, pinned: readonly R[] }} model @returns {Line<R>[]}
 */
export const linesOf = ({ driving, comparison, pins, pinned }) => [
  { run: comparison, colour: colour('--muted'), dash: [2, 4], width: 1.75, slot: null },
  ...pins.map(({ slot }, i) => ({
    run: pinned[i],
    colour: colour(styles[slot].token),
    dash: styles[slot].dash,
    width: 1.75,
    slot,
  })),
  { run: driving, colour: null, dash: [], width: 2.25, slot: null },
];

/** @param {Layout} layout @param {Plot} plot */
const axesOf = ({ time }, { scale, frame }) => ({ x: time, y: scale, frame });

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {PlotsModel} model */
function drawPlot(context, layout, plot, model) {
  const { frame, name } = plot;
  const ticks = plot.scale.ticks(Math.max(2, Math.floor((frame.bottom - frame.top) / 30)));
  const texts = sameDigits(ticks).map((text) => words.tickText(name, text));
  drawGrid(context, axesOf(layout, plot), { x: timeTicks(layout.time), y: ticks }, texts);
  drawLimits(context, plot);
  within(context, frame, () => {
    if (name === 'cost') drawParts(context, layout, plot, model.driving);
    drawCommand(context, layout, plot, model.driving);
    for (const line of linesOf(model)) drawLine(context, layout, plot, line);
  });
  drawNames(context, plot, model.driving);
}

/** @param {CanvasRenderingContext2D} context @param {Plot} plot */
function drawLimits(context, { frame, scale, limit }) {
  if (limit === null) return;
  context.strokeStyle = colour('--muted');
  context.setLineDash([3, 3]);
  context.beginPath();
  const [low, high] = scale.domain();
  for (const value of [-limit, limit].filter((one) => one > low && one < high))
    line(context, [frame.left, scale(value)], [frame.right, scale(value)]);
  context.stroke();
  context.setLineDash([]);
}

/** One run in one plot. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Line} line */
function drawLine(context, layout, plot, { run, colour: own, dash, width, slot }) {
  context.lineWidth = width;
  context.setLineDash([...dash]);
  for (const [i, column] of curvesOf[plot.name].entries()) {
    context.strokeStyle = own ?? colour(tokens[plot.name][i]);
    context.beginPath();
    trace(context, layout, plot, run, column);
    context.stroke();
    if (slot === null) continue;
    const last = run.time.length - 1;
    drawMark(context, styles[slot].mark, layout.time(run.time[last]), plot.scale(column(run)[last]), {
      fill: String(own),
      edge: colour('--paper'),
    });
  }
}

/** A velocity is applied until the next sample, everything else changes on the way. @param {PlotName} name */
const isHeld = (name) => name in commands;

/** Adds a curve to the path. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Run} run @param {Column} column */
function trace(context, layout, plot, run, column) {
  through(context, pointsOf(axesOf(layout, plot), run.time, column(run), isHeld(plot.name)));
}

/** What the law asked for, where the limits gave less. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Run} run */
function drawCommand(context, layout, plot, run) {
  const command = commands[plot.name];
  if (!command) return;
  context.strokeStyle = colour(tokens[plot.name][0]);
  context.globalAlpha = 0.45;
  context.lineWidth = 1.25;
  context.setLineDash([]);
  context.beginPath();
  trace(context, layout, plot, run, command);
  context.stroke();
  context.globalAlpha = 1;
}

/** J in its parts, each on top of the one before; what is due at the end stands at the end. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Run} run */
function drawParts(context, layout, plot, run) {
  const { time } = layout;
  const { scale, frame } = plot;
  const last = run.time.length - 1;
  for (const [i, [, token, column]] of [...parts.entries()].reverse()) {
    context.beginPath();
    trace(context, layout, plot, run, column);
    context.lineTo(time(run.time[last]), frame.bottom);
    context.lineTo(frame.left, frame.bottom);
    // Its own colour, without what shines through from the part above.
    context.fillStyle = colour('--paper');
    context.fill();
    context.globalAlpha = 0.28;
    context.fillStyle = colour(token);
    context.fill();
    context.globalAlpha = 1;
    if (i === parts.length - 1) continue;
    context.strokeStyle = colour(token);
    context.lineWidth = 1;
    context.setLineDash([]);
    context.beginPath();
    trace(context, layout, plot, run, column);
    context.stroke();
  }
  let paid = parts[parts.length - 1][2](run)[last];
  for (const [token, due] of /** @type {const} */ ([
    ['--final', run.cost.finalError],
    ['--error', run.cost.penalty],
  ])) {
    if (!(due > 0)) continue;
    context.fillStyle = colour(token);
    const top = Math.max(frame.top, scale(Math.min(paid + due, 1e9)));
    context.fillRect(time(run.time[last]) - 2, top, 4, Math.max(0, scale(paid) - top));
    paid += due;
  }
}

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Run} run @param {number} now */
function drawCursor(context, { time, plots }, run, now) {
  const i = sampleBefore(run, now);
  const px = time(run.time[i]);
  drawCursorLine(context, px, plots[0].frame.top, plots[plots.length - 1].frame.bottom);
  for (const { name, frame, scale } of plots)
    for (const [curve, column] of curvesOf[name].entries())
      drawCursorDot(context, frame, px, scale(column(run)[i]), tokens[name][curve]);
}
