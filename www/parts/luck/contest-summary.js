// What a contest says: its target, a line for each contestant, and of each a verdict against the first.
/** @import { Trial } from '../../core/engine.js' */
/** @import { Contest, Line } from './contest-request.js' */
/** @import { Comparison } from './contest-resampling.js' */
/** @import { Contestant } from './contestants.js' */
import { bisectRight } from 'd3-array';
import { remember } from '../../kit/memo.js';
import { leastRuns } from './contest-numbers.js';
import {
  comparisonsOf,
  factorOf,
  intervalOf,
  level,
  resampledTimes,
  someOf,
  toldApart,
} from './contest-resampling.js';
import { costAt, expectedRunningTime, runtimeOf } from './contest-statistics.js';
import { quartilesOf } from './statistics.js';

/** The lowest J of all, and whose it is. @typedef {{ cost: number, name: Contestant | null, seed: number }} Lowest */
/** Above 1, and between which two it is. @typedef {{ times: number, between: readonly [number, number] }} Factor */
/**
 * What one can say of a contestant and the first. Of shares nothing is said but what is no chance, and of a factor nothing whose interval
 * is not known. `alone`: p, had nobody else been compared, where only that makes it undecided.
 * @typedef {{ kind: 'same', runs: number, isBefore: boolean } | { kind: 'undecided', runs: number, alone: number | null, others: number } | { kind: 'sooner' | 'later' } & Factor | { kind: 'only-this' | 'only-first', reached: number, runs: number } | { kind: 'mostly' | 'hardly', reached: number, runs: number, first: number } | { kind: 'better' | 'worse', a12: number } | { kind: 'surer' | 'riskier', a12: number, factor: Factor | null }} Verdict
 */
/**
 * @typedef {object} Standing
 * @property {Contestant | null} name
 * @property {string} error
 * @property {number} count How many runs there are.
 * @property {number} reached
 * @property {number} ert In drives.
 * @property {readonly [number, number] | null} interval Of that; null: of too few runs.
 * @property {number} median Of J at the budget.
 * @property {Comparison | null} comparison
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

/** The same lines for the same seeds, whatever target they are read at: what is drawn of them is made once. */
const drawnOf = remember(
  (/** @type {readonly Line[]} */ lines, /** @type {number} */ count, /** @type {number} */ draw) => {
    const seeds = lines[0].trials.map(({ seed }) => seed);
    const drawn = new Set(someOf(seeds, count, draw));
    return lines.map((line) => ({ ...line, trials: line.trials.filter(({ seed }) => drawn.has(seed)) }));
  },
);

