// What the pictures of a contest are drawn of: the course of each contestant over the drives, and the scales they share.
/** @import { Contest, Line } from './contest-request.js' */
/** @import { Standings } from './contest-summary.js' */
import { remember } from '../../kit/memo.js';
import { costAt, runtimeOf, shareAt, shareOfTargets } from './contest-statistics.js';
import { margin } from './contest-summary.js';
import { bandThrough, quartilesOf } from './statistics.js';

const steps = 160;
/** Distances under this are shown as this. */
const smallest = 1e-6;
/** The picture begins with so many drives to choose its heights by. */
const firstDrives = 5;

/** Whole numbers, evenly on a logarithm. @param {number} budget */
export const drivesOn = (budget) => [
  ...new Set(Array.from({ length: steps + 1 }, (_, i) => Math.round(budget ** (i / steps)))),
];

/** @param {readonly Line[]} lines @param {readonly number[]} drives */
export const coursesOf = (lines, drives) =>
  lines.map(({ trials }) => {
    const quartilesAfter = (/** @type {number} */ drive) =>
      quartilesOf(trials.map((trial) => costAt(trial, drive)));
    return trials.length === 0 ? null : bandThrough(drives.map(quartilesAfter));
  });

/** The share of the runs at the target, as the runs would go on to the end. @param {Standings} standings @param {readonly number[]} drives */
export const sharesOf = ({ drawn, target }, drives) =>
  drawn.map(({ trials }) => {
    const runtimes = trials.map((trial) => runtimeOf(trial, target));
    return trials.length === 0 ? null : drives.map((drive) => shareAt(runtimes, drive));
  });

/** The 51 targets, from 10 % above the lowest J to 0.1 %, evenly on a logarithm. @param {number} lowest */
const targetsFrom = (lowest) =>
  Array.from({ length: 51 }, (_, i) => lowest + 10 ** (-1 - (2 * i) / 50) * Math.abs(lowest));

/** @param {Standings} standings @param {readonly number[]} drives */
export const manySharesOf = ({ drawn, lowest }, drives) => {
  const targets = lowest ? targetsFrom(lowest.cost) : null;
  return drawn.map(({ trials }) =>
    trials.length === 0 || !targets ? null : drives.map((drive) => shareOfTargets(trials, targets, drive)),
  );
};

/** How far above the lowest. @param {number} lowest */
export const distanceFrom = (lowest) => (/** @type {number} */ cost) => Math.max(cost - lowest, smallest);

/**
 * Of the distances, from the nearest of the ends to what few drives give. It does not move with the target or with the seeds that are read.
 * @param {Contest} contest @param {number} lowest @returns {[number, number]}
 */
function rangeOf(contest, lowest) {
  const drives = drivesOn(contest.budget);
  const distance = distanceFrom(lowest);
  const begin = drives.findIndex((drive) => drive >= firstDrives);
  const there = coursesOf(contest.lines, [drives[begin], contest.budget]).filter((course) => course !== null);
  const ends = there.map(({ low }) => distance(low[1])).filter(Number.isFinite);
  const begins = there.map(({ median }) => distance(median[0])).filter(Number.isFinite);
  const low = Math.min(margin * Math.abs(lowest) || 1, ...ends);
  const high = Math.max(low, ...begins);
  return [low / 2, 1.5 * Math.max(high, 10 * low)];
}

export const rangeIn = remember(rangeOf);
