// The mean step size σ of each gain over the generations, on a logarithmic axis.
/** @import { Statistics } from '../core/engine.js' */
/** @import { Axes, Size } from '../kit/chart.js' */
import { range } from 'd3-array';
import { scaleLog } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawDot,
  drawGridOverWholes,
  frameIn,
  pointsOf,
  within,
} from '../kit/chart.js';
import { extentOf } from '../kit/extent.js';
import { drawAxisNames, drawNames, gutterOf, isNarrow, spreadBeside } from '../kit/names.js';
import { dashes } from '../kit/palette.js';
import { sigmas as words, lab } from '../words/index.js';
import { createColumns } from './columns.js';
import { drawShown, generationScale } from './fitness.js';

/** @typedef {{ history: Statistics[], generation: number, theme: number }} SigmasModel */
/** @typedef {Record<'generation' | 'kx' | 'ky' | 'ktheta', Float64Array>} Columns */

const gains = /** @type {const} */ (['kx', 'ky', 'ktheta']);
const tokens = ['--x', '--y', '--theta'];

/** @param {HTMLElement} root */
export function createSigmas(root) {
  const columnsOf = createColumns(['generation', ...gains]);
  const chart = createChart(root, (context, size, /** @type {SigmasModel} */ model) =>
    drawSigmas(context, size, { ...model, columns: columnsOf(model.history) }),
  );
  return {
    /** @param {SigmasModel} model */
    draw(model) {
      if (!chart.draw(model)) return;
      const { history, generation } = model;
      root.setAttribute('aria-label', words.sigmaLabel(history[0], history[generation], lab.gains));
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {SigmasModel & { columns: Columns }} model */
function drawSigmas(context, size, { history, generation, columns }) {
  const frame = frameIn(size, { right: gutterOf(size) });
  const range = decades(columns);
  const axes = {
    frame,
    x: generationScale(history, frame),
    y: scaleLog(range, [frame.bottom, frame.top]),
  };
  const levels = powers(range);
  drawGridOverWholes(context, axes, levels, levels.map(powerText));
  within(context, frame, () => {
    for (const [i, token] of tokens.entries())
      drawCurve(context, pointsOf(axes, columns.generation, columns[gains[i]]), {
        token,
        width: 2,
        dash: dashes[token],
      });
  });
  if (history.length === 1)
    for (const [i, token] of tokens.entries())
      drawDot(context, axes.x(0), axes.y(history[0].meanSigmas[i]), token);
  drawLineNames(context, size, axes, history[history.length - 1]);
  drawShown(context, axes, history, generation);
}

/** Whole powers of ten around all σ. @param {Columns} columns @returns {[number, number]} */
function decades(columns) {
  // σ = 1 of the beginning has a decade above and below.
  const sigmas = gains.map((gain) => columns[gain]);
  const [low, high] = extentOf(sigmas, [0.1, 10]);
  return [10 ** Math.floor(Math.log10(low)), 10 ** Math.ceil(Math.log10(high))];
}

/** At most some seven of the powers of ten between. @param {[number, number]} range */
function powers([low, high]) {
  const [from, to] = [Math.round(Math.log10(low)), Math.round(Math.log10(high))];
  const step = Math.ceil((to - from) / 6);
  return range(to, from - 1, -step)
    .map((exponent) => 10 ** exponent)
    .reverse();
}

const powerText = (/** @type {number} */ power) => words.powerOfTen(Math.round(Math.log10(power)));

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {Axes} axes @param {Statistics} newest */
function drawLineNames(context, size, { x, y, frame }, newest) {
  const [before, after] = words.sigmaOf;
  const names = lab.gains.map(({ letter, index }, i) => ({
    // 0 has no place on the axis.
    text: [before + letter, index, newest.meanSigmas[i] === 0 ? `${after} = 0` : after],
    token: tokens[i],
    x: Math.min(x(newest.generation) + 10, frame.right + 6),
    y: Math.min(Math.max(y(newest.meanSigmas[i]) || frame.bottom, frame.top), frame.bottom - 8),
  }));
  spreadBeside(names, frame);
  drawNames(context, size, frame, names);
  if (!isNarrow(size)) drawAxisNames(context, frame, { x: lab.generationAxis });
}
