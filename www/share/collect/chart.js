// The class at a glance: how many have which J, and where their gains lie.
/** @import { Given, Row } from './check.js' */
import { scaleLinear } from 'd3-scale';
import {
  createChart,
  drawGrid,
  drawNumbersBelow,
  drawUpright,
  frameIn,
  sameDigits,
  ticksOn,
  wholeTicks,
  within,
} from '../../kit/chart.js';
import { byId } from '../../kit/elements.js';
import { once } from '../../kit/memo.js';
import { drawAxisNames } from '../../kit/names.js';
import { colour } from '../../kit/palette.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';

/** @typedef {{ cost: number, gains: readonly number[], isMet: boolean }} Point */
/** @typedef {{ points: readonly Point[], aim: number | null, theme: number }} Model */

const bins = 24;
/** What is farther out than this share of the class stands at the edge. */
const inside = 0.9;
/** Above and beside the lines, for the names of the axes. */
const room = { top: 20, right: 44 };

/** Both, made when there is something to draw first. */
export function createCharts() {
  const charts = once(() => [
    createHistogram(byId('collect-histogram')),
    createGainsPlane(byId('collect-gains')),
  ]);
  return {
    /** @param {readonly Row[]} rows @param {Given | null} given @param {number} theme */
    draw(rows, given, theme) {
      const aim = given?.run.exercise.aim?.wanted;
      const model = { points: pointsIn(rows), aim: aim?.kind === 'cost' ? aim.below : null, theme };
      for (const chart of charts()) chart.draw(model);
    },
  };
}

/** @param {readonly Row[]} rows @returns {Point[]} */
const pointsIn = (rows) =>
  rows.flatMap(({ checked }) =>
    checked && Number.isFinite(checked.cost)
      ? [{ cost: checked.cost, gains: checked.gains, isMet: checked.judged?.isMet ?? false }]
      : [],
  );

/** From the least to where all but a few are. @param {readonly number[]} values @returns {[number, number]} */
function reach(values) {
  const inOrder = [...values].sort((a, b) => a - b);
  const low = inOrder[0] ?? 0;
  const high = inOrder[Math.floor(inside * (inOrder.length - 1))] ?? 1;
  const room = 0.05 * (high - low) || 0.5;
  return [low - room, high + room];
}

/** @param {boolean} isMet */
const ink = (isMet) => colour(isMet ? '--theta' : '--muted');

/** @param {HTMLElement} root */
const createHistogram = (root) =>
  createChart(root, (context, size, /** @type {Model} */ { points, aim }) => {
    const frame = frameIn(size, room);
    const costs = points.map(({ cost }) => cost);
    const domain = reach(aim === null ? costs : [...costs, aim]);
    const x = scaleLinear(domain, [frame.left, frame.right]);
    const step = (domain[1] - domain[0]) / bins;
    /** @type {[met: number, not: number][]} */
    const counts = Array.from({ length: bins }, () => [0, 0]);
    for (const { cost, isMet } of points) {
      const bin = Math.min(bins - 1, Math.max(0, Math.floor((cost - domain[0]) / step)));
      counts[bin][isMet ? 0 : 1] += 1;
    }
    const most = Math.max(1, ...counts.map(([met, not]) => met + not));
    const y = scaleLinear([0, most], [frame.bottom, frame.top + 4]);
    const ticks = { x: ticksOn(x, 64), y: wholeTicks(y) };
    drawGrid(context, { frame, x, y }, { x: [], y: ticks.y }, ticks.y.map(String));
    drawNumbersBelow(context, x, frame.bottom, ticks.x, sameDigits(ticks.x));
    within(context, frame, () => {
      for (const [bin, [met, not]] of counts.entries())
        for (const [from, to, isMet] of /** @type {const} */ ([
          [0, met, true],
          [met, met + not, false],
        ])) {
          context.fillStyle = ink(isMet);
          const left = x(domain[0] + bin * step);
          context.fillRect(left + 1, y(to), x(domain[0] + (bin + 1) * step) - left - 2, y(from) - y(to));
        }
      if (aim !== null) drawUpright(context, x(aim), frame, { token: '--ink', width: 1.5, dash: [4, 3] });
    });
    drawAxisNames(context, { ...frame, top: 2 }, { x: words.texts.costAxis, y: words.texts.countAxis });
  });

/** @param {HTMLElement} root */
const createGainsPlane = (root) =>
  createChart(root, (context, size, /** @type {Model} */ { points }) => {
    const frame = frameIn(size, room);
    const [x, y] = [0, 2].map((gain, i) =>
      scaleLinear(
        reach(points.map(({ gains }) => gains[gain])),
        i === 0 ? [frame.left, frame.right] : [frame.bottom, frame.top],
      ).clamp(true),
    );
    const ticks = { x: ticksOn(x, 64), y: ticksOn(y, 32) };
    drawGrid(context, { frame, x, y }, ticks, sameDigits(ticks.y));
    drawNumbersBelow(context, x, frame.bottom, ticks.x, sameDigits(ticks.x));
    context.lineWidth = 1;
    for (const { gains, isMet } of points) {
      context.beginPath();
      context.arc(x(gains[0]), y(gains[2]), 3.5, 0, 2 * Math.PI);
      context.strokeStyle = ink(isMet);
      context.fillStyle = ink(isMet);
      // Not by colour alone.
      if (isMet) context.fill();
      context.stroke();
    }
    drawAxisNames(context, { ...frame, top: 2 }, { x: lab.gains[0].name, y: lab.gains[2].name });
  });
