// The map: cells and axes on one canvas, redrawn with the survey; goal, starts, the run and the cursor on another.
/** @import { Posture, Run } from '../../core/engine.js' */
/** @import { Grid } from './grid.js' */
/** @import { Shading } from './scale.js' */
import { ticks } from 'd3-array';
import { scaleLinear } from 'd3-scale';
import { circle, createWatchedLayer, strokeTwice } from '../../kit/canvas.js';
import { drawNumbersBelow, drawNumbersBeside, within } from '../../kit/chart.js';
import { sameDigits } from '../../kit/steps.js';
import { dark, drawFrame, drawShades, light, nameBeside } from '../../kit/map.js';
import { kite } from '../../lab/track.js';
import { colour } from '../../kit/palette.js';
import words from './words/index.js';
import { startOf } from './grid.js';
import { fine } from './request.js';

/**
 * @typedef {object} MapModel
 * @property {Grid} grid
 * @property {Shading | null} shading
 * @property {number | null} heading In radians; null: all of them together.
 * @property {Posture} goal
 * @property {readonly Posture[]} starts Those of the experiment.
 * @property {Posture} watched The start of the run.
 * @property {Run} run
 * @property {number | null} cell Where the cursor is.
 * @property {readonly Run[]} drives From where one points, one for each heading.
 * @property {number | null} lit Which of them stands out.
 * @property {{ width: number, height: number }} size
 * @property {number} theme
 */

/** Room on the right of the map: half of its last number. */
const beside = 8;
/** Where the map is large its axes have names: that of y stands beside its numbers, which are long far from the origin. @param {Pick<MapModel, 'grid' | 'size'>} model */
function marginIn({ grid: { y }, size: { width, height } }) {
  if (Math.min(width, height) < 300) return { left: 34, right: beside, top: 8, bottom: 26, isNamed: false };
  const longest = Math.max(...sameDigits(ticks(y.from, y.to, 8)).map(({ length }) => length));
  return { left: 52 + letter * Math.max(0, longest - 3), right: beside, top: 8, bottom: 44, isNamed: true };
}
/** About as wide as one is. */
const letter = 8;

/** Metres in pixels, the same on both axes and of every survey, also before there is one: the middles of the outer cells of the finest are half a cell inside. @param {Pick<MapModel, 'grid' | 'size'>} model */
export function axesOf({ grid, size }) {
  const margin = marginIn({ grid, size });
  const side = Math.max(
    40,
    Math.min(size.width - margin.left - margin.right, size.height - margin.top - margin.bottom),
  );
  const frame = { left: margin.left, right: margin.left + side, top: margin.top, bottom: margin.top + side };
  const whole = grid.x.to - grid.x.from;
  const half = whole / (fine - 1) / 2;
  /** @param {import('./grid.js').Grid['x']} range @param {[number, number]} pixels */
  const axis = ({ from, to }, pixels) => scaleLinear([from - half, to + half], pixels);
  return {
    frame,
    side,
    isNamed: margin.isNamed,
    cell: (side * stepOf(grid)) / (whole + 2 * half),
    x: axis(grid.x, [frame.left, frame.right]),
    y: axis(grid.y, [frame.bottom, frame.top]),
  };
}

/** From cell to cell, in metres. @param {Grid} grid */
const stepOf = ({ x: { from, to, count } }) => (to - from) / (count - 1);

/** @typedef {ReturnType<typeof axesOf>} Axes */

/** @param {HTMLElement} root It holds both canvases. */
export function createMap(root) {
  const [under, over] = Array.from(root.querySelectorAll('canvas'), createWatchedLayer);
  return {
    /** @param {MapModel} model */
    draw(model) {
      const { grid, shading, heading, goal, starts, watched, run, cell, drives, lit, size, theme } = model;
      if (size.width === 0) return;
      const axes = axesOf(model);
      under(size, [grid, shading, theme], (context) => {
        if (shading) drawCells(context, grid, shading, axes);
        drawAxes(context, axes);
      });
      over(size, [grid, goal, starts, watched, run, cell, drives, lit, heading, theme], (context) =>
        drawMarks(context, axes, model),
      );
    },
  };
}

