// What a contest says: its target, a line for each contestant, and of each a verdict against the first.
/** @import { Trial } from '../../core/engine.js' */
/** @import { Contest, Line } from './contest-request.js' */
/** @import { Contestant } from './contestants.js' */
import { level, runningTimeInterval, someOf, toldApart } from './contest-resampling.js';
import { compareEnds, costAt, expectedRunningTime, holm, rankSums, runtimeOf } from './contest-statistics.js';
import { quartilesOf } from './statistics.js';

/** The lowest J of all, and whose it is. @typedef {{ cost: number, name: Contestant | null, seed: number }} Lowest */
/** Against the first: `a12` is how probable it is that a run of this one is the better one. @typedef {{ a12: number, p: number }} Comparison */
/**
 * What one can say of a contestant and the first.
 * @typedef {{ kind: 'same' | 'undecided', runs: number } | { kind: 'sooner' | 'later', times: number } | { kind: 'only-this' | 'only-first', reached: number, runs: number } | { kind: 'mostly' | 'hardly', reached: number, runs: number, first: number } | { kind: 'better' | 'worse', a12: number } | { kind: 'surer' | 'riskier', a12: number, times: number | null }} Verdict
 */
/**
 * @typedef {object} Standing
 * @property {Contestant | null} name
 * @property {string} error
 * @property {number} count How many runs there are.
 * @property {number} reached
 * @property {number} ert In drives.
 * @property {readonly [number, number]} interval Of that.
 * @property {number} median Of J at the budget.
 * @property {Comparison | null} comparison p is Holm's.
 * @property {Verdict | null} verdict
 * @property {number | null} told In how many of 100 draws so few of the seeds tell it apart from the first; null: with all seeds.
 */
/**
 * How a contest is read.
 * @typedef {object} Reading
 * @property {number | null} [target] If it is not the usual one.
 * @property {number | null} [until] After so many drives; null: in the end.
 * @property {number | null} [only] Had one run only so many seeds; null: all.
 * @property {number} [draw] Which of them; 0: the first.
 */
/** @typedef {ReturnType<typeof standingsOf>} Standings */
/** @typedef {Omit<Standing, 'comparison' | 'verdict' | 'told'>} Alone */

/** The usual target is so far above the lowest J. */
export const margin = 0.002;

/** @param {readonly Line[]} lines @returns {Lowest | null} */
function lowestOf(lines) {
  /** @type {Lowest | null} */
  let lowest = null;
  for (const { name, trials } of lines)
    for (const { seed, champion } of trials)
      if (champion.cost < (lowest?.cost ?? Infinity)) lowest = { cost: champion.cost, name, seed };
  return lowest;
}

/** The usual target of a contest, from all that it has found. @param {Lowest | null} lowest */
const usualTarget = (lowest) => (lowest ? lowest.cost + margin * Math.abs(lowest.cost) : Infinity);

/** @param {readonly Trial[]} trials @param {number} target @param {number} budget */
const endsOf = (trials, target, budget) =>
  new Map(
    trials.map((trial) => [
      trial.seed,
      { runtime: runtimeOf(trial, target, budget), cost: costAt(trial, budget) },
    ]),
  );

/** @param {Contest} contest @param {Reading} [reading] */
export function standingsOf(contest, { target: chosen = null, until = null, only = null, draw = 0 } = {}) {
  const lowest = lowestOf(contest.lines);
  const target = chosen ?? usualTarget(lowest);
  const budget = Math.min(until ?? contest.budget, contest.budget);
  const seeds = contest.lines[0].trials.map(({ seed }) => seed);
  const count = Math.min(only ?? seeds.length, seeds.length);
  const isFew = count < seeds.length;
  const drawn = new Set(someOf(seeds, count, draw));
  const lines = contest.lines.map((line) => ({
    ...line,
    trials: isFew ? line.trials.filter(({ seed }) => drawn.has(seed)) : line.trials,
  }));
  const all = contest.lines.map(({ trials }) => endsOf(trials, target, budget));
  const standings = comparedOf(lines, target, budget);
  const [first, ...others] = all;
  const there = others.filter(({ size }) => size > 0);
  const told = isFew && count > 0 ? toldApart(first, there, count) : [];
  return {
    lowest,
    target,
    budget,
    /** How many seeds each was read from, at most. */
    count,
    /** Of so many. */
    seeds: seeds.length,
    drawn: lines,
    lines: standings.map((standing, i) => ({
      ...standing,
      told: i > 0 && isFew && all[i].size > 0 ? (told.shift() ?? null) : null,
    })),
  };
}

