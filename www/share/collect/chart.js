// The class at a glance: how many have which J, and where their gains lie.
/** @import { Frame } from '../../kit/chart.js' */
/** @import { Kind, Point } from './bins.js' */
/** @import { Given, Row } from './check.js' */
import { scaleLinear } from 'd3-scale';
import { html } from 'lit-html';
import {
  createChart,
  drawGrid,
  drawNumbersBelow,
  drawUpright,
  frameIn,
  line,
  take,
  levelsOn,
  ticksOn,
  within,
} from '../../kit/chart.js';
import { byId } from '../../kit/elements.js';
import { extentOf } from '../../kit/extent.js';
import { once, remember } from '../../kit/memo.js';
import { drawAxisNames } from '../../kit/names.js';
import { colour } from '../../kit/palette.js';
import { sameDigits } from '../../kit/steps.js';
import { lab } from '../../words/index.js';
import { binsOf, kinds, reach } from './bins.js';
import words from './words/index.js';

/** @typedef {{ points: readonly Point[], aim: number | null, theme: number }} Model */

/** Above and beside the lines, for the names of the axes. */
const room = { top: 20, right: 44 };
/** For what is beyond the axis: its bar, and how far that is set apart. */
const apart = { width: 30, gap: 22 };
/** The gains that are drawn, across and up. */
const [across, up] = [0, 2];

/** Not by colour alone: filled, empty, struck through. @type {Readonly<Record<Kind, string>>} */
const tokens = { met: '--theta', not: '--muted', unjudged: '--muted' };

/** Both, made when there is something to draw first. */
export function createCharts() {
  const charts = once(() => [
    createHistogram(byId('collect-histogram')),
    createGainsPlane(byId('collect-gains')),
  ]);
  return {
    /** @param {readonly Row[]} rows @param {Given | null} given @param {number} theme */
    draw(rows, given, theme) {
      const model = { points: pointsIn(rows, given), aim: costAim(given), theme };
      for (const chart of charts()) chart.draw(model);
    },
  };
}

/** @param {Given | null} given */
function costAim(given) {
  const wanted = given?.run.exercise.aim?.wanted;
  return wanted?.kind === 'cost' ? wanted.below : null;
}

/** Where nothing is aimed at all look alike. The same for the same class, which is then not drawn anew. */
const pointsIn = remember((/** @type {readonly Row[]} */ rows, /** @type {Given | null} */ given) =>
  rows.flatMap(({ checked }) => {
    if (!checked || !Number.isFinite(checked.cost)) return [];
    const { cost, gains, judged } = checked;
    const kind = judged ? (judged.isMet ? 'met' : 'not') : given?.run.exercise.aim ? 'unjudged' : 'not';
    return [/** @type {Point} */ ({ cost, gains, kind })];
  }),
);

/** What the two pictures show, in words. @param {readonly Row[]} rows @param {Given | null} given */
export function labelsOf(rows, given) {
  const points = pointsIn(rows, given);
  const costs = points.map(({ cost }) => cost).sort((a, b) => a - b);
  if (costs.length === 0) return { histogram: words.texts.histogram, gains: words.texts.gains };
  const half = Math.ceil(costs.length / 2) - 1;
  const [least, middle, most] = [0, half, costs.length - 1].map((i) => lab.costText(costs[i]));
  const reaches = [across, up].map((gain) => {
    const [low, high] = extentOf([points.map(({ gains }) => gains[gain])]).map((end) => lab.fixed(end, 2));
    return words.reachText(lab.gains[gain].name, low, high);
  });
  return {
    histogram: words.histogramLabel(costs.length, least, middle, most),
    gains: words.gainsLabel(reaches),
  };
}

/** What the marks in both pictures mean, of those that are there. @param {readonly Row[]} rows @param {Given | null} given */
export function legendOf(rows, given) {
  const points = pointsIn(rows, given);
  const [x, y] = [across, up].map((gain) => reach(points.map(({ gains }) => gains[gain])));
  const isFar = points.some(({ gains }) => isBeyond(gains[across], x) || isBeyond(gains[up], y));
  const there = given?.run.exercise.aim
    ? kinds.filter((kind) => points.some((one) => one.kind === kind))
    : [];
  const names = [...there, ...(costAim(given) === null ? [] : ['aim']), ...(isFar ? ['far'] : [])];
  return names.map(
    (name) =>
      html`<li><svg class="mark-${name}" viewBox="-7 -7 14 14" width="14" height="14" aria-hidden="true"><path d=${marks[name]}></path></svg>${words.legend[name]}</li>`,
  );
}

const circle = 'M3.5 0A3.5 3.5 0 1 1 -3.5 0 3.5 3.5 0 1 1 3.5 0Z';
/** @type {Readonly<Record<string, string>>} */
const marks = {
  met: circle,
  not: circle,
  unjudged: 'M-3-3 3 3M-3 3 3-3',
  aim: 'M0-7V7',
  far: 'M5 0-3 4V-4Z',
};

/** @param {readonly [number, number]} domain @returns {[number, number]} */
function padded([low, high]) {
  const pad = 0.05 * (high - low) || 0.5;
  return [low - pad, high + pad];
}

