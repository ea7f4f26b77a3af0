// The fitness curve of many seeds: medians and quartile bands, and at their ends one dot for each seed's final J.
/** @import { Axes, Size } from '../../kit/chart.js' */
/** @import { Dots } from './dots.js' */
/** @import { SeedSurvey } from './request.js' */
import { scaleLinear } from 'd3-scale';
import {
  createChart,
  drawBand,
  drawCurve,
  drawDot,
  drawGrid,
  drawLevel,
  drawNumbersBelow,
  frameIn,
  pointsOf,
  ticksOn,
  wholeTicks,
  within,
} from '../../kit/chart.js';
import { extentOf } from '../../kit/extent.js';
import { drawName } from '../../kit/names.js';
import { sameDigits } from '../../kit/steps.js';
import words from './words/index.js';
import { drawLineNames } from './curve-names.js';
import { diameterOf, drawDots, drawRing, nearestDot, stackDots } from './dots.js';

/** @typedef {{ name: string, costs: ArrayLike<number> }} Line */
/**
 * @typedef {object} SeedCurveModel
 * @property {SeedSurvey | null} survey
 * @property {number} generations
 * @property {Line | null} lab The run of the lab, as far as it is.
 * @property {Line | null} seed The seed in question.
 * @property {number} index Of that seed among the dots; −1 if it is none of them.
 * @property {boolean} log
 * @property {number} theme
 */
/** @typedef {{ left: number, dots: Dots }} Column */

const gap = 14;
const columnTop = 22;
/** Width of a column of dots: as much as the plot can give. @param {Size} size */
const columnOf = ({ width }) => Math.round(Math.min(84, Math.max(58, 0.15 * width)));

/** Random search is not beside itself. @param {SeedSurvey} survey */
const columnsIn = ({ experiment }) => (words.isRandom(experiment) ? 1 : 2);

/** @param {HTMLElement} root @param {{ onPoint: (index: number) => void, onChoose: (index: number) => void }} on */
export function createSeedCurve(root, { onPoint, onChoose }) {
  /** @type {Column[]} */
  let columns = [];
  const chart = createChart(root, (context, size, /** @type {SeedCurveModel} */ model) => {
    const axes = axesOf(size, model);
    drawSurvey(context, axes, model);
    drawLineNames(context, axes, model, placeOf(axes, model));
    columns = model.survey ? columnsOf(size, axes, model.survey, model) : [];
    drawColumns(context, columns, model);
  });
  const { canvas } = chart;

  /** The seed whose dot is there; −1 if there is none. @param {PointerEvent | MouseEvent} event */
  const at = ({ offsetX: x, offsetY: y }) => {
    const column = columns.findLast(({ left }) => x >= left - gap / 2);
    return column ? nearestDot(column.dots, y, x - column.left) : -1;
  };
  canvas.addEventListener('pointermove', (event) => {
    canvas.classList.toggle('pressable', columns.length > 0 && event.offsetX >= columns[0].left - gap);
    onPoint(at(event));
  });
  canvas.addEventListener('pointerleave', () => onPoint(-1));
  canvas.addEventListener('click', (event) => onChoose(at(event)));
  return chart;
}

/** @param {Size} size @param {SeedCurveModel} model @returns {Axes} */
function axesOf(size, model) {
  const frame = frameIn(size, {
    top: columnTop,
    right: model.survey ? columnsIn(model.survey) * (columnOf(size) + gap) : 112,
  });
  return {
    frame,
    x: scaleLinear([0, model.generations], [frame.left, frame.right]),
    y: scaleLinear(rangeOf(model), [frame.bottom, frame.top]),
  };
}

/** The height of a cost on the axis. @param {SeedCurveModel} model */
function heightOf({ survey, log }) {
  const lowest = survey?.summary.lowest;
  return (/** @type {number} */ cost) =>
    log && lowest !== undefined ? Math.log10(Math.max(cost - lowest, smallest)) : cost;
}

/** Distances under this are shown as this. */
const smallest = 1e-9;

