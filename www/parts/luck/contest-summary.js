// What a contest says: its target, a line for each contestant, and of each a verdict against the first.
/** @import { Trial } from '../../core/engine.js' */
/** @import { Contest, Line } from './contest-request.js' */
/** @import { Contestant } from './contestants.js' */
import { compareEnds, costAt, expectedRunningTime, holm, rankSums, runtimeOf } from './contest-statistics.js';
import { quartilesOf } from './statistics.js';

/** The lowest J of all, and whose it is. @typedef {{ cost: number, name: Contestant | null, seed: number }} Lowest */
/** Against the first: `a12` is how probable it is that a run of this one is the better one. @typedef {{ a12: number, p: number }} Comparison */
/**
 * What one can say of a contestant and the first.
 * @typedef {{ kind: 'same' | 'undecided', runs: number } | { kind: 'sooner' | 'later', times: number } | { kind: 'only-this' | 'only-first', reached: number, runs: number } | { kind: 'better' | 'worse', a12: number }} Verdict
 */
/**
 * @typedef {object} Standing
 * @property {Contestant | null} name
 * @property {string} error
 * @property {number} count How many runs there are.
 * @property {number[]} runtimes
 * @property {number} reached
 * @property {number} ert In drives.
 * @property {number} median Of J at the budget.
 * @property {Comparison | null} comparison p is Holm's.
 * @property {Verdict | null} verdict
 */
/** @typedef {ReturnType<typeof standingsOf>} Standings */

/** The usual target is so far above the lowest J. */
export const margin = 0.002;
/** What can be told is less probable by chance. */
const level = 0.05;

/** @param {readonly Line[]} lines @returns {Lowest | null} */
export function lowestOf(lines) {
  /** @type {Lowest | null} */
  let lowest = null;
  for (const { name, trials } of lines)
    for (const { seed, champion } of trials)
      if (champion.cost < (lowest?.cost ?? Infinity)) lowest = { cost: champion.cost, name, seed };
  return lowest;
}

/** @param {Contest} contest @param {number | null} chosen The target, if it is not the usual one. */
export function standingsOf({ lines, budget }, chosen) {
  const lowest = lowestOf(lines);
  const target = chosen ?? (lowest ? lowest.cost + margin * Math.abs(lowest.cost) : Infinity);
  const ends = lines.map(({ trials }) =>
    trials.map((trial) => ({ runtime: runtimeOf(trial, target), cost: costAt(trial, budget) })),
  );
  const compared = lines.map((_, i) =>
    i > 0 && ends[0].length > 0 && ends[i].length > 0 ? rankSums(ends[0], ends[i], compareEnds) : null,
  );
  const adjusted = holm(compared.map((one) => one?.p ?? 1).filter((_, i) => compared[i]));
  const standings = lines.map(({ name, error }, i) => {
    const runtimes = ends[i].map(({ runtime }) => runtime);
    return {
      name,
      error,
      count: runtimes.length,
      runtimes,
      reached: runtimes.filter(Number.isFinite).length,
      ert: expectedRunningTime(runtimes, budget),
      median: runtimes.length > 0 ? quartilesOf(ends[i].map(({ cost }) => cost)).median : Infinity,
    };
  });
  const comparisons = compared.map(
    (one) => one && { a12: one.a12, p: /** @type {number} */ (adjusted.shift()) },
  );
  return {
    lowest,
    target,
    budget,
    lines: standings.map((own, i) => {
      const comparison = comparisons[i];
      const isSame = isSameRuns(lines[0].trials, lines[i].trials);
      return { ...own, comparison, verdict: comparison && verdictOf(standings[0], own, comparison, isSame) };
    }),
  };
}

/** @param {Float64Array} a @param {Float64Array} b */
const isSameList = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);

/** As far as both have run. @param {readonly Trial[]} a @param {readonly Trial[]} b */
function isSameRuns(a, b) {
  const bySeed = new Map(a.map((trial) => [trial.seed, trial]));
  return b.every(({ seed, drives, costs }) => {
    const other = bySeed.get(seed);
    return !other || (isSameList(other.drives, drives) && isSameList(other.costs, costs));
  });
}

/** @param {Omit<Standing, 'comparison' | 'verdict'>} first @param {Omit<Standing, 'comparison' | 'verdict'>} own @param {Comparison} comparison @param {boolean} isSame @returns {Verdict} */
function verdictOf(first, own, { a12, p }, isSame) {
  const runs = Math.min(first.count, own.count);
  if (isSame) return { kind: 'same', runs };
  if (p >= level) return { kind: 'undecided', runs };
  if (own.reached > 0 && first.reached === 0)
    return { kind: 'only-this', reached: own.reached, runs: own.count };
  if (own.reached === 0 && first.reached > 0)
    return { kind: 'only-first', reached: first.reached, runs: first.count };
  const times = first.ert / own.ert;
  if (a12 > 0.5 && times > 1) return { kind: 'sooner', times };
  if (a12 < 0.5 && times < 1) return { kind: 'later', times: 1 / times };
  return { kind: a12 > 0.5 ? 'better' : 'worse', a12 };
}

/** A row for each improvement, which IOHanalyzer reads when it is told what the columns are. @param {Contest} contest */
export function contestCsv({ lines }) {
  const rows = lines.flatMap(({ name, trials }) =>
    trials.flatMap(({ seed, drives, costs }) =>
      Array.from(drives, (drive, i) => [name ?? 'lab', seed, drive, costs[i]].join(',')),
    ),
  );
  return ['contestant,seed,drive,J', ...rows].map((row) => `${row}\r\n`).join('');
}