/** What stands for "none arrives", on the map and in its legend. @param {CanvasRenderingContext2D} context */
export const hatch = (context) =>
  hatching(context, colour('--unreached'), 1, [{ colour: colour('--on-unreached'), alpha: 0.45, aside: 0 }]);

/** What lies over the shade where fewer than half arrive: a light line beside a dark one, for every shade, and falling, because in grey a shade can be that of "none". @param {CanvasRenderingContext2D} context */
export const hatchOver = (context) =>
  hatching(context, 'transparent', -1, [
    { colour: light, alpha: 0.75, aside: 0 },
    { colour: dark, alpha: 0.35, aside: 1 },
  ]);

/** @param {CanvasRenderingContext2D} context @param {string} ground @param {1 | -1} slope @param {{ colour: string, alpha: number, aside: number }[]} lines */
function hatching(context, ground, slope, lines) {
  const step = 6;
  const pixels = globalThis.devicePixelRatio || 1;
  const tile = document.createElement('canvas');
  tile.width = tile.height = Math.round(step * pixels);
  const on = /** @type {CanvasRenderingContext2D} */ (tile.getContext('2d'));
  const edge = tile.width;
  on.fillStyle = ground;
  on.fillRect(0, 0, edge, edge);
  on.lineWidth = pixels * 0.8;
  const [from, to] = slope > 0 ? [edge + 1, -1] : [-1, edge + 1];
  for (const line of lines) {
    on.strokeStyle = line.colour;
    on.globalAlpha = line.alpha;
    on.beginPath();
    for (const shift of [-edge, 0, edge].map((one) => one + line.aside * pixels)) {
      on.moveTo(shift - 1, from);
      on.lineTo(shift + edge + 1, to);
    }
    on.stroke();
  }
  const pattern = /** @type {CanvasPattern} */ (context.createPattern(tile, 'repeat'));
  pattern.setTransform(new DOMMatrix().scale(1 / pixels));
  return pattern;
}

