// The picture of a contest over the drives: above, J with its quartiles and the target; below, the share that has reached it.
/** @import { Frame, Scale } from '../../kit/chart.js' */
/** @import { Contest } from './contest-request.js' */
/** @import { Standings } from './contest-summary.js' */
import { scaleLinear, scaleLog } from 'd3-scale';
import {
  createChart,
  drawBand,
  drawCurve,
  drawGrid,
  drawNumbersBelow,
  drawUpright,
  frameIn,
  pointsOf,
  within,
} from '../../kit/chart.js';
import { remember } from '../../kit/memo.js';
import { drawName, gutterOf, spread } from '../../kit/names.js';
import { drawMark } from '../../kit/swatch.js';
import { colour } from '../../kit/palette.js';
import { styles } from '../../run/pins.js';
import { costAt, shareAt } from './contest-statistics.js';
import { quartilesOf } from './statistics.js';
import words from './words/index.js';

/** @typedef {{ contest: Contest | null, standings: Standings | null, budget: number, theme: number }} ContestChartModel */
/** Quartiles of J at each of the drives, and the share that has reached the target. @typedef {{ low: number[], median: number[], high: number[], share: number[] }} Course */

const steps = 160;
/** Distances under this are shown as this. */
const smallest = 1e-6;
/** Where there is less height, the shares have no room. */
const roomForBoth = 180;
const between = 14;
/** In pixels, beside the lines. */
const roomForNames = 80;
/** The picture begins with so many drives to choose its heights by. */
const firstDrives = 5;

/** Whole numbers, evenly on a logarithm. @param {number} budget */
export const drivesOn = (budget) => [
  ...new Set(Array.from({ length: steps + 1 }, (_, i) => Math.round(budget ** (i / steps)))),
];

/** @param {Contest} contest @param {Standings} standings @param {readonly number[]} drives @returns {(Course | null)[]} */
const coursesOf = ({ lines }, standings, drives) =>
  lines.map(({ trials }, i) => {
    if (trials.length === 0) return null;
    const quartiles = drives.map((drive) => quartilesOf(trials.map((trial) => costAt(trial, drive))));
    return {
      low: quartiles.map(({ low }) => low),
      median: quartiles.map(({ median }) => median),
      high: quartiles.map(({ high }) => high),
      share: drives.map((drive) => shareAt(standings.lines[i].runtimes, drive)),
    };
  });

/** @param {HTMLElement} root @param {(target: number) => void} onTarget */
export function createContestChart(root, onTarget) {
  /** What a height means. @type {((y: number) => number) | null} */
  let targetAt = null;
  const chart = createChart(root, (context, size, /** @type {ContestChartModel} */ model) => {
    const whole = frameIn(size, { top: 20, right: gutterOf(size) });
    const hasBoth = size.height >= roomForBoth;
    const middle = Math.round(whole.top + 0.62 * (whole.bottom - whole.top));
    const upper = hasBoth ? { ...whole, bottom: middle } : whole;
    const lower = hasBoth ? { ...whole, top: middle + between } : null;
    targetAt = draw(context, upper, lower, model);
  });
  const { canvas } = chart;
  const drag = (/** @type {PointerEvent} */ { offsetY }) => {
    if (targetAt) onTarget(targetAt(offsetY));
  };
  canvas.addEventListener('pointerdown', (event) => {
    // A finger that moves over it scrolls the page; the field says the same.
    if (event.button !== 0 || event.pointerType === 'touch') return;
    canvas.setPointerCapture(event.pointerId);
    drag(event);
  });
  canvas.addEventListener('pointermove', (event) => {
    if (canvas.hasPointerCapture(event.pointerId)) drag(event);
  });
  return chart;
}

const courses = remember(coursesOf);
const drivesUpTo = remember(drivesOn);

/** @param {CanvasRenderingContext2D} context @param {Frame} upper @param {Frame | null} lower @param {ContestChartModel} model */
function draw(context, upper, lower, { contest, standings, budget }) {
  const drives = drivesUpTo(contest?.budget ?? budget);
  const x = scaleLog([1, drives[drives.length - 1]], [upper.left, upper.right]);
  const ticks = powersIn([1, drives[drives.length - 1]]);
  const found = contest && standings ? courses(contest, standings, drives) : [];
  const place = drawCosts(context, upper, { x, ticks, drives, found, standings });
  if (lower) drawShares(context, lower, { x, ticks, drives, found });
  const { bottom } = lower ?? upper;
  drawNumbersBelow(context, x, bottom, ticks, ticks.map(words.wholeNumber));
  drawName(context, { text: words.drivesAxis, x: upper.right + 8, y: bottom + 13 });
  const end = { ...upper, bottom };
  drawUpright(context, upper.right, end, { token: '--muted', width: 1, dash: [4, 3] });
  return place;
}

/** @param {readonly [number, number]} range */
function powersIn([from, to]) {
  const first = Math.ceil(Math.log10(from) - 1e-9);
  const last = Math.floor(Math.log10(to) + 1e-9);
  return Array.from({ length: Math.max(0, last - first + 1) }, (_, i) => 10 ** (first + i));
}

