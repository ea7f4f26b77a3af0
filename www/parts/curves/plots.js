// Runs against time: the lines on one canvas, redrawn when they change; the cursor, which is the robots' clock, on another.
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Pins } from '../../run/pins.js' */
/** @import { Column, Layout, Plot, PlotName } from './layout.js' */
import { createLayer } from '../../kit/canvas.js';
import { outlineOf } from '../../kit/extent.js';
import { symbolFont, textFont } from '../../kit/fonts.js';
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
import { labelHeight, spread } from '../../kit/names.js';
import { colour } from '../../kit/palette.js';
import { rememberEach, watch } from '../../kit/memo.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { drawTimeAxis, timeTicks } from './axes.js';
import { curvesOf, extentsOf, layoutOf } from './layout.js';
import { createReady } from './ready.js';

/** @template [R=Run] @typedef {{ run: R, colour: string | null, dash: readonly number[], width: number, slot: number | null }} Line Without a colour: that of what is drawn. */
/**
 * @typedef {object} PlotsModel
 * @property {Run} driving
 * @property {Run} comparison
 * @property {Pins} pins
 * @property {Run[]} pinned One for each pin.
 * @property {Experiment['limits']} limits
 * @property {number} time
 * @property {{ width: number, height: number }} size
 * @property {number} theme
 */

/** @type {Readonly<Record<PlotName, readonly string[]>>} */
const tokens = {
  position: ['--x', '--y'],
  theta: ['--theta'],
  linear: ['--energy'],
  angular: ['--omega'],
  cost: ['--ink'],
};
/** What was asked for where the limits gave less, and elsewhere what they gave. @param {Float64Array} asked @param {Float64Array} given */
const cut = (asked, given) => asked.map((value, i) => (Math.abs(value - given[i]) > 1e-9 ? value : given[i]));
/** What the velocity limits cut. @type {Readonly<Partial<Record<PlotName, Column>>>} */
const commands = {
  linear: rememberEach((run) => cut(run.commandLinear, run.linear)),
  angular: rememberEach((run) => cut(run.commandAngular, run.angular)),
};
/** The parts of J that are paid on the way, from the bottom. @type {readonly (readonly [string, string, Column])[]} */
const parts = [
  ['time', '--ink', (run) => run.time],
  ['path', '--path', rememberEach((run) => run.time.map((time, i) => time + run.pathCost[i]))],
  ['energy', '--energy', curvesOf.cost[0]],
];

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
      const { driving, comparison, pinned, limits, time, size, theme } = model;
      if (size.width === 0) return;
      curvesReady([driving, comparison, ...pinned]);
      partsReady([driving]);
      if (linesChanged(driving, comparison, pinned, limits, size, theme) || !layout) {
        layout = layoutOf(size, driving, [comparison, ...pinned], limits);
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

/** @typedef {{ text: string, token: string, font: string, y: number }} Name */

/** The names at the ends of the lines. @param {CanvasRenderingContext2D} context @param {Plot} plot @param {Run} run */
function drawNames(context, plot, run) {
  const { name, frame } = plot;
  const px = frame.right + 8;
  const half = 8;
  const all = namesOf(plot, run);
  const isLow = (all.length - 1) * labelHeight > frame.bottom - frame.top;
  // Where there is no room for all, the letter of what is drawn stands within.
  if (isLow && name === 'cost') {
    context.font = symbolFont;
    context.fillStyle = colour('--ink');
    context.textAlign = 'left';
    context.textBaseline = 'middle';
    context.fillText(lab.costSymbol, frame.left + 5, frame.top + half);
  }
  const beside = isLow && name === 'cost' ? all.filter((one) => one.font !== symbolFont) : all;
  const names = beside.map(({ y, ...rest }) => ({
    ...rest,
    y: Math.min(Math.max(y, frame.top + half), frame.bottom - half),
  }));
  spread(names, frame.top + half, frame.bottom - half);
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  for (const { text, token, font: own, y } of names) {
    context.font = own;
    context.fillStyle = colour(token);
    context.fillText(text, px, y);
  }
  if (name === 'cost') return;
  const symbols = names.filter((one) => one.font === symbolFont);
  const wide = Math.max(...symbols.map(({ text }) => context.measureText(text).width));
  const middle = symbols.reduce((sum, { y }) => sum + y, 0) / symbols.length;
  context.font = textFont;
  context.fillStyle = colour('--muted');
  context.fillText(words.units[name], px + wide + 5, middle);
}

/** @param {Plot} plot @param {Run} run @returns {Name[]} */
function namesOf({ name, scale, limit }, run) {
  const last = run.time.length - 1;
  if (name === 'cost')
    return [
      ...parts.map(([part, token, column], i) => {
        const below = i === 0 ? 0 : parts[i - 1][2](run)[last];
        const text = lab.costParts.find(([one]) => one === part)?.[1] ?? '';
        return { text, token, font: textFont, y: scale((below + column(run)[last]) / 2) };
      }),
      { text: lab.costSymbol, token: '--ink', font: symbolFont, y: scale(run.cost.total) },
    ];
  const ends = curvesOf[name].map((column, i) => ({
    text: words.symbols[name][i],
    token: tokens[name][i],
    font: symbolFont,
    y: scale(column(run)[last]),
  }));
  const isSeen = limit !== null && limit < scale.domain()[1];
  return isSeen ? [...ends, { text: words.limit, token: '--muted', font: textFont, y: scale(limit) }] : ends;
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