/** Where a cost is, inside the frame. @param {Axes} axes @param {SeedCurveModel} model */
function placeOf({ y, frame }, model) {
  const height = heightOf(model);
  return (/** @type {number} */ cost) => Math.min(Math.max(y(height(cost)), frame.top), frame.bottom);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {SeedCurveModel} model */
function drawSurvey(context, axes, model) {
  const { survey, lab, seed, log } = model;
  const { x, y, frame } = axes;
  const ticks = {
    x: wholeTicks(x),
    y: ticksOn(y, 36, log ? { factors: [1, 2, 3], least: 1 } : { factors: [1, 2, 5] }),
  };
  drawGrid(context, axes, ticks, log ? ticks.y.map(words.powerOfTen) : sameDigits(ticks.y));
  drawNumbersBelow(context, x, frame.bottom, ticks.x, ticks.x.map(String));
  const numbers = Array.from({ length: model.generations + 1 }, (_, generation) => generation);
  const height = heightOf(model);
  const points = (/** @type {ArrayLike<number>} */ costs) =>
    pointsOf(
      axes,
      numbers.slice(0, costs.length),
      Array.from(costs, (cost) => (Number.isFinite(cost) ? height(cost) : Number.NaN)),
    );
  within(context, frame, () => {
    if (survey) {
      const { random, evolution } = survey.summary;
      const isBeside = columnsIn(survey) === 2;
      if (isBeside) drawBand(context, points(random.high), points(random.low), '--muted', 0.17);
      drawBand(context, points(evolution.high), points(evolution.low), '--ink', 0.17);
      if (isBeside) drawCurve(context, points(random.median), { token: '--muted', width: 1.5, dash: [6, 4] });
      drawCurve(context, points(evolution.median), { token: '--ink', width: 2.5 });
    }
    if (lab) drawCurve(context, points(lab.costs), { token: '--ink', width: 1, dash: [2, 3] });
    if (seed) drawCurve(context, points(seed.costs), { token: '--ink', width: 1 });
    if (survey && Number.isFinite(survey.paper.cost)) {
      const py = y(height(survey.paper.cost));
      drawLevel(context, frame, py, { token: '--muted', width: 1.5, dash: [2, 5] });
    }
  });
  if (lab?.costs.length === 1) drawDot(context, x(0), y(height(lab.costs[0])), '--ink');
}

/** The bands and all the ends fill the plot; single seeds may come in from above. @param {SeedCurveModel} model @returns {[number, number]} */
export function rangeOf(model) {
  const { survey, lab, log } = model;
  const height = heightOf(model);
  const own = Array.from(lab?.costs ?? []).filter(Number.isFinite);
  if (!survey) {
    const [least, most] = own.length > 0 ? extentOf([own]) : [0, 1];
    // Also where every J is 0 the axis has a length.
    const size = most || 1;
    return [least - 0.06 * size, most + 0.02 * size];
  }
  const { evolution, random, final, finalRandom, lowest, costs } = survey.summary;
  const begin = [...evolution.high, ...random.high].find(Number.isFinite) ?? 1;
  const finite = [begin, finalRandom.high, final.high].filter(Number.isFinite);
  const high = height(Math.max(...finite));
  if (log) {
    // The very luckiest stand at the lower edge: between them and the lowest of all there is no bottom.
    const distances = costs.map((cost) => cost - lowest).sort((a, b) => a - b);
    const low = Math.log10(Math.max(smallest, distances[Math.ceil(0.04 * distances.length)] ?? 0));
    return [Math.min(Math.floor(low), high - 1) - 0.1, high + 0.1];
  }
  const low = Math.min(lowest, Number.isFinite(survey.paper.cost) ? survey.paper.cost : lowest);
  // Where all are the same, the axis has short numbers too.
  const room = Math.max(high - low, 0.02 * Math.abs(high)) || 1;
  return [low - 0.1 * room, high + 0.04 * room];
}

/** The dots at the end of the curves: evolution's, then random search's; or only those. @param {Size} size @param {Axes} axes @param {SeedSurvey} survey @param {SeedCurveModel} model @returns {Column[]} */
function columnsOf(size, axes, survey, model) {
  const y = placeOf(axes, model);
  const column = columnOf(size);
  const { costs: own, randomCosts } = survey.summary;
  return [own, randomCosts].slice(0, columnsIn(survey)).map((costs, i) => ({
    left: axes.frame.right + gap + i * (column + gap),
    dots: stackDots(costs.map(y), diameterOf(survey.count), column),
  }));
}

/** @param {CanvasRenderingContext2D} context @param {readonly Column[]} columns @param {SeedCurveModel} model */
function drawColumns(context, columns, { survey, index }) {
  for (const [i, { left, dots }] of columns.entries()) {
    const isOwn = i === 0;
    drawDots(context, dots, diameterOf(survey?.count ?? 1), isOwn ? '--ink' : '--muted', (along, away) => [
      left + away,
      along,
    ]);
    if (index >= 0) drawRing(context, left + dots.away[index], dots.along[index]);
    const text = isOwn && columns.length > 1 ? words.evolutionHead : words.randomHead;
    drawName(context, { text, x: left - 3, y: 8, token: isOwn ? '--ink' : '--muted', isStrong: isOwn });
  }
}
