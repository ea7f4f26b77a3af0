// The duel as lines: the best J so far against the number of drives.
import uPlot from 'uplot';
import { axis, colour, lineLabel, sameDigits, sizeOf, spread, wholeSteps } from '../plot.js';
import { watch } from '../state.js';
import { generationsIn, longestOf, lowestOf } from './duel.js';

/** @typedef {import('./duel.js').Duel} Duel */
/** @typedef {{ names: Record<'you' | 'evolution' | 'random', string>, drivesAxis: string, costSymbol: string }} PlotWords */

const gutter = 112;
const stepped = /** @type {uPlot.Series.PathBuilder} */ (uPlot.paths.stepped?.({ align: 1 }));

/** @param {HTMLElement} root @param {PlotWords} words */
export function createDuelPlot(root, words) {
  /** @type {Duel | null} */
  let duel = null;
  const changed = watch();
  const labels = createLabels(words);
  /** @param {string} name @param {number} width @param {number[]} [dash] */
  const line = (name, width, dash) => ({
    stroke: () => colour(name),
    width,
    dash,
    paths: stepped,
    // Where it begins: the first robots of evolution are driven as a whole.
    points: { show: true, size: 7, fill: () => colour(name), filter: beginOf },
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
      series: [{}, line('--muted', 2, [2, 4]), line('--ink', 2.5, [8, 4]), line('--ink', 3)],
      hooks: {
        draw: [
          (drawn) => {
            if (!duel) return;
            drawEnd(drawn, duel);
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

/** @param {uPlot} plot @param {number} line */
const beginOf = ({ data }, line) => {
  const first = data[line].findIndex(
    (/** @type {number | null | undefined} */ cost) => typeof cost === 'number',
  );
  return first < 0 ? [] : [first];
};

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
