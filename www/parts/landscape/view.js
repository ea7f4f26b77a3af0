// The landscape: shades and contours on one canvas, redrawn with its costs; who lives in it on another, as they move.
/** @import { Individual, Triple } from '../../core/engine.js' */
/** @import { Sketch } from './method.js' */
/** @import { Point } from './points.js' */
/** @import { Landscape, Spec } from './request.js' */
/** @import { CostScale } from './scale.js' */
import { gainNames } from './state.js';
import { contours } from 'd3-contour';
import { circle, createWatchedLayer, strokeTwice } from '../../kit/canvas.js';
import { drawNumbersBelow, drawNumbersBeside, through, within } from '../../kit/chart.js';
import { followSize } from '../../kit/size.js';
import { setLettering } from '../../kit/lettering.js';
import { dark, drawFrame, drawShades, light } from '../../kit/map.js';
import { shadeAt } from '../../kit/shades.js';
import { remember } from '../../kit/memo.js';
import { pale } from '../../kit/palette.js';
import { drawSymbol } from '../../kit/names.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { endsOfAxis, isInSlice } from './request.js';
import { isOn } from './lowest.js';
import { drawPoints } from './points.js';
import { createAxis, createCostScale, numbersAt } from './scale.js';
import { drawSketch } from './sketch.js';

/**
 * @typedef {object} MapModel
 * @property {Spec} spec
 * @property {Landscape | null} result
 * @property {Individual[]} population
 * @property {boolean} hasCrosses Whether each has its σ drawn.
 * @property {Sketch | null} sketch What the method sees, if it is not the paper's.
 * @property {readonly Triple[]} path The best so far at each generation.
 * @property {readonly Point[]} points
 * @property {readonly [number, number] | null} cursor
 * @property {{ width: number, height: number }} size
 * @property {number} theme
 */

/** Contours of fewer points are single cells: a speckle, where a robot arrives or not by a hair. */
const smallestRing = 12;
/** Between two numbers of the legend. */
const apart = 6;
const margin = { left: 44, right: 14, top: 10, bottom: 30 };
const barHeight = 34;

/** @param {MapModel} model */
export function axesOf({ spec, size }) {
  const frame = {
    left: margin.left,
    right: size.width - margin.right,
    top: margin.top,
    bottom: size.height - margin.bottom,
  };
  return {
    frame,
    x: createAxis(spec.x, endsOfAxis(spec.x, spec.range), [frame.left, frame.right]),
    y: createAxis(spec.y, endsOfAxis(spec.y, spec.range), [frame.bottom, frame.top]),
  };
}

/** @typedef {ReturnType<typeof axesOf>} Axes */

