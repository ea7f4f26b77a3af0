// What many seeds say together: quartiles of each generation, the ranking of the seeds, and a table of all as CSV.
/** @import { SeedRun } from '../../core/engine.js' */
import { gainUnits } from '../../core/rules.js';

/** Half of the numbers lie from `low` to `high`. @typedef {{ least: number, low: number, median: number, high: number, most: number }} Quartiles */
/** Quartiles of J at each generation, or after each of many drives. @typedef {{ low: number[], median: number[], high: number[] }} Band */
/** @typedef {ReturnType<typeof summaryOf>} Summary */

/**
 * The number below which a part of the sorted numbers lies; between two of them in proportion.
 * @param {ArrayLike<number>} sorted @param {number} part From 0 to 1.
 */
function quantile(sorted, part) {
  const at = part * (sorted.length - 1);
  const [below, above] = [sorted[Math.floor(at)], sorted[Math.ceil(at)]];
  // Two infinite costs have no difference.
  return below === above ? below : below + (at - Math.floor(at)) * (above - below);
}

/** @param {Iterable<number>} values @returns {Quartiles} */
export function quartilesOf(values) {
  const sorted = Float64Array.from(values).sort();
  const [least, low, median, high, most] = [0, 0.25, 0.5, 0.75, 1].map((part) => quantile(sorted, part));
  return { least, low, median, high, most };
}

/** @param {readonly Quartiles[]} quartiles @returns {Band} */
export const bandThrough = (quartiles) => ({
  low: quartiles.map(({ low }) => low),
  median: quartiles.map(({ median }) => median),
  high: quartiles.map(({ high }) => high),
});

/** @param {readonly Float64Array[]} curves */
const bandOf = (curves) =>
  bandThrough(
    Array.from(curves[0], (_, generation) => quartilesOf(curves.map((curve) => curve[generation]))),
  );

/** @param {readonly SeedRun[]} runs */
export function summaryOf(runs) {
  const costs = runs.map(({ champion }) => champion.cost);
  const randomCosts = runs.map(({ random }) => random[random.length - 1]);
  const evolution = bandOf(runs.map(({ best }) => best));
  const final = quartilesOf(costs);
  const finalRandom = quartilesOf(randomCosts);
  return {
    evolution,
    random: bandOf(runs.map(({ random }) => random)),
    costs,
    randomCosts,
    final,
    finalRandom,
    gains: [0, 1, 2].map((i) => quartilesOf(runs.map(({ champion }) => champion.gains[i]))),
    /** Indices of the runs, the lowest J first. */
    ranking: costs.map((_, i) => i).sort((a, b) => costs[a] - costs[b] || a - b),
    lowest: Math.min(final.least, finalRandom.least),
    /** With how many seeds random search has found a lower J. */
    randomWins: costs.filter((cost, i) => randomCosts[i] < cost).length,
    /** The generation at which evolution's median is where random search's median ends; −1 if it never is. */
    overtakes: evolution.median.findIndex((median) => median <= finalRandom.median),
  };
}

/**
 * A line for each seed. Headers carry the units; J has none, because it adds seconds to what is not seconds.
 * @param {Pick<import('./request.js').SeedSurvey, 'experiment' | 'first' | 'drives' | 'runs'>} survey
 */
export function csvOf({ experiment: { law }, first, drives, runs }) {
  const generations = [...runs[0].best.keys()];
  const header = [
    'seed',
    'drives',
    'J evolution',
    ...['kx', 'ky', 'ktheta'].map((name, i) => `${name} (${gainUnits[law][i]})`),
    'J random search',
    ...generations.map((generation) => `J evolution generation ${generation}`),
    ...generations.map((generation) => `J random search generation ${generation}`),
  ];
  const lines = runs.map(({ best, champion, random }, i) => [
    first + i,
    drives ?? '',
    champion.cost,
    ...champion.gains,
    random[random.length - 1],
    ...best,
    ...random,
  ]);
  return [header, ...lines].map((line) => `${line.join(',')}\r\n`).join('');
}
