// The fitness curve of many seeds: medians and quartile bands, and at their ends one dot for each seed's final J.
import uPlot from 'uplot';
import { createLayer } from '../../kit/canvas.js';
import { axis, lineLabel, sameDigits, sizeOf, spread, wholeSteps } from '../../kit/plot.js';
import { colour } from '../../kit/palette.js';
import { watch } from '../../kit/memo.js';
import { luck as words } from '../../words/index.js';
import { diameterOf, nearestDot, stackDots } from './dots.js';

/** @typedef {import('./dots.js').Dots} Dots */
/** @typedef {import('./request.js').SeedSurvey} SeedSurvey */
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

const gap = 14;
const columnTop = 22;
/** Width of a column of dots: as much as the plot can give. @param {number} width */
const columnOf = (width) => Math.round(Math.min(84, Math.max(58, 0.15 * width)));

/** @param {HTMLElement} root @param {{ onPoint: (index: number) => void, onChoose: (index: number) => void }} on */
export function createSeedCurve(root, { onPoint, onChoose }) {
  /** @type {SeedCurveModel} */
  let model = { survey: null, generations: 1, lab: null, seed: null, index: -1, log: false, theme: 0 };
  const changed = watch();
  const labels = createLabels();
  const ends = createEnds(root);

  const line = (/** @type {string} */ name, /** @type {Partial<uPlot.Series>} */ style) => ({
    stroke: () => colour(name),
    points: { show: false },
    ...style,
  });
  const edge = { stroke: 'transparent', width: 0, points: { show: false } };
  const band = (/** @type {[number, number]} */ series, /** @type {string} */ name) => ({
    series,
    fill: () => `${colour(name)}2b`,
  });

  const plot = new uPlot(
    {
      ...sizeOf(root),
      padding: [columnTop, () => (model.survey ? 2 * (columnOf(root.clientWidth) + gap) : 112), 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [0, model.generations] },
        y: { range: () => rangeOf(model) },
      },
      axes: [
        { ...axis(), size: 28, space: 56, incrs: wholeSteps },
        {
          ...axis(),
          size: 52,
          space: 36,
          incrs: () => (model.log ? [1, 2, 3] : costSteps),
          values: (drawn, ticks) => (model.log ? ticks.map(words.powerOfTen) : sameDigits(drawn, ticks)),
        },
      ],
      bands: [band([1, 2], '--muted'), band([4, 5], '--ink')],
      series: [
        {},
        edge,
        edge,
        line('--muted', { width: 1.5, dash: [6, 4] }),
        edge,
        edge,
        line('--ink', { width: 2.5 }),
        line('--ink', {
          width: 1,
          dash: [2, 3],
          points: { show: () => model.lab?.costs.length === 1, size: 7 },
        }),
        line('--ink', { width: 1 }),
        line('--muted', { width: 1.5, dash: [2, 5] }),
      ],
      hooks: {
        draw: [
          (drawn) => {
            labels.draw(drawn, model);
            ends.draw(drawn, model);
          },
        ],
      },
    },
    columnsOf(model),
    root,
  );
  plot.over.append(...labels.elements);
  root.append(ends.canvas);
  new ResizeObserver(() => plot.setSize(sizeOf(root))).observe(root);

  const { canvas } = ends;
  canvas.addEventListener('pointermove', (event) => onPoint(ends.at(event)));
  canvas.addEventListener('pointerleave', () => onPoint(-1));
  canvas.addEventListener('click', (event) => onChoose(ends.at(event)));

  return {
    /** @param {SeedCurveModel} next */
    draw(next) {
      if (!changed(next.survey, next.generations, next.lab, next.seed, next.index, next.log, next.theme))
        return;
      model = next;
      plot.setData(columnsOf(next));
    },
  };
}

const costSteps = [-4, -3, -2, -1, 0, 1, 2, 3, 4, 5].flatMap((power) =>
  [1, 2, 5].map((digit) => digit * 10 ** power),
);

/** The height of a cost on the axis. @param {SeedCurveModel} model */
function heightOf({ survey, log }) {
  const lowest = survey?.summary.lowest;
  return (/** @type {number} */ cost) =>
    log && lowest !== undefined ? Math.log10(Math.max(cost - lowest, smallest)) : cost;
}

/** Distances under this are shown as this. */
const smallest = 1e-9;