/** @param {Contest} contest @param {Reading} [reading] */
export function standingsOf(contest, { target: chosen = null, until = null, only = null, draw = 0 } = {}) {
  const lowest = lowestOf(contest.lines);
  const target = chosen ?? usualTarget(lowest);
  const budget = Math.min(until ?? contest.budget, contest.budget);
  const seeds = contest.lines[0].trials.map(({ seed }) => seed);
  const count = Math.min(only ?? seeds.length, seeds.length);
  const isFew = count < seeds.length;
  const lines = isFew ? drawnOf(contest.lines, count, draw) : contest.lines;
  const all = contest.lines.map(({ trials }) => endsOf(trials, target, budget));
  const isBefore = budget <= contest.experiment.evolution.population;
  const standings = comparedOf(lines, target, budget, isBefore);
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

/** @param {readonly Line[]} lines @param {number} target @param {number} budget @param {boolean} isBefore No method has come to do anything. @returns {Omit<Standing, 'told'>[]} */
function comparedOf(lines, target, budget, isBefore) {
  const ends = lines.map(({ trials }) => [...endsOf(trials, target, budget).values()]);
  const compared = lines.map((_, i) => i > 0 && ends[0].length > 0 && ends[i].length > 0);
  const rivals = ends.filter((_, i) => compared[i]);
  const comparisons = comparisonsOf(ends[0], rivals);
  const runtimes = ends.map((own) => own.map(({ runtime }) => runtime));
  const resampled = runtimes.map((own) => (own.length < leastRuns ? null : resampledTimes(own, budget)));
  const standings = lines.map(({ name, error }, i) => {
    const [own, times] = [runtimes[i], resampled[i]];
    return {
      name,
      error,
      count: own.length,
      reached: own.filter(Number.isFinite).length,
      ert: expectedRunningTime(own, budget),
      interval: times && intervalOf(times),
      median: own.length > 0 ? quartilesOf(ends[i].map(({ cost }) => cost)).median : Infinity,
    };
  });
  const others = comparisons.length - 1;
  return standings.map((own, i) => {
    if (!compared[i]) return { ...own, comparison: null, verdict: null };
    const comparison = /** @type {Comparison} */ (comparisons.shift());
    if (isSameRuns(lines[0].trials, lines[i].trials, budget))
      return {
        ...own,
        comparison,
        verdict: { kind: 'same', runs: Math.min(standings[0].count, own.count), isBefore },
      };
    const [first, these] = [resampled[0], resampled[i]];
    const times = standings[0].ert / own.ert;
    const factor =
      first && these && (times > 1 ? factorOf(first, these, times) : factorOf(these, first, 1 / times));
    return { ...own, comparison, verdict: verdictOf(standings[0], own, comparison, { factor, others }) };
  });
}

/** As far as both have run, and are read. @param {readonly Trial[]} a @param {readonly Trial[]} b @param {number} budget */
function isSameRuns(a, b, budget) {
  const bySeed = new Map(a.map((trial) => [trial.seed, trial]));
  const common = b.filter(({ seed }) => bySeed.has(seed));
  const isSame = (/** @type {Trial} */ { seed, drives, costs }) => {
    const other = /** @type {Trial} */ (bySeed.get(seed));
    const [count, otherCount] = [drives, other.drives].map((all) => bisectRight(all, budget));
    const isEqual = (/** @type {number} */ drive, /** @type {number} */ i) =>
      drive === other.drives[i] && costs[i] === other.costs[i];
    return count === otherCount && drives.slice(0, count).every(isEqual);
  };
  return common.length > 0 && common.every(isSame);
}

/** Of two that are not run by run the same. @param {Alone} first @param {Alone} own @param {Comparison} comparison @param {{ factor: Factor | null, others: number }} rest @returns {Verdict} */
function verdictOf(first, own, { a12, p, share, alone }, { factor, others }) {
  const runs = Math.min(first.count, own.count);
  const shares = { reached: own.reached, runs: own.count, first: first.reached };
  const isMore = own.reached / own.count > first.reached / first.count;
  const [isMoreSurely, isFewerSurely] = [share < level && isMore, share < level && !isMore];
  if (isMoreSurely && first.reached === 0)
    return { kind: 'only-this', reached: own.reached, runs: own.count };
  if (isFewerSurely && own.reached === 0)
    return { kind: 'only-first', reached: first.reached, runs: first.count };
  if (p >= level) {
    // Though pairs tell nothing, the shares may.
    if (share < level) return { kind: isMore ? 'mostly' : 'hardly', ...shares };
    return { kind: 'undecided', runs, alone: alone < level ? alone : null, others };
  }
  const isFaster = own.ert < first.ert;
  if (a12 > 0.5) {
    if (isFaster && factor) return { kind: 'sooner', ...factor };
    if (isFaster && isMoreSurely) return { kind: 'mostly', ...shares };
    // Who is ahead in most pairs, but fails more often, may need more drives in the mean; and the other way round.
    if (!isFaster && isFewerSurely) return { kind: 'riskier', a12, factor };
    return { kind: 'better', a12 };
  }
  if (!isFaster && factor) return { kind: 'later', ...factor };
  if (!isFaster && isFewerSurely) return { kind: 'hardly', ...shares };
  if (isFaster && isMoreSurely) return { kind: 'surer', a12, factor };
  return { kind: 'worse', a12 };
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
