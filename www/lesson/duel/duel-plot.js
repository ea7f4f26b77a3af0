// The duel as lines: the best J so far against the number of drives.
import { scaleLinear } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawGridOverWholes,
  drawUpright,
  frameIn,
  pointsOf,
  levelsOn,
  within,
} from '../../kit/chart.js';
import { drawAxisNames, drawName, spreadBeside } from '../../kit/names.js';
import { colour } from '../../kit/palette.js';
import { drawMark } from '../../kit/swatch.js';
import { drivesUntil, generationAt, generationsIn, longestOf, lowestOf } from './duel.js';

/** @import { Axes, Size } from '../../kit/chart.js' */
/** @import { Look } from '../../kit/swatch.js' */
/** @import { Duel } from './duel.js' */
/** @typedef {{ names: Record<'you' | 'evolution' | 'random', string>, drivesAxis: string, costSymbol: string }} PlotWords */

const gutter = 112;
const marksOnLine = 4;
/** Told apart by dash and mark, also from afar and without colours. @type {Record<'you' | 'evolution' | 'random', Look>} */
export const looks = {
  you: { token: '--ink', dash: [], mark: 'M-5 0A5 5 0 1 0 5 0A5 5 0 1 0-5 0z' },
  evolution: { token: '--ink', dash: [8, 4], mark: 'M0-7 5.5 0 0 7-5.5 0z' },
  random: {
    token: '--muted',
    dash: [2, 4],
    mark: 'M-6-3.6-3.6-6 0-2.4 3.6-6 6-3.6 2.4 0 6 3.6 3.6 6 0 2.4-3.6 6-6 3.6-2.4 0z',
  },
};
/** As they lie on each other. */
const lines = /** @type {const} */ (['random', 'evolution', 'you']);

/** @param {HTMLElement} root @param {PlotWords} words */
export const createDuelPlot = (root, words) =>
  createChart(root, (context, size, /** @type {{ duel: Duel, theme: number }} */ { duel }) =>
    drawDuel(context, size, duel, words),
  );

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {Duel} duel @param {PlotWords} words */
function drawDuel(context, size, duel, words) {
  const frame = frameIn(size, { right: gutter });
  const axes = {
    frame,
    x: scaleLinear([0, shownDrives(duel)], [frame.left, frame.right]),
    y: scaleLinear(costRange(duel), [frame.bottom, frame.top]),
  };
  drawGridOverWholes(context, axes, levelsOn(axes.y));
  const columns = columnsOf(duel);
  const drives = columns[0].map((_, i) => i + 1);
  within(context, frame, () => {
    for (const [i, name] of lines.entries()) {
      const { token, dash } = looks[name];
      const points = pointsOf(axes, drives, columns[i], true);
      drawCurve(context, points, { token, dash, width: name === 'random' ? 2 : 2.5 });
    }
  });
  if (duel.goesOn)
    drawUpright(context, axes.x(duel.costs.length), frame, { token: '--muted', width: 1, dash: [3, 3] });
  drawMarks(context, axes, columns);
  drawLineNames(context, axes, columns, words);
}

/** On each line where it begins, for the first robots of evolution are driven as a whole, and then here and there, never two at one place. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number[][]} columns */
function drawMarks(context, { x, y, frame }, columns) {
  for (const [i, name] of lines.entries()) {
    const costs = columns[i];
    const spaced = Array.from({ length: marksOnLine }, (_, k) =>
      Math.round(((k + (i + 1) / lines.length) * (costs.length - 1)) / marksOnLine),
    );
    for (const at of new Set([costs.findIndex(Number.isFinite), ...spaced])) {
      const [px, py] = [x(at + 1), y(costs[at])];
      if (!(py >= frame.top)) continue;
      const colours = { fill: colour(looks[name].token), edge: colour('--paper') };
      drawMark(context, looks[name].mark, px, py, colours);
    }
  }
}

/** @param {Duel} duel */
function shownDrives(duel) {
  const { population } = duel.experiment.evolution;
  return duel.goesOn
    ? longestOf(duel)
    : drivesUntil(generationsIn(duel.costs.length, population), population);
}

/** The best so far after each drive, of each line; NaN where there is none. @param {Duel} duel */
function columnsOf(duel) {
  const { costs, experiment, rounds } = duel;
  const { population } = experiment.evolution;
  const { evolution, random } = rounds[rounds.length - 1];
  const drives = Array.from({ length: shownDrives(duel) }, (_, i) => i + 1);
  const finite = (/** @type {number} */ cost) => (Number.isFinite(cost) ? cost : Number.NaN);
  // The first population is driven as a whole.
  const byGeneration = (/** @type {ArrayLike<number>} */ bests) =>
    drives.map((drive) => (drive < population ? Number.NaN : finite(bests[generationAt(drive, population)])));
  let lowest = Number.POSITIVE_INFINITY;
  const own = drives.map((drive) => {
    lowest = Math.min(lowest, costs[drive - 1] ?? lowest);
    return finite(lowest);
  });
  return [byGeneration(random), byGeneration(evolution), own];
}

/** From the lowest J to where evolution began, or to your best; what is worse comes in from above. @param {Duel} duel @returns {[number, number]} */
function costRange({ costs, rounds }) {
  const { evolution, random } = rounds[rounds.length - 1];
  const own = lowestOf(costs);
  const known = [own, evolution[0]].filter(Number.isFinite);
  const low = Math.min(...known, evolution[evolution.length - 1], random[random.length - 1]);
  const high = Math.max(...known);
  const room = Math.max(0.06 * (high - low), 1e-3 * Math.abs(high));
  return [low - room, high + 3 * room];
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {number[][]} columns @param {PlotWords} words */
function drawLineNames(context, { y, frame }, columns, { names, drivesAxis, costSymbol }) {
  const places = lines.flatMap((name, i) => {
    const end = columns[i][columns[i].length - 1];
    if (Number.isNaN(end)) return [];
    const { token } = looks[name];
    const height = Math.min(Math.max(y(end), frame.top), frame.bottom);
    return [{ text: names[name], y: height, token, isStrong: name === 'you' }];
  });
  if (places.length > 0) spreadBeside(places, frame);
  for (const place of places) drawName(context, { ...place, x: frame.right + 6 });
  drawAxisNames(context, frame, { x: drivesAxis, y: costSymbol });
}