/** @param {HTMLElement} element The part, in which the templates have made room for it. @param {() => void} onResize */
export function createMap(element, onResize) {
  const [picture, marks, legend] = element.querySelectorAll('canvas');
  const [under, over, bar] = [picture, marks, legend].map(createWatchedLayer);
  let barSize = { width: 0, height: barHeight };
  followSize(legend, ({ width }) => {
    barSize = { width, height: barHeight };
    onResize();
  });
  const scaleOf = remember(createCostScale);

  return {
    /** @param {MapModel} model */
    draw(model) {
      const { spec, result, population, sketch, path, points, cursor, size, theme } = model;
      if (size.width === 0) return;
      const axes = axesOf(model);
      const { x, y, range, third } = spec;
      const there = result && isOn(result.spec, spec) ? { result, scale: scaleOf(result.costs) } : null;
      under(size, [result, x, y, range, theme], (context) => {
        if (there) drawLandscape(context, there.result, axes, there.scale);
        drawAxes(context, axes, spec);
      });
      if (there)
        bar(barSize, [there.scale, theme], (context) => drawLegend(context, there.scale, barSize.width));
      const places = points.flatMap(({ gains, mark }) => [...gains, mark]);
      over(size, [x, y, range, third, population, sketch, path, ...places, cursor, theme], (context) =>
        drawMarks(context, axes, model),
      );
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {Landscape} landscape @param {Axes} axes @param {CostScale} scale */
function drawLandscape(context, { costs, count }, { frame }, scale) {
  // The outer cells have their middles on the frame.
  const [wide, high] = [(frame.right - frame.left) / (count - 1), (frame.bottom - frame.top) / (count - 1)];
  const edges = {
    left: frame.left - wide / 2,
    right: frame.right + wide / 2,
    top: frame.top - high / 2,
    bottom: frame.bottom + high / 2,
  };
  within(context, frame, () => {
    drawShades(context, Float64Array.from(costs, scale.part), edges, true);
    const flat = Array.from(costs, (cost) => Math.min(cost, scale.high));
    context.strokeStyle = light;
    context.lineWidth = 1;
    for (const line of contours().size([count, count]).thresholds(scale.levels)(flat)) {
      context.globalAlpha = 0.55;
      context.beginPath();
      for (const ring of line.coordinates.flat().filter(({ length }) => length >= smallestRing)) {
        const points = ring.map(
          ([column, row]) =>
            /** @type {const} */ ([frame.left + (column - 0.5) * wide, frame.bottom - (row - 0.5) * high]),
        );
        through(context, points);
      }
      context.stroke();
    }
  });
}

/** @param {CanvasRenderingContext2D} context @param {CostScale} scale @param {number} width */
function drawLegend(context, scale, width) {
  const [left, right] = [margin.left, width - margin.right];
  const colours = context.createLinearGradient(left, 0, right, 0);
  for (let i = 0; i <= 16; i += 1) colours.addColorStop(i / 16, shadeAt(i / 16));
  context.fillStyle = colours;
  context.fillRect(left, 0, right - left, 12);
  setLettering(context, { align: 'center', baseline: 'top' });
  let free = left;
  for (const { part, text } of numbersAt(scale)) {
    const px = left + part * (right - left);
    context.fillRect(px - 0.5, 12, 1, 4);
    const half = context.measureText(text).width / 2;
    const middle = Math.min(Math.max(px, left + half), right - half);
    if (middle - half < free) continue;
    context.fillText(text, middle, 18);
    free = middle + half + apart;
  }
  context.textAlign = 'left';
  context.fillText(words.legendLow, 8, 18);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Spec} spec */
function drawAxes(context, { frame, x, y }, spec) {
  drawFrame(context, frame);
  const across = x.ticks.filter((tick) => x.at(tick) < frame.right - 30);
  drawNumbersBelow(context, x.at, frame.bottom, across, across.map(String));
  const up = y.ticks.filter((tick) => y.at(tick) > frame.top + 26);
  drawNumbersBeside(context, y.at, frame.left - 8, up, up.map(String));
  const symbol = (/** @type {Spec['x']} */ { gain }, /** @type {number} */ px, /** @type {number} */ py) =>
    drawSymbol(context, lab.gains[gainNames.indexOf(gain)], gain.replace('k', '--'), px, py);
  symbol(spec.x, frame.right - 8, frame.bottom + 19);
  symbol(spec.y, frame.left - 24, frame.top + 13);
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {MapModel} model */
function drawMarks(context, { frame, x, y }, { spec, population, hasCrosses, sketch, path, points, cursor }) {
  const [across, up] = [gainNames.indexOf(spec.x.gain), gainNames.indexOf(spec.y.gain)];
  /** @param {Triple} gains @returns {[number, number]} */
  const place = (gains) => [x.at(gains[across]), y.at(gains[up])];
  within(context, frame, () => {
    context.strokeStyle = light;
    context.lineWidth = 1;
    context.globalAlpha = 0.35;
    context.beginPath();
    for (const { gains, sigmas } of hasCrosses ? population : []) {
      const [px, py] = place(gains);
      context.moveTo(x.at(gains[across] - sigmas[across]), py);
      context.lineTo(x.at(gains[across] + sigmas[across]), py);
      context.moveTo(px, y.at(gains[up] - sigmas[up]));
      context.lineTo(px, y.at(gains[up] + sigmas[up]));
    }
    context.stroke();
    context.globalAlpha = 1;

    context.beginPath();
    for (const gains of path) context.lineTo(...place(gains));
    strokeTwice(context, [dark, 4], [light, 2]);

    if (sketch) drawSketch(context, { x, y }, sketch);

    context.lineWidth = 1;
    context.strokeStyle = dark;
    context.fillStyle = light;
    for (const { gains } of [...population].reverse()) {
      context.globalAlpha = isInSlice(spec, gains) ? 1 : pale;
      disc(context, place(gains), 3.5);
    }
    context.globalAlpha = isInSlice(spec, population[0].gains) ? 1 : pale;
    context.fillStyle = dark;
    context.strokeStyle = light;
    context.lineWidth = 2;
    disc(context, place(population[0].gains), 6);
    context.globalAlpha = 1;

    if (cursor) {
      context.strokeStyle = light;
      context.lineWidth = 1;
      context.beginPath();
      context.moveTo(x.at(cursor[0]), frame.top);
      context.lineTo(x.at(cursor[0]), frame.bottom);
      context.moveTo(frame.left, y.at(cursor[1]));
      context.lineTo(frame.right, y.at(cursor[1]));
      context.stroke();
    }
  });

  const held = points.filter(({ gains }) => x.holds(gains[across]) && y.holds(gains[up]));
  drawPoints(
    context,
    frame,
    held.map((point) => ({ ...point, place: place(point.gains), isPale: !isInSlice(spec, point.gains) })),
    [place(population[0].gains)],
  );
}

/** @param {CanvasRenderingContext2D} context @param {readonly [number, number]} place @param {number} radius */
function disc(context, [px, py], radius) {
  circle(context, px, py, radius);
  context.fill();
  context.stroke();
}

/** How many lie outside. @param {Spec} spec @param {Individual[]} population */
export function countOutside({ x, y, range }, population) {
  const isOutside = (/** @type {Spec['x']} */ axis, /** @type {Triple} */ gains) => {
    const [low, high] = endsOfAxis(axis, range);
    const gain = gains[gainNames.indexOf(axis.gain)];
    return gain < low || gain > high;
  };
  return population.filter(({ gains }) => isOutside(x, gains) || isOutside(y, gains)).length;
}
