// Runs against time: what is drawn of them, and the cursor in it.
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Pins } from '../../run/pins.js' */
/** @import { Column, Layout, Plot, PlotName } from './layout.js' */
/** @import { Plots } from './picture.js' */
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
  strokeThrough,
  take,
  through,
  within,
} from '../../kit/chart.js';
import { colour } from '../../kit/palette.js';
import { rememberEach } from '../../kit/memo.js';
import { sameDigits } from '../../kit/steps.js';
import words from './words/index.js';
import { drawTimeAxis, ticksUp, timeTicks } from './axes.js';
import { curvesOf, extentsOf, layoutOf } from './layout.js';
import { drawNames, drawNamesApart, parts, tokens, widestGap } from './plot-names.js';
import { createReady } from './ready.js';

/** @template [R=Run] @typedef {{ run: R, token: string | null, dash: readonly number[], width: number, slot: number | null }} Line Without a token: in the colour of what is drawn. */
/**
 * @typedef {object} PlotsModel
 * @property {Run} driving
 * @property {Run} comparison
 * @property {Pins} pins
 * @property {Run[]} pinned One for each pin.
 * @property {Experiment['limits']} limits
 * @property {boolean} isFigure Whether the paper has a figure of it.
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
const partsReady = createReady((/** @type {Run} */ run) => [
  () => widestGap(run),
  ...[...parts.map(([, , column]) => column), ...Object.values(commands)].map(
    (column) => () => outlineOf(column(run)),
  ),
]);

/** @type {Plots<PlotsModel, Layout>} */
export const plotsOverTime = {
  makeReady({ driving, comparison, pinned }) {
    curvesReady([driving, comparison, ...pinned]);
    partsReady([driving]);
  },
  layoutOf: (size, { driving, comparison, pinned, limits, isFigure }) =>
    layoutOf(size, driving, [comparison, ...pinned], limits, isFigure),
  drawLines(context, layout, model) {
    for (const plot of layout.plots) drawPlot(context, layout, plot, model);
    drawTimeAxis(context, layout.time, layout.plots[layout.plots.length - 1].frame.bottom);
  },
  drawCursor: (context, layout, { driving }, time) => drawCursor(context, layout, driving, time),
};

/**
 * The runs in the order in which they are drawn.
 * @template R @param {{ driving: R, comparison: R, pins: Pins, pinned: readonly R[] }} model @returns {Line<R>[]}
 */
export const linesOf = ({ driving, comparison, pins, pinned }) => [
  { run: comparison, token: '--muted', dash: [2, 4], width: 1.75, slot: null },
  ...pins.map(({ slot }, i) => ({
    run: pinned[i],
    token: styles[slot].token,
    dash: styles[slot].dash,
    width: 1.75,
    slot,
  })),
  { run: driving, token: null, dash: [], width: 2.25, slot: null },
];

/** @param {Layout} layout @param {Plot} plot */
const axesOf = ({ time }, { scale, frame }) => ({ x: time, y: scale, frame });

/** @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {PlotsModel} model */
function drawPlot(context, layout, plot, model) {
  const { frame, name } = plot;
  const axes = axesOf(layout, plot);
  const ticks = ticksUp(axes);
  const texts = sameDigits(ticks).map((text) => words.tickText(name, text));
  drawGrid(context, axes, { x: timeTicks(layout.time), y: ticks }, texts);
  drawLimits(context, plot);
  within(context, frame, () => {
    if (name === 'cost') drawParts(context, layout, plot, model.driving);
    drawCommand(context, layout, plot, model.driving);
    for (const line of linesOf(model)) drawLine(context, layout, plot, line);
  });
  drawNames(context, plot, model.driving);
  if (name === 'position') drawNamesApart(context, axes, model.driving);
}

/** @param {CanvasRenderingContext2D} context @param {Plot} plot */
function drawLimits(context, { frame, scale, limit }) {
  if (limit === null) return;
  take(context, { token: '--muted', width: 1, dash: [3, 3] });
  context.beginPath();
  const [low, high] = scale.domain();
  for (const value of [-limit, limit].filter((one) => one > low && one < high))
    line(context, [frame.left, scale(value)], [frame.right, scale(value)]);
  context.stroke();
  context.setLineDash([]);
}

/** One run in one plot. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Line} line */
function drawLine(context, layout, plot, { run, token, dash, width, slot }) {
  for (const [i, column] of curvesOf[plot.name].entries()) {
    const points = pointsIn(layout, plot, run, column);
    strokeThrough(context, points, { token: token ?? tokens[plot.name][i], width, dash });
    const last = run.time.length - 1;
    if (slot !== null) drawPinMark(context, slot, layout.time(run.time[last]), plot.scale(column(run)[last]));
  }
}

/** Where the line of a pin ends. @param {CanvasRenderingContext2D} context @param {number} slot @param {number} px @param {number} py */
export function drawPinMark(context, slot, px, py) {
  const { mark, token } = styles[slot];
  drawMark(context, mark, px, py, { fill: colour(token), edge: colour('--paper') });
}

/** A velocity is applied until the next sample, everything else changes on the way. @param {PlotName} name */
const isHeld = (name) => name in commands;

/** Where a curve goes. @param {Layout} layout @param {Plot} plot @param {Run} run @param {Column} column */
const pointsIn = (layout, plot, run, column) =>
  pointsOf(axesOf(layout, plot), run.time, column(run), isHeld(plot.name));

/** Of a line that is thin besides. */
export const askedAlpha = 0.7;

/** What the law asked for, where the limits gave less. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Run} run */
function drawCommand(context, layout, plot, run) {
  const command = commands[plot.name];
  if (!command) return;
  context.globalAlpha = askedAlpha;
  const points = pointsIn(layout, plot, run, command);
  strokeThrough(context, points, { token: tokens[plot.name][0], width: 1.25 });
  context.globalAlpha = 1;
}

/** J in its parts, each on top of the one before; what is due at the end stands at the end. @param {CanvasRenderingContext2D} context @param {Layout} layout @param {Plot} plot @param {Run} run */
function drawParts(context, layout, plot, run) {
  const { time } = layout;
  const { scale, frame } = plot;
  const last = run.time.length - 1;
  for (const [i, [, token, column]] of [...parts.entries()].reverse()) {
    const points = pointsIn(layout, plot, run, column);
    context.beginPath();
    through(context, points);
    context.lineTo(time(run.time[last]), frame.bottom);
    context.lineTo(frame.left, frame.bottom);
    // Its own colour, without what shines through from the part above.
    context.fillStyle = colour('--paper');
    context.fill();
    context.globalAlpha = 0.28;
    context.fillStyle = colour(token);
    context.fill();
    context.globalAlpha = 1;
    if (i < parts.length - 1) strokeThrough(context, points, { token, width: 1 });
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