/** @param {number} value @param {readonly [number, number]} domain */
const isBeyond = (value, [low, high]) => value < low || value > high;

/** @param {HTMLElement} root */
const createHistogram = (root) =>
  createChart(root, (context, size, /** @type {Model} */ { points, aim }) => {
    const { bins, beyond, first, step } = binsOf(points, aim);
    const sum = (/** @type {typeof beyond} */ { met, not, unjudged }) => met + not + unjudged;
    const hasMore = sum(beyond) > 0;
    const whole = frameIn(size, room);
    const frame = { ...whole, right: whole.right - (hasMore ? apart.width + apart.gap : 0) };
    const x = scaleLinear([first, first + bins.length * step], [frame.left, frame.right]);
    const y = scaleLinear([0, Math.max(1, sum(beyond), ...bins.map(sum))], [frame.bottom, frame.top + 4]);
    const counts = ticksOn(y, 26, { factors: [1, 2, 5], least: 1 });
    const costs = ticksOn(x, 64);
    drawGrid(context, { frame: whole, x, y }, { x: [], y: counts }, counts.map(String));
    drawNumbersBelow(context, x, frame.bottom, costs, sameDigits(costs));
    for (const [i, bin] of bins.entries())
      drawBar(context, [x(first + i * step) + 1, x(first + (i + 1) * step) - 1], y, bin);
    if (hasMore) {
      const left = whole.right - apart.width;
      // The lines do not go through from one to the other.
      context.clearRect(frame.right + 4, frame.top, left - frame.right - 8, frame.bottom - frame.top + 2);
      drawBar(context, [left + 3, whole.right - 3], y, beyond);
      const middle = left + apart.width / 2;
      const inMiddle = scaleLinear([0, 1], [middle, middle]);
      drawNumbersBelow(context, inMiddle, frame.bottom, [0], [words.texts.larger]);
    }
    if (aim !== null) drawUpright(context, x(aim), frame, { token: '--ink', width: 1.5, dash: [4, 3] });
    drawAxisNames(context, { ...whole, top: 2 }, { x: words.texts.costAxis, y: words.texts.countAxis });
  });

/** One kind on the other. @param {CanvasRenderingContext2D} context @param {[number, number]} ends @param {(count: number) => number} y @param {Readonly<Record<Kind, number>>} counts */
function drawBar(context, [left, right], y, counts) {
  let from = 0;
  for (const kind of kinds) {
    const to = from + counts[kind];
    if (to > from) drawPiece(context, { left, right, top: y(to), bottom: y(from) }, kind);
    from = to;
  }
}

/** @param {CanvasRenderingContext2D} context @param {Frame} box @param {Kind} kind */
function drawPiece(context, box, kind) {
  const { left, right, top, bottom } = box;
  const [width, height] = [right - left, bottom - top];
  context.fillStyle = colour(kind === 'met' ? tokens.met : '--panel');
  context.fillRect(left, top, width, height);
  if (kind === 'met') return;
  take(context, { token: tokens[kind], width: 1 });
  context.strokeRect(left + 0.5, top + 0.5, Math.max(1, width - 1), Math.max(1, height - 1));
  if (kind === 'unjudged')
    within(context, box, () => {
      context.beginPath();
      for (let at = left - height; at < right; at += 6) line(context, [at, bottom], [at + height, top]);
      context.stroke();
    });
}

/** @param {HTMLElement} root */
const createGainsPlane = (root) =>
  createChart(root, (context, size, /** @type {Model} */ { points }) => {
    const frame = frameIn(size, room);
    const domains = [across, up].map((gain) => reach(points.map(({ gains }) => gains[gain])));
    const x = scaleLinear(padded(domains[0]), [frame.left, frame.right]).clamp(true);
    const y = scaleLinear(padded(domains[1]), [frame.bottom, frame.top]).clamp(true);
    const ticks = { x: ticksOn(x, 64), y: levelsOn(y) };
    drawGrid(context, { frame, x, y }, ticks, sameDigits(ticks.y));
    drawNumbersBelow(context, x, frame.bottom, ticks.x, sameDigits(ticks.x));
    for (const { gains, kind } of points) {
      const outward = [across, up].map((gain, i) =>
        isBeyond(gains[gain], domains[i]) ? Math.sign(gains[gain] - domains[i][0]) : 0,
      );
      context.save();
      context.translate(x(gains[across]), y(gains[up]));
      drawPoint(context, outward, kind);
      context.restore();
    }
    drawAxisNames(context, { ...frame, top: 2 }, { x: lab.gains[across].name, y: lab.gains[up].name });
  });

/** A point, or at the edge where it would be beyond it a mark that points there. @param {CanvasRenderingContext2D} context @param {readonly number[]} outward @param {Kind} kind */
function drawPoint(context, [right, above], kind) {
  take(context, { token: tokens[kind], width: 1 });
  context.fillStyle = colour(tokens[kind]);
  const isFar = right !== 0 || above !== 0;
  if (isFar) context.rotate(Math.atan2(-above, right));
  const mark = new Path2D(isFar ? marks.far : marks[kind]);
  if (kind === 'met') context.fill(mark);
  context.stroke(mark);
}
