// The fitness curve: the best and the median J of each generation.
/** @import { Statistics } from '../core/engine.js' */
/** @import { Axes, Size } from '../kit/chart.js' */
import { scaleLinear } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawDot,
  drawGridOverWholes,
  drawLevel,
  drawUpright,
  frameIn,
  pointsOf,
  levelsOn,
  within,
} from '../kit/chart.js';
import { extentOf } from '../kit/extent.js';
import { drawAxisNames, drawNames, gutterOf, isNarrow, labelHeight, spreadBeside } from '../kit/names.js';
import { sameDigits } from '../kit/steps.js';
import { lab as strings } from '../words/index.js';
import { createColumns } from './columns.js';

/** @typedef {{ history: Statistics[], generation: number, paper: number | null, theme: number }} CurveModel */
/** @typedef {CurveModel & { columns: Record<'generation' | 'best' | 'median', Float64Array> }} DrawnModel */

/** @param {HTMLElement} root */
export function createCurve(root) {
  const columnsOf = createColumns(['generation', 'best', 'median']);
  return createChart(root, (context, size, /** @type {CurveModel} */ model) =>
    drawCosts(context, size, { ...model, columns: columnsOf(model.history) }),
  );
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {DrawnModel} model */
function drawCosts(context, size, model) {
  const { history, generation, paper, columns } = model;
  const frame = frameIn(size, { right: gutterOf(size) });
  const axes = {
    frame,
    x: generationScale(history, frame),
    y: scaleLinear(costRange(model), [frame.bottom, frame.top]),
  };
  const levels = levelsOn(axes.y);
  // A long number has no room beside the name of the axis.
  const texts = sameDigits(levels).map((text, i) =>
    text.length > 4 && axes.y(levels[i]) < frame.top + labelHeight ? '' : text,
  );
  drawGridOverWholes(context, axes, levels, texts);
  const lines = [
    { token: '--muted', width: 1.5, costs: columns.median },
    { token: '--ink', width: 2.5, costs: columns.best },
  ];
  within(context, frame, () => {
    for (const { costs, ...stroke } of lines) {
      drawCurve(context, pointsOf(axes, columns.generation, costs), stroke);
      // The paper's line lies between the two.
      if (stroke.token === '--muted' && paper !== null)
        drawLevel(context, frame, axes.y(paper), { ...stroke, dash: [2, 5] });
    }
  });
  if (history.length === 1)
    for (const { token, costs } of lines) drawDot(context, axes.x(0), axes.y(costs[0]), token);
  drawLineNames(context, size, axes, model);
  drawShown(context, axes, history, generation);
}

const finiteOr = (/** @type {number} */ value, /** @type {number} */ other) =>
  Number.isFinite(value) ? value : other;

/** @param {Statistics[]} history @param {import('../kit/chart.js').Frame} frame */
export const generationScale = (history, { left, right }) =>
  scaleLinear([0, lastTick(history.length - 1)], [left, right]);

/** Where the shown generation is, when it is not the newest. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Statistics[]} history @param {number} generation */
export function drawShown(context, { x, frame }, history, generation) {
  if (generation < history.length - 1)
    drawUpright(context, x(generation), frame, { token: '--ink', width: 1, dash: [3, 3] });
}

/** The end of the generation axis: it grows in steps, so that the curve does not shrink at each generation. @param {number} generation */
function lastTick(generation) {
  return [20, 50, 100, 200, 300, 500].find((end) => generation <= end) ?? Math.ceil(generation / 500) * 500;
}

/** The best curve fills the plot; the first medians may come in from above. No J is below 0. @param {DrawnModel} model @returns {[number, number]} */
export function costRange({ columns, paper }) {
  const first = columns.best.find(Number.isFinite);
  const newest = columns.best.findLast(Number.isFinite);
  if (first === undefined || newest === undefined) return [0, 1];
  const [, median] = extentOf([columns.median]);
  const high = Math.min(Math.max(first, median, Math.min(paper ?? first, 1.3 * first)), 1.4 * first);
  const low = Math.min(newest, paper ?? newest);
  const room = 0.08 * (high - low) + 0.01 * high || 0.05;
  return [Math.max(0, low - 2 * room), high + room];
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {Axes} axes @param {CurveModel} model */
function drawLineNames(context, size, { x, y, frame }, { history, paper }) {
  const newest = history[history.length - 1];
  const [end, right] = [x(newest.generation) + 10, frame.right + 10];
  const height = (/** @type {number} */ cost) =>
    Math.min(Math.max(finiteOr(y(cost), 0), frame.top), frame.bottom);
  // Beside its point while that is alone, then on the far side of its line.
  const aside = newest.generation === 0 ? 0 : 6;
  const nameOf = (/** @type {string} */ name, /** @type {number} */ cost) =>
    y(cost) < frame.top ? strings.above(name) : name;
  const names = [
    { text: strings.bestLine, x: end, y: height(newest.best.cost) + aside, token: '--ink', isStrong: true },
    { text: nameOf(strings.medianLine, newest.median), x: end, y: height(newest.median) - aside },
    ...(paper === null ? [] : [{ text: nameOf(strings.paperLine, paper), x: right, y: height(paper) }]),
  ];
  const together = isNarrow(size) || end > right - 60 ? [names] : [names.slice(0, 2), names.slice(2)];
  for (const group of together) if (group.length > 0) spreadBeside(group, frame);
  drawNames(context, size, frame, names);
  drawAxisNames(context, frame, {
    x: isNarrow(size) ? undefined : strings.generationAxis,
    y: strings.costSymbol,
  });
}