/** @param {SeedCurveModel} model @returns {uPlot.AlignedData} */
function columnsOf(model) {
  const { survey, generations, lab, seed } = model;
  const height = heightOf(model);
  const numbers = Array.from({ length: generations + 1 }, (_, generation) => generation);
  /** @param {ArrayLike<number> | undefined} costs */
  const column = (costs) =>
    numbers.map((generation) => {
      const cost = costs?.[generation];
      return cost !== undefined && Number.isFinite(cost) ? height(cost) : null;
    });
  const { random, evolution } = survey?.summary ?? {};
  const paper = survey && Number.isFinite(survey.paper.cost) ? height(survey.paper.cost) : null;
  return [
    numbers,
    column(random?.high),
    column(random?.low),
    column(random?.median),
    column(evolution?.high),
    column(evolution?.low),
    column(evolution?.median),
    column(lab?.costs),
    column(seed?.costs),
    numbers.map(() => paper),
  ];
}

/** The bands and all the ends fill the plot; single seeds may come in from above. @param {SeedCurveModel} model @returns {[number, number]} */
function rangeOf(model) {
  const { survey, lab, log } = model;
  const height = heightOf(model);
  const own = Array.from(lab?.costs ?? []).filter(Number.isFinite);
  if (!survey) {
    const [least, most] = own.length > 0 ? [Math.min(...own), Math.max(...own)] : [0, 1];
    return [least - 0.06 * most, most + 0.02 * most];
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
  const room = Math.max(high - low, 1e-6 * Math.abs(high));
  return [low - 0.1 * room, high + 0.04 * room];
}

/** Names at the lines, and over the columns of dots. */
function createLabels() {
  const evolution = lineLabel('best', words.evolutionLine);
  const random = lineLabel('random', words.randomLine);
  const paper = lineLabel('paper', words.paperLine);
  const lab = lineLabel('own', '');
  const seed = lineLabel('own', '');
  const evolutionEnds = lineLabel('best head', words.evolutionHead);
  const randomEnds = lineLabel('head', words.randomHead);
  const axisName = lineLabel('axis', words.generationAxis);
  const costName = lineLabel('axis', '');
  const elements = [evolution, random, paper, lab, seed, evolutionEnds, randomEnds, axisName, costName];

  /** @param {HTMLElement} element @param {number} x @param {number} y @param {number} [part] Of its width that lies left of x. */
  const put = (element, x, y, part = 0) => {
    element.style.transform = `translate(${x}px, ${y}px) translate(${-100 * part}%, -50%)`;
  };

  /** @param {uPlot} plot @param {SeedCurveModel} model */
  const draw = (plot, model) => {
    const { survey, lab: labLine, seed: seedLine } = model;
    const { clientWidth: width, clientHeight: height } = plot.over;
    const heightAt = heightOf(model);
    const y = (/** @type {number} */ cost) =>
      Math.min(Math.max(plot.valToPos(heightAt(cost), 'y'), 0), height);
    for (const element of [evolution, random, paper, evolutionEnds, randomEnds]) element.hidden = !survey;
    lab.hidden = !labLine;
    seed.hidden = !seedLine;
    lab.textContent = labLine?.name ?? '';
    seed.textContent = seedLine?.name ?? '';
    costName.textContent = model.log && survey ? words.distanceAxis(survey.summary.lowest) : words.costSymbol;
    put(costName, -50, -columnTop + 8);
    put(axisName, width + 20, height + 16);

    if (survey) {
      const column = columnOf(plot.root.parentElement?.clientWidth ?? 0);
      put(evolutionEnds, width + gap - 3, -columnTop + 8);
      put(randomEnds, width + 2 * gap + column - 3, -columnTop + 8);
      const { evolution: ours, random: theirs } = survey.summary;
      const last = survey.generations;
      const places = [
        { element: random, y: y(theirs.high[last]) - 11 },
        { element: evolution, y: y(ours.high[last]) - 11 },
        { element: paper, y: y(survey.paper.cost) + (survey.paper.cost > theirs.high[last] ? -11 : 10) },
      ];
      spread(places, height);
      for (const place of places) put(place.element, width - 4, place.y, 1);
    }
    if (labLine && !survey) putAtEnd(plot, lab, labLine, y);
    else if (labLine) putWhereAlone(plot, lab, labLine, survey, y);
    if (seedLine) putWhereAlone(plot, seed, seedLine, survey, y);
  };

  /** @param {uPlot} plot @param {HTMLElement} element @param {Line} line @param {(cost: number) => number} y */
  const putAtEnd = (plot, element, { costs }, y) =>
    put(element, plot.valToPos(costs.length - 1, 'x') + 8, y(costs[costs.length - 1]));

  /** Where a line is farthest from the median. @param {uPlot} plot @param {HTMLElement} element @param {Line} line @param {SeedSurvey | null} survey @param {(cost: number) => number} y */
  const putWhereAlone = (plot, element, { costs }, survey, y) => {
    const medians = survey?.summary.evolution.median ?? [];
    const last = Math.min(costs.length, medians.length) - 1;
    let [at, most] = [0, -1];
    for (let generation = Math.ceil(0.08 * last); generation <= 0.6 * last; generation += 1) {
      const apart = Math.abs(y(costs[generation]) - y(medians[generation]));
      if (apart > most) [at, most] = [generation, apart];
    }
    const above = y(costs[at]) < y(medians[at]);
    put(element, plot.valToPos(at, 'x') + 4, y(costs[at]) + (above ? -11 : 11));
  };

  return { elements, draw };
}

/** The dots at the end of the curves: evolution's, then random search's. @param {HTMLElement} root */
function createEnds(root) {
  const canvas = document.createElement('canvas');
  canvas.className = 'luck-ends';
  canvas.setAttribute('aria-hidden', 'true');
  const layer = createLayer(canvas);
  /** @type {{ left: number, dots: Dots }[]} */
  let columns = [];

  return {
    canvas,

    /** @param {uPlot} plot @param {SeedCurveModel} model */
    draw(plot, model) {
      const { survey, index } = model;
      const column = columnOf(root.clientWidth);
      const size = { width: 2 * (column + gap), height: sizeOf(root).height };
      canvas.style.left = `${plot.over.offsetLeft + plot.over.clientWidth}px`;
      canvas.style.width = `${size.width}px`;
      layer.clear(size);
      columns = [];
      if (!survey) return;
      const top = plot.over.offsetTop;
      const height = heightOf(model);
      const pixels = (/** @type {number} */ cost) =>
        top + Math.min(Math.max(plot.valToPos(height(cost), 'y'), 0), plot.over.clientHeight);
      const { costs, randomCosts } = survey.summary;
      const diameter = diameterOf(costs.length);
      columns = [costs, randomCosts].map((values, i) => ({
        left: gap + i * (column + gap),
        dots: stackDots(values.map(pixels), diameter, column),
      }));
      const { context } = layer;
      for (const [i, { left, dots }] of columns.entries()) {
        context.fillStyle = colour(i === 0 ? '--ink' : '--muted');
        drawDots(context, dots, diameter, (along, away) => [left + away, along]);
        if (index >= 0) drawRing(context, left + dots.away[index], dots.along[index]);
      }
    },

    /** The seed whose dot is there; −1 if there is none. @param {PointerEvent | MouseEvent} event */
    at(event) {
      const { left: canvasLeft, top } = canvas.getBoundingClientRect();
      const [x, y] = [event.clientX - canvasLeft, event.clientY - top];
      const column = columns.findLast(({ left }) => x >= left - gap / 2) ?? columns[0];
      return column ? nearestDot(column.dots, y, x - column.left) : -1;
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {Dots} dots @param {number} diameter @param {(along: number, away: number) => [number, number]} place */
export function drawDots(context, { along, away }, diameter, place) {
  // Overlapping dots show where there are many.
  context.globalAlpha = 0.6;
  for (let i = 0; i < along.length; i += 1) {
    context.beginPath();
    context.arc(...place(along[i], away[i]), Math.max(1, diameter / 2 - 0.5), 0, 2 * Math.PI);
    context.fill();
  }
  context.globalAlpha = 1;
}

/** Marks the seed in question. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y */
export function drawRing(context, x, y) {
  for (const [name, width] of /** @type {const} */ ([
    ['--paper', 5],
    ['--ink', 2],
  ])) {
    context.strokeStyle = colour(name);
    context.lineWidth = width;
    context.beginPath();
    context.arc(x, y, 5.5, 0, 2 * Math.PI);
    context.stroke();
  }
}