/** @param {CanvasRenderingContext2D} context @param {Grid} grid @param {Shading} shading @param {Axes} axes */
function drawCells(context, grid, { values, few, part }, { frame, side, x, y }) {
  context.fillStyle = hatch(context);
  context.fillRect(frame.left, frame.top, side, side);
  const half = stepOf(grid) / 2;
  const edges = {
    left: x(grid.x.from - half),
    right: x(grid.x.to + half),
    top: y(grid.y.to + half),
    bottom: y(grid.y.from - half),
  };
  const shades = values.map((value) => (Number.isNaN(value) ? value : part(value)));
  // Each cell is one place that was tried: between them nothing is known.
  within(context, frame, () => {
    drawShades(context, shades, edges, false);
    context.fillStyle = hatchOver(context);
    const [width, height] = [edges.right - edges.left, edges.bottom - edges.top].map(
      (whole) => whole / grid.x.count,
    );
    context.beginPath();
    for (const cell of few) {
      const [column, row] = [cell % grid.x.count, Math.floor(cell / grid.x.count)];
      context.rect(edges.left + column * width, edges.bottom - (row + 1) * height, width, height);
    }
    context.fill();
  });
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes */
function drawAxes(context, { frame, side, isNamed, x, y }) {
  drawFrame(context, frame);
  const [across, up] = [x, y].map((scale) => scale.ticks(side > 260 ? 8 : 4));
  const texts = sameDigits(across).map((text, i) =>
    i === across.length - 1 && !isNamed ? words.metres(text) : text,
  );
  // With digits that do not fit, or its unit, the last one would be cut at the edge.
  const last = texts[texts.length - 1];
  const most = () => frame.right + beside - context.measureText(last).width / 2;
  drawNumbersBelow(context, (tick) => Math.min(x(tick), most()), frame.bottom, across, texts);
  drawNumbersBeside(context, y, frame.left - 8, up, sameDigits(up));
  if (isNamed) nameAxes(context, frame);
}

/** @param {CanvasRenderingContext2D} context @param {Axes['frame']} frame */
function nameAxes(context, { left, right, top, bottom }) {
  context.textAlign = 'center';
  context.textBaseline = 'bottom';
  context.fillText(words.axisName('x'), (left + right) / 2, bottom + 42);
  context.translate(18, (top + bottom) / 2);
  context.rotate(-Math.PI / 2);
  context.fillText(words.axisName('y'), 0, 0);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {MapModel} model */
function drawMarks(context, axes, { grid, goal, starts, watched, run, cell: at, drives, lit, heading }) {
  const { frame, cell, x, y } = axes;
  within(context, frame, () => {
    context.lineJoin = 'round';
    context.lineCap = 'round';
    drawWay(context, axes, run, [light, 4], [dark, 2]);
    drawDrives(context, axes, drives, lit);
    for (const start of starts) {
      if (start === watched) continue;
      arrow(context, axes, start, light, 9);
    }
    arrow(context, axes, goal, light, 12);
    arrow(context, axes, watched, dark, 11);
    const label = (/** @type {Posture} */ posture, /** @type {string} */ name) =>
      nameBeside(context, frame, name, Math.max(x(posture.x), frame.left), y(posture.y) + 14, 14);
    label(goal, words.goal);
    for (const start of starts) label(start, words.ownStart);
    if (at !== null) {
      const place = startOf(grid, at, 0);
      const size = Math.max(cell, 9);
      context.beginPath();
      context.rect(x(place.x) - size / 2, y(place.y) - size / 2, size, size);
      strokeTwice(context, [dark, 4], [light, 2]);
    }
    if (heading !== null) drawHeading(context, frame, heading);
  });
}

/** On the shades, which are the same in both themes. */
const missing = '#b3261e';

/** Those that miss first, then those that arrive, and the one that stands out on top. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {readonly Run[]} drives @param {number | null} lit */
function drawDrives(context, axes, drives, lit) {
  const rank = (/** @type {number} */ i) => (i === lit ? 2 : Number(drives[i].arrived));
  for (const i of [...drives.keys()].sort((a, b) => rank(a) - rank(b))) {
    const wide = i === lit ? 1.5 : 0;
    const { arrived } = drives[i];
    context.setLineDash(arrived ? [] : [7, 5]);
    if (arrived) drawWay(context, axes, drives[i], [dark, 3 + wide], [light, 1.5 + wide]);
    else drawWay(context, axes, drives[i], [light, 3 + wide], [missing, 1.5 + wide]);
  }
  context.setLineDash([]);
}

/** Where a robot goes. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Run} run @param {readonly [string, number]} wide @param {readonly [string, number]} narrow */
function drawWay(context, { x, y }, run, wide, narrow) {
  context.beginPath();
  let [px, py] = [Number.NaN, Number.NaN];
  for (let i = 0; i < run.x.length; i += 1) {
    const [nx, ny] = [x(run.x[i]), y(run.y[i])];
    if (i > 0 && i < run.x.length - 1 && Math.abs(nx - px) + Math.abs(ny - py) < 1) continue;
    context.lineTo(nx, ny);
    [px, py] = [nx, ny];
  }
  strokeTwice(context, wide, narrow);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Posture} posture @param {string} fill @param {number} size */
function arrow(context, { x, y }, posture, fill, size) {
  kite(context, x(posture.x), y(posture.y), posture.theta, size);
  strokeTwice(context, [light, 4], [dark, 2]);
  context.fillStyle = fill;
  context.fill();
}

/** The heading of all starts of the map, in its corner. @param {CanvasRenderingContext2D} context @param {Axes['frame']} frame @param {number} angle */
function drawHeading(context, frame, angle) {
  const [px, py] = [frame.right - 24, frame.top + 24];
  circle(context, px, py, 17);
  context.fillStyle = light;
  context.strokeStyle = dark;
  context.lineWidth = 1.5;
  context.fill();
  context.stroke();
  kite(context, px, py, angle, 11);
  context.fillStyle = dark;
  context.fill();
}