/** @typedef {{ x: Scale, ticks: number[], drives: readonly number[], found: readonly (Course | null)[] }} Panel */

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Panel & { standings: Standings | null }} panel @returns {((y: number) => number) | null} */
function drawCosts(context, frame, { x, ticks, drives, found, standings }) {
  const lowest = standings?.lowest?.cost;
  if (lowest === undefined || !standings) {
    const y = scaleLinear([0, 1], [frame.bottom, frame.top]);
    drawGrid(context, { x, y, frame }, { x: ticks, y: [] }, []);
    drawName(context, { text: words.costSymbol, x: frame.left - 50, y: 8 });
    return null;
  }
  const distance = (/** @type {number} */ cost) => Math.max(cost - lowest, smallest);
  const range = rangeOf(found, drives, distance, standings.target);
  const y = scaleLog(range, [frame.bottom, frame.top]);
  const powers = powersIn(range);
  const names = powers.map((power) => words.powerOfTen(Math.round(Math.log10(power))));
  drawGrid(context, { x, y, frame }, { x: ticks, y: powers }, names);
  const points = (/** @type {number[]} */ costs) =>
    pointsOf(
      { x, y, frame },
      drives,
      costs.map((cost) => (Number.isFinite(cost) ? distance(cost) : Number.NaN)),
    );
  within(context, frame, () => {
    for (const [i, course] of found.entries()) {
      if (!course) continue;
      drawBand(context, points(course.high), points(course.low), styles[i].token, 0.13);
    }
    for (const [i, course] of found.entries())
      if (course) drawCurve(context, points(course.median), { ...styles[i], width: 2.5 });
  });
  drawTarget(context, frame, y(distance(standings.target)), standings.target);
  drawEnds(context, frame, found, standings, (cost) => y(distance(cost)));
  drawName(context, { text: words.distanceAxis(lowest), x: frame.left - 50, y: 8 });
  return (py) => lowest + y.invert(Math.min(Math.max(py, frame.top), frame.bottom));
}

/** From the nearest of the ends to what few drives give. @param {readonly (Course | null)[]} found @param {readonly number[]} drives @param {(cost: number) => number} distance @param {number} target @returns {[number, number]} */
function rangeOf(found, drives, distance, target) {
  const begin = drives.findIndex((drive) => drive >= firstDrives);
  const there = found.filter((course) => course !== null);
  const ends = there.map(({ low }) => distance(low[low.length - 1]));
  const begins = there.map(({ median }) => distance(median[begin])).filter(Number.isFinite);
  const low = Math.min(distance(target), ...ends.filter(Number.isFinite));
  const high = Math.max(distance(target), low, ...begins);
  return [low / 2, 1.5 * Math.max(high, 10 * low)];
}

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {number} py @param {number} target */
function drawTarget(context, frame, py, target) {
  if (!(py >= frame.top - 1 && py <= frame.bottom + 1)) return;
  /** @type {[number, number][]} */
  const ends = [
    [frame.left, py],
    [frame.right, py],
  ];
  drawCurve(context, ends, { token: '--ink', width: 1, dash: [3, 3] });
  drawName(context, { text: words.targetLine(target), x: frame.left + 4, y: py - 9, token: '--ink' });
}

/** The names at the ends of the lines. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {readonly (Course | null)[]} found @param {Standings} standings @param {(cost: number) => number} y */
function drawEnds(context, frame, found, standings, y) {
  const places = found.flatMap((course, i) => {
    const end = course?.median.at(-1);
    if (end === undefined || !Number.isFinite(end)) return [];
    const at = Math.min(Math.max(y(end), frame.top), frame.bottom);
    return [{ at, y: at, style: styles[i], text: words.shortName(standings.lines[i].name) }];
  });
  if (places.length === 0) return;
  const edge = colour('--paper');
  for (const { at, style } of places)
    drawMark(context, style.mark, frame.right, at, { fill: colour(style.token), edge });
  // Where there is no room beside the lines, their marks say whose they are.
  if (context.canvas.clientWidth - frame.right < roomForNames) return;
  spread(places, frame.top, frame.bottom);
  for (const { text, y: py, style } of places)
    drawName(context, { text, x: frame.right + 8, y: py, token: style.token });
}

/** @param {CanvasRenderingContext2D} context @param {Frame} frame @param {Panel} panel */
function drawShares(context, frame, { x, ticks, drives, found }) {
  const y = scaleLinear([0, 1], [frame.bottom, frame.top]);
  const shares = [0, 0.5, 1];
  drawGrid(context, { x, y, frame }, { x: ticks, y: shares }, shares.map(words.percent));
  for (const [i, course] of found.entries())
    if (course)
      drawCurve(context, pointsOf({ x, y, frame }, drives, course.share), { ...styles[i], width: 2 });
  context.setLineDash([]);
  drawName(context, { text: words.shareAxis, x: frame.left + 4, y: frame.top + 8 });
}
