// The gains that the seeds ended with: a strip for each gain, one dot a seed.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Dots } from './dots.js' */
/** @import { SeedSurvey } from './request.js' */
import { createWatchedLayer } from '../../kit/canvas.js';
import { scaleLinear } from 'd3-scale';
import { followSize } from '../../kit/size.js';
import { take } from '../../kit/chart.js';
import { colour } from '../../kit/palette.js';
import { stacked } from '../../kit/stack.js';
import { drawText, numbersApart } from '../drawing.js';
import { setLettering } from '../../kit/lettering.js';
import { drawSymbol } from '../../kit/names.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { diameterOf, drawDots, drawRing, nearestDot, stackDots } from './dots.js';

/** @typedef {{ survey: SeedSurvey | null, paper: Triple | null, range: readonly [number, number], index: number, theme: number }} StripsModel */

const colours = /** @type {const} */ (['--x', '--y', '--theta']);
const atMedian = /** @type {const} */ ({ token: '--ink', align: 'right', baseline: 'alphabetic' });
const axisHeight = 18;
const margin = { left: 34, right: 64, top: 2 };
const diamond = /** @type {const} */ ([
  [0, -6],
  [6, 0],
  [0, 6],
  [-6, 0],
]);

/** @param {HTMLCanvasElement} canvas @param {{ onPoint: (index: number) => void, onChoose: (index: number) => void }} on */
export function createStrips(canvas, { onPoint, onChoose }) {
  const drawWatched = createWatchedLayer(canvas);
  /** @type {Dots[]} */
  let strips = [];
  /** @type {StripsModel | null} */
  let model = null;

  const draw = () => {
    const shown = model;
    const size = sizeOf();
    if (shown)
      drawWatched(size, Object.values(shown), (context) => {
        strips = drawStrips(context, size, shown);
      });
  };
  const sizeOf = followSize(canvas, draw);

  /** The seed whose dot is there. @param {PointerEvent | MouseEvent} event */
  const at = (event) => {
    const { left, top } = canvas.getBoundingClientRect();
    const strip = stripIn(sizeOf());
    const i = Math.min(2, Math.max(0, Math.floor((event.clientY - top) / strip)));
    const base = (i + 1) * strip;
    return strips[i] ? nearestDot(strips[i], event.clientX - left, base - (event.clientY - top)) : -1;
  };
  canvas.addEventListener('pointermove', (event) => onPoint(at(event)));
  canvas.addEventListener('pointerleave', () => onPoint(-1));
  canvas.addEventListener('click', (event) => onChoose(at(event)));

  return {
    /** @param {StripsModel} next */
    draw(next) {
      model = next;
      draw();
    },
  };
}

/** The height of one. @param {import('../../kit/canvas.js').Size} size */
const stripIn = ({ height }) => (height - axisHeight) / 3;

/** @param {CanvasRenderingContext2D} context @param {import('../../kit/canvas.js').Size} size @param {StripsModel} model @returns {Dots[]} */
function drawStrips(context, size, { survey, paper, range, index }) {
  const strip = stripIn(size);
  const scale = scaleLinear()
    .domain(survey ? domainOf(survey, paper) : range)
    .range([margin.left, size.width - margin.right])
    .clamp(true);
  drawAxis(context, scale, size.height);
  const room = strip - margin.top - 4;
  const diameter = Math.min(room / lines, diameterOf(survey?.count ?? 1));
  /** @type {Dots[]} */
  const strips = [];
  for (const [i, name] of colours.entries()) {
    const base = Math.round((i + 1) * strip) - 0.5;
    drawSymbol(context, lab.gains[i], name, 0, base - 6);
    context.fillStyle = colour('--hairline');
    context.fillRect(margin.left, base, size.width - margin.left - margin.right, 1);
    if (survey) {
      const positions = survey.runs.map(({ champion }) => scale(champion.gains[i]));
      const dots = dotsIn(positions, diameter, room, scale.range());
      strips.push(dots);
      drawDots(context, dots, diameter, name, (along, away) => [along, base - away]);
      if (index >= 0) drawRing(context, dots.along[index], base - dots.away[index]);
    }
    if (paper) drawDiamond(context, scale(paper[i]), base);
    if (survey)
      drawText(context, words.medianGain(survey.summary.gains[i].median), size.width, base - 6, atMedian);
  }
  return strips;
}

/** A strip is low, and often all seeds end with the same gain: at least so many dots have room above each other, and who finds its place full may stand so many diameters aside. */
const [lines, mostAside] = [5, 2];

/** Too many to be counted overlap, each above its own place. @param {readonly number[]} positions Pixels along the axis. @param {number} diameter @param {number} room Pixels above it. @param {readonly number[]} ends Of the axis. @returns {Dots} */
export function dotsIn(positions, diameter, room, ends) {
  const bins = positions.map((position) => Math.round(position / diameter));
  const most = Math.floor(room / diameter + 1e-9);
  const [first, last] = ends.map((end) => Math.round(end / diameter));
  const places = stacked(bins, most, mostAside, [first, last]);
  if (places.some(({ level }) => level >= most)) return stackDots(positions, diameter, room);
  return {
    along: Float64Array.from(places, ({ column }) => column * diameter),
    away: Float64Array.from(places, ({ level }) => (level + 0.5) * diameter),
  };
}

/** All but the strangest gains; those stand at the end. @param {SeedSurvey} survey @param {Triple | null} paper @returns {[number, number]} */
function domainOf({ summary }, paper) {
  const reach = summary.gains.map(({ low, high, least, most }) => [
    Math.max(least, low - 6 * (high - low)),
    Math.min(most, high + 6 * (high - low)),
  ]);
  const low = Math.min(0, ...reach.map(([end]) => end));
  const high = Math.max(...(paper ?? []), ...reach.map(([, end]) => end));
  return [low, high + 0.02 * (high - low)];
}

/** @param {CanvasRenderingContext2D} context @param {import('d3-scale').ScaleLinear<number, number>} scale @param {number} height */
function drawAxis(context, scale, height) {
  setLettering(context, {});
  const widthOf = (/** @type {string} */ text) => context.measureText(text).width;
  for (const { tick, text } of numbersApart(scale, 7, words.ticks, widthOf)) {
    context.fillStyle = colour('--hairline');
    context.fillRect(Math.floor(scale(tick)), 0, 1, height - axisHeight + 2);
    drawText(context, text, scale(tick), height - 3, { align: 'center', baseline: 'alphabetic' });
  }
}

/** The paper's gain. @param {CanvasRenderingContext2D} context @param {number} x @param {number} y */
function drawDiamond(context, x, y) {
  context.beginPath();
  for (const [dx, dy] of diamond) context.lineTo(x + dx, y + dy);
  context.closePath();
  context.fillStyle = colour('--paper');
  context.fill();
  take(context, { token: '--muted', width: 2 });
  context.stroke();
}
