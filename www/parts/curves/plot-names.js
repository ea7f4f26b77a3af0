// What the lines of a plot are called, at their ends and in their colours.
/** @import { Run } from '../../core/engine.js' */
/** @import { Axes } from '../../kit/chart.js' */
/** @import { Column, Plot, PlotName } from './layout.js' */
import { fillTextWithHalo } from '../../kit/canvas.js';
import { setLettering, symbolFont, textFont } from '../../kit/lettering.js';
import { colour } from '../../kit/palette.js';
import { drawText } from '../drawing.js';
import { rememberEach } from '../../kit/memo.js';
import { labelHeight, spread } from '../../kit/names.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { curvesOf } from './layout.js';

/** @type {Readonly<Record<PlotName, readonly string[]>>} */
export const tokens = {
  position: ['--x', '--y'],
  theta: ['--theta'],
  linear: ['--energy'],
  angular: ['--omega'],
  cost: ['--ink'],
};

/** The parts of J that are paid on the way, from the bottom. @type {readonly (readonly [string, string, Column])[]} */
export const parts = [
  ['time', '--ink', (run) => run.time],
  ['path', '--path', rememberEach((run) => run.time.map((time, i) => time + run.pathCost[i]))],
  ['energy', '--energy', curvesOf.cost[0]],
];

/** @typedef {{ text: string, token: string, font: string, y: number }} Name */

/** The names at the ends of the lines. @param {CanvasRenderingContext2D} context @param {Plot} plot @param {Run} run */
export function drawNames(context, plot, run) {
  const { name, frame } = plot;
  const px = frame.right + 8;
  const half = 8;
  const all = namesOf(plot, run);
  const isLow = (all.length - 1) * labelHeight > frame.bottom - frame.top - 2 * half;
  // Where there is no room for all, the letter of what is drawn stands within.
  if (isLow && name === 'cost')
    drawText(context, lab.costSymbol, frame.left + 5, frame.top + half, { font: symbolFont, token: '--ink' });
  const beside = isLow && name === 'cost' ? all.filter((one) => one.font !== symbolFont) : all;
  const names = beside.map(({ y, ...rest }) => ({
    ...rest,
    y: Math.min(Math.max(y, frame.top + half), frame.bottom - half),
  }));
  spread(names, frame.top + half, frame.bottom - half);
  for (const { text, token, font, y } of names) drawText(context, text, px, y, { token, font });
  if (name === 'cost') return;
  const symbols = names.filter((one) => one.font === symbolFont);
  const wide = Math.max(...symbols.map(({ text }) => context.measureText(text).width));
  const middle = symbols.reduce((sum, { y }) => sum + y, 0) / symbols.length;
  drawText(context, words.units[name], px + wide + 5, middle);
}

/** The sample at which x and y are farthest apart. */
export const widestGap = rememberEach((/** @type {Run} */ { x, y }) => {
  let [widest, at] = [0, 0];
  for (let i = 0; i < x.length; i += 1) {
    const gap = Math.abs(x[i] - y[i]);
    if (gap > widest) [widest, at] = [gap, i];
  }
  return at;
});

/** Where x and y stand when their lines end as one and part before: outside of them, or between where there is room. @param {Axes} axes @param {Run} run @returns {{ symbol: number, x: number, y: number }[]} */
export function placesApart({ x, y, frame }, run) {
  const heightsAt = (/** @type {number} */ i) => [run.x, run.y].map((values) => y(values[i]));
  const apart = (/** @type {readonly number[]} */ [one, other]) => Math.abs(one - other);
  const at = widestGap(run);
  const heights = heightsAt(at);
  // Ends that are seen apart are told by their names there.
  if (apart(heightsAt(run.time.length - 1)) > 8 || !(apart(heights) >= 4)) return [];
  // Between the lines where both have room there.
  const away = apart(heights) > 3 * labelHeight ? -10 : 10;
  const px = Math.min(Math.max(x(run.time[at]), frame.left + 8), frame.right - 8);
  return heights.map((height, symbol) => {
    const py = height + (height < heights[1 - symbol] ? -away : away);
    return { symbol, x: px, y: Math.min(Math.max(py, frame.top), frame.bottom) };
  });
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Run} run */
export function drawNamesApart(context, axes, run) {
  for (const { symbol, x, y } of placesApart(axes, run)) {
    const token = tokens.position[symbol];
    setLettering(context, { token, font: symbolFont, align: 'center' });
    fillTextWithHalo(context, words.symbols.position[symbol], x, y, {
      fill: colour(token),
      halo: colour('--paper'),
      width: 3,
    });
  }
}

/** @param {Plot} plot @param {Run} run @returns {Name[]} */
function namesOf({ name, scale, limit }, run) {
  const last = run.time.length - 1;
  if (name === 'cost')
    return [
      { text: lab.costSymbol, token: '--ink', font: symbolFont, y: scale(run.cost.total) },
      // From the top, also where several have come to lie at one edge.
      ...parts
        .map(([part, token, column], i) => {
          const below = i === 0 ? 0 : parts[i - 1][2](run)[last];
          const text = lab.costParts.find(([one]) => one === part)?.[1] ?? '';
          return { text, token, font: textFont, y: scale((below + column(run)[last]) / 2) };
        })
        .reverse(),
    ];
  const ends = curvesOf[name].map((column, i) => ({
    text: words.symbols[name][i],
    token: tokens[name][i],
    font: symbolFont,
    y: scale(column(run)[last]),
  }));
  const isSeen = limit !== null && limit < scale.domain()[1];
  return isSeen ? [...ends, { text: words.limit, token: '--muted', font: textFont, y: scale(limit) }] : ends;
}