/** @param {readonly Line[]} lines @param {number} target @param {number} budget @returns {Omit<Standing, 'told'>[]} */
function comparedOf(lines, target, budget) {
  const ends = lines.map(({ trials }) => [...endsOf(trials, target, budget).values()]);
  const compared = lines.map((_, i) =>
    i > 0 && ends[0].length > 0 && ends[i].length > 0 ? rankSums(ends[0], ends[i], compareEnds) : null,
  );
  const adjusted = holm(compared.flatMap((one) => one?.p ?? []));
  const standings = lines.map(({ name, error }, i) => {
    const runtimes = ends[i].map(({ runtime }) => runtime);
    return {
      name,
      error,
      count: runtimes.length,
      reached: runtimes.filter(Number.isFinite).length,
      ert: expectedRunningTime(runtimes, budget),
      interval: runningTimeInterval(runtimes, budget),
      median: runtimes.length > 0 ? quartilesOf(ends[i].map(({ cost }) => cost)).median : Infinity,
    };
  });
  return standings.map((own, i) => {
    const one = compared[i];
    if (!one) return { ...own, comparison: null, verdict: null };
    const comparison = { a12: one.a12, p: /** @type {number} */ (adjusted.shift()) };
    const isSame = isSameRuns(lines[0].trials, lines[i].trials);
    return { ...own, comparison, verdict: verdictOf(standings[0], own, comparison, isSame) };
  });
}

/** @param {Float64Array} a @param {Float64Array} b */
const isSameList = (a, b) => a.length === b.length && a.every((value, i) => value === b[i]);

/** As far as both have run. @param {readonly Trial[]} a @param {readonly Trial[]} b */
function isSameRuns(a, b) {
  const bySeed = new Map(a.map((trial) => [trial.seed, trial]));
  const common = b.filter(({ seed }) => bySeed.has(seed));
  const isSame = (/** @type {Trial} */ { seed, drives, costs }) => {
    const other = bySeed.get(seed);
    return !!other && isSameList(other.drives, drives) && isSameList(other.costs, costs);
  };
  return common.length > 0 && common.every(isSame);
}

/** @param {Alone} first @param {Alone} own @param {Comparison} comparison @param {boolean} isSame @returns {Verdict} */
function verdictOf(first, own, { a12, p }, isSame) {
  const runs = Math.min(first.count, own.count);
  if (isSame) return { kind: 'same', runs };
  if (p >= level) return { kind: 'undecided', runs };
  if (own.reached > 0 && first.reached === 0)
    return { kind: 'only-this', reached: own.reached, runs: own.count };
  if (own.reached === 0 && first.reached > 0)
    return { kind: 'only-first', reached: first.reached, runs: first.count };
  const times = first.ert / own.ert;
  const shares = { reached: own.reached, runs: own.count, first: first.reached };
  // Of so few that get there no factor can be told, here or below.
  if (a12 > 0.5 && times > 1)
    return first.interval[1] === Infinity ? { kind: 'mostly', ...shares } : { kind: 'sooner', times };
  if (a12 < 0.5 && times < 1)
    return own.interval[1] === Infinity ? { kind: 'hardly', ...shares } : { kind: 'later', times: 1 / times };
  // Who is behind in most pairs, but fails less often, may need fewer drives in the mean; and the other way round.
  const surer = own.reached / own.count - first.reached / first.count;
  const factor = Math.max(first.interval[1], own.interval[1]) < Infinity ? Math.max(times, 1 / times) : null;
  if (a12 < 0.5 && times > 1 && surer > 0) return { kind: 'surer', a12, times: factor };
  if (a12 > 0.5 && times < 1 && surer < 0) return { kind: 'riskier', a12, times: factor };
  return { kind: a12 > 0.5 ? 'better' : 'worse', a12 };
}

/** A row for each improvement; `examples/contest/` makes of it what IOHinspector and IOHanalyzer read. @param {Contest} contest */
export function contestCsv({ lines }) {
  const rows = lines.flatMap(({ name, trials }) =>
    trials.flatMap(({ seed, drives, costs }) =>
      Array.from(drives, (drive, i) => [name ?? 'lab', seed, drive, costs[i]].join(',')),
    ),
  );
  return ['contestant,seed,drive,J', ...rows].map((row) => `${row}\r\n`).join('');
}
