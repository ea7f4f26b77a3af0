// The duel as lines: the best J so far against the number of drives.
import uPlot from 'uplot';
import { drawPath } from '../kit/swatch.js';
import { axis, colour, lineLabel, sameDigits, sizeOf, spread, wholeSteps } from '../kit/plot.js';
import { watch } from '../kit/memo.js';
import { generationsIn, longestOf, lowestOf } from './duel.js';

/** @import { Look } from '../kit/swatch.js' */
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
/** As the columns stand. */
const lines = /** @type {const} */ (['random', 'evolution', 'you']);
const stepped = /** @type {uPlot.Series.PathBuilder} */ (uPlot.paths.stepped?.({ align: 1 }));

/** @param {HTMLElement} root @param {PlotWords} words */
export function createDuelPlot(root, words) {
  /** @type {Duel | null} */
  let duel = null;
  const changed = watch();
  const labels = createLabels(words);
  const line = (/** @type {'you' | 'evolution' | 'random'} */ name) => ({
    stroke: () => colour(looks[name].token),
    width: name === 'random' ? 2 : 2.5,
    dash: [...looks[name].dash],
    paths: stepped,
    points: { show: false },
  });
  const plot = new uPlot(
    {
      ...sizeOf(root),
      padding: [8, gutter, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => [0, duel ? shownDrives(duel) : 1] },
        y: { range: () => (duel ? costRange(duel) : [0, 1]) },
      },
      axes: [
        { ...axis(), size: 28, space: 56, incrs: wholeSteps, values: (_, ticks) => ticks.map(String) },
        { ...axis(), size: 52, space: 32, values: sameDigits },
      ],
      series: [{}, ...lines.map(line)],
      hooks: {
        draw: [
          (drawn) => {
            if (!duel) return;
            drawEnd(drawn, duel);
            drawMarks(drawn);
            labels.draw(drawn, duel);
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
    /** @param {Duel} next @param {number} theme */
    draw(next, theme) {
      if (!changed(next, theme)) return;
      duel = next;
      plot.setData(columns(next));
    },
  };
}

/** On each line where it begins, for the first robots of evolution are driven as a whole, and then here and there, never two at one place. @param {uPlot} plot */
function drawMarks(plot) {
  const { ctx, data, scales } = plot;
  const top = scales.y.max ?? Number.POSITIVE_INFINITY;
  ctx.save();
  ctx.scale(uPlot.pxRatio, uPlot.pxRatio);
  for (const [i, name] of lines.entries()) {
    const costs = data[i + 1];
    const first = costs.findIndex((cost) => typeof cost === 'number');
    const spaced = Array.from({ length: marksOnLine }, (_, k) =>
      Math.round(((k + (i + 1) / lines.length) * (costs.length - 1)) / marksOnLine),
    );
    for (const at of new Set([first, ...spaced])) {
      const cost = costs[at];
      if (typeof cost !== 'number' || cost > top) continue;
      const [x, y] = [plot.valToPos(data[0][at], 'x', true), plot.valToPos(cost, 'y', true)];
      const colours = { fill: colour(looks[name].token), edge: colour('--paper') };
      drawPath(ctx, looks[name].mark, x / uPlot.pxRatio, y / uPlot.pxRatio, colours);
    }
  }
  ctx.restore();
}

/** @param {Duel} duel */
const shownDrives = (duel) =>
  duel.goesOn ? longestOf(duel) : Math.max(duel.costs.length, duel.experiment.evolution.population);

/** The best so far after each drive. @param {Duel} duel @returns {uPlot.AlignedData} */
function columns(duel) {
  const { costs, experiment, rounds } = duel;
  const { population } = experiment.evolution;
  const { evolution, random } = rounds[rounds.length - 1];
  const drives = Array.from({ length: shownDrives(duel) }, (_, i) => i + 1);
  const finite = (/** @type {number} */ cost) => (Number.isFinite(cost) ? cost : null);
  // The first population is driven as a whole.
  const byGeneration = (/** @type {ArrayLike<number>} */ bests) =>
    drives.map((drive) => (drive < population ? null : finite(bests[generationsIn(drive, population)])));
  let lowest = Number.POSITIVE_INFINITY;
  const own = drives.map((drive) => {
    lowest = Math.min(lowest, costs[drive - 1] ?? lowest);
    return finite(lowest);
  });
  return [drives, byGeneration(random), byGeneration(evolution), own];
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

/** Where you have stopped. @param {uPlot} plot @param {Duel} duel */
function drawEnd(plot, { costs, goesOn }) {
  if (!goesOn) return;
  const { ctx, bbox } = plot;
  const x = plot.valToPos(costs.length, 'x', true);
  ctx.save();
  ctx.strokeStyle = colour('--muted');
  ctx.lineWidth = uPlot.pxRatio;
  ctx.setLineDash([3 * uPlot.pxRatio, 3 * uPlot.pxRatio]);
  ctx.beginPath();
  ctx.moveTo(x, bbox.top);
  ctx.lineTo(x, bbox.top + bbox.height);
  ctx.stroke();
  ctx.restore();
}

/** @param {PlotWords} words */
function createLabels({ names, drivesAxis, costSymbol }) {
  const you = lineLabel('best', names.you);
  const evolution = lineLabel('evolved', names.evolution);
  const random = lineLabel('random', names.random);
  const axisName = lineLabel('axis', drivesAxis);
  const costName = lineLabel('axis', costSymbol);
  /** @param {uPlot} plot @param {Duel} duel */
  const draw = (plot, duel) => {
    const [, ...lines] = columns(duel);
    const height = plot.over.clientHeight;
    const right = plot.over.clientWidth + 6;
    const places = [random, evolution, you].map((element, i) => {
      const end = lines[i].at(-1);
      element.hidden = end === null || end === undefined;
      return { element, y: Math.min(Math.max(plot.valToPos(end ?? 0, 'y'), 0), height) };
    });
    spread(places, height);
    for (const { element, y } of places)
      element.style.transform = `translate(${right}px, ${y}px) translateY(-50%)`;
    costName.style.transform = 'translate(-50px, 0)';
    axisName.style.transform = `translate(${right + 14}px, ${height + 6}px)`;
  };
  return { elements: [random, evolution, you, axisName, costName], draw };
}
