// The fitness curve: the best and the median J of each generation.
import uPlot from 'uplot';
import {
  axis,
  gutterOf,
  isNarrow,
  lineLabel,
  placeName,
  sameDigits,
  sizeOf,
  spread,
  wholeSteps,
} from '../kit/plot.js';
import { colour } from '../kit/palette.js';
import { watch } from '../kit/memo.js';
import { lab as strings } from '../words/index.js';

/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {{ history: Statistics[], generation: number, paper: number, theme: number }} CurveModel */

/** @param {HTMLElement} root */
export function createCurve(root) {
  /** @type {CurveModel} */
  let model = { history: [], generation: 0, paper: Number.NaN, theme: 0 };
  const changed = watch();
  const labels = createLabels();
  const only = () => model.history.length === 1;
  const points = { show: only, size: 7 };

  const plot = new uPlot(
    {
      ...sizeOf(root),
      padding: [8, gutterOf, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [0, lastTick(model.history.length - 1)] },
        y: { range: () => costRange(model) },
      },
      axes: [
        { ...axis(), size: 28, space: 56, incrs: wholeSteps },
        { ...axis(), size: 52, space: 32, values: sameDigits },
      ],
      series: [
        {},
        { stroke: () => colour('--muted'), width: 1.5, points: { ...points, fill: () => colour('--muted') } },
        { stroke: () => colour('--muted'), width: 1.5, dash: [2, 5], points: { show: false } },
        { stroke: () => colour('--ink'), width: 2.5, points: { ...points, fill: () => colour('--ink') } },
      ],
      hooks: {
        draw: [
          (drawn) => {
            labels.draw(drawn, model);
            drawShown(drawn, model);
          },
        ],
      },
    },
    [[], [], [], []],
    root,
  );
  plot.over.append(...labels.elements);

  new ResizeObserver(() => plot.setSize(sizeOf(root))).observe(root);

  return {
    /** @param {CurveModel} next */
    draw(next) {
      if (!changed(next.history, next.generation, next.paper, next.theme)) return;
      model = next;
      plot.setData(columns(next));
    },
  };
}

/** Where the shown generation is, when it is not the newest. @param {uPlot} plot @param {Pick<CurveModel, 'history' | 'generation'>} model */
export function drawShown(plot, { history, generation }) {
  if (generation === history.length - 1) return;
  const { ctx, bbox } = plot;
  const x = plot.valToPos(generation, 'x', true);
  ctx.save();
  ctx.strokeStyle = colour('--ink');
  ctx.lineWidth = uPlot.pxRatio;
  ctx.setLineDash([3 * uPlot.pxRatio, 3 * uPlot.pxRatio]);
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}

/** @param {CurveModel} model @returns {uPlot.AlignedData} */
function columns({ history, paper }) {
  const last = lastTick(history.length - 1);
  const rest = history.length <= last ? [last] : [];
  const gap = rest.map(() => null);
  return [
    [...history.map((one) => one.generation), ...rest],
    [...history.map((one) => one.median), ...gap],
    [...history.map(() => paper), ...rest.map(() => paper)],
    [...history.map((one) => one.best.cost), ...gap],
  ];
}

/** The end of the generation axis: it grows in steps, so that the curve does not shrink at each generation. @param {number} generation */
export function lastTick(generation) {
  return [20, 50, 100, 200, 300, 500].find((end) => generation <= end) ?? Math.ceil(generation / 500) * 500;
}

/** The best curve fills the plot; the first medians may come in from above. @param {CurveModel} model @returns {[number, number]} */
function costRange({ history, paper }) {
  const best = history.map((one) => one.best.cost).filter(Number.isFinite);
  if (best.length === 0) return [0, 1];
  const [first, newest] = [best[0], best[best.length - 1]];
  const medians = history.map((one) => one.median).filter(Number.isFinite);
  const high = Math.min(Math.max(first, ...medians, Math.min(paper, 1.3 * first)), 1.4 * first);
  const low = Math.min(newest, paper);
  const room = 0.08 * (high - low) + 0.01 * high;
  return [low - 2 * room, high + room];
}

/** Names at the ends of the lines. */
function createLabels() {
  const best = lineLabel('best', strings.bestLine);
  const median = lineLabel('median', strings.medianLine);
  const paper = lineLabel('paper', strings.paperLine);
  const axisName = lineLabel('axis', strings.generationAxis);
  const costName = lineLabel('axis', strings.costSymbol);

  /** @param {uPlot} plot @param {CurveModel} model */
  const draw = (plot, model) => {
    const newest = model.history.at(-1);
    if (!newest) return;
    const end = plot.valToPos(newest.generation, 'x') + 10;
    const right = plot.over.clientWidth + 6;
    const height = (/** @type {number} */ cost) =>
      Math.min(Math.max(plot.valToPos(cost, 'y'), 0), plot.over.clientHeight);
    // Beside its point while that is alone, then on the far side of its line.
    const aside = newest.generation === 0 ? 0 : 6;
    const isAbove = (/** @type {number} */ cost) => plot.valToPos(cost, 'y') < 0;
    median.textContent = isAbove(newest.median) ? strings.above(strings.medianLine) : strings.medianLine;
    paper.textContent = isAbove(model.paper) ? strings.above(strings.paperLine) : strings.paperLine;
    const places = [
      { element: best, x: end, y: height(newest.best.cost) + aside },
      { element: median, x: end, y: height(newest.median) - aside },
      { element: paper, x: right, y: height(model.paper) },
    ];
    const together = isNarrow(plot) || end > right - 60 ? [places] : [places.slice(0, 2), places.slice(2)];
    for (const group of together) spread(group, plot.over.clientHeight);
    for (const { element, x, y } of places) placeName(plot, element, x, y);
    axisName.hidden = isNarrow(plot);
    costName.style.transform = 'translate(-50px, 0)';
    axisName.style.transform = `translate(${right + 6}px, ${plot.over.clientHeight + 6}px)`;
  };
  return { elements: [best, median, paper, axisName, costName], draw };
}
