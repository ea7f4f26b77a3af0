// Every word of the contest.
/** @import { Factor, Lowest, Verdict } from '../contest-summary.js' */
/** @import { Contestant } from '../contestants.js' */
import { leastRuns } from '../contest-numbers.js';
import { costText, grouped, wasText } from '../../../words/en/numbers.js';
import { percent, probability, targetText, timesText } from './common.js';

export const viewLegend = 'What is asked';
/** @type {import('../../../kit/segmented.js').Choices<'seeds' | 'contest'>} */
export const views = {
  seeds: { text: 'Seeds', hint: 'One search with many seeds' },
  contest: {
    text: 'Contest',
    hint: 'Several searches beside each other, with the same seeds and drives',
  },
};

export const contestTexts = {
  title: 'Contest',
  csv: 'CSV',
  picture: 'The contest',
  seeds: 'With how many seeds',
  budget: 'How many drives each',
  progress: 'Runs that are done',
  nobody: '–',
  ingredients: 'change one ingredient',
  rivals: 'a rival',
  target: 'Target J',
  until: 'Read after so many drives',
  reading: 'Which picture',
  fewer: 'Had you run only',
  otherSeeds: 'other seeds',
  usualTarget: 'usual target',
  caption: 'In drives: who reaches the target, and when',
};

/** @type {import('../../../kit/segmented.js').Choices<import('../state.js').LuckState['reading']>} */
export const readings = {
  course: {
    text: 'J over drives',
    hint: 'The best J over the drives, and who has reached the target',
  },
  targets: {
    text: '51 targets',
    hint: 'How many of 51 targets are reached, from 10 % above the lowest J to 0.1 %',
  },
  ends: { text: 'Ends', hint: 'Where each run ends, a dot for each seed' },
  table: { text: 'Table', hint: 'Who reaches the target, and when' },
};

export const asInLab = 'as in the lab';
/** @type {Readonly<Record<Contestant, string>>} */
const names = {
  cauchy: 'Cauchy steps',
  fixed: 'σ fixed (no adaptation)',
  'floor-0.01': 'σ never below 0.01',
  'floor-0.1': 'σ never below 0.1',
  truncation: 'truncation: lowest J survives',
  parent: 'offspring against parent',
  crossover: 'crossover 0.5',
  'n-6': 'N = 6',
  'n-100': 'N = 100',
  mirror: 'mirrored below 0',
  random: 'random search',
  de: 'DE (differential evolution)',
  'cma-es': 'CMA-ES',
  'cma-es-7': 'CMA-ES, 7 trials a generation',
  'cma-es-7-mirror': 'CMA-ES, 7 trials, mirrored below 0',
  'one-plus-one-es': '(1+1)-ES',
  'nelder-mead': 'Nelder–Mead',
  'one-at-a-time': 'one gain at a time',
  hand: 'one gain at a time, held at 0, as by hand',
  'finite-differences': 'finite differences',
};
/** At a line, where there is little room. @type {Readonly<Partial<Record<Contestant, string>>>} */
const shortNames = {
  fixed: 'σ fixed',
  'floor-0.01': 'σ ≥ 0.01',
  'floor-0.1': 'σ ≥ 0.1',
  truncation: 'truncation',
  parent: 'own parent',
  mirror: 'mirrored',
  random: 'random',
  de: 'DE',
  'cma-es-7': 'CMA-ES with 7',
  'cma-es-7-mirror': 'mirrored CMA-ES',
  'one-at-a-time': 'one at a time',
  hand: 'as by hand',
  'finite-differences': 'differences',
};

/** @param {Contestant | null} name */
export const contestantName = (name) => (name ? names[name] : asInLab);
/** @param {Contestant | null} name */
export const shortName = (name) => (name ? (shortNames[name] ?? names[name]) : asInLab);

/** @param {number} place */
export const contestantLabel = (place) => `Contestant ${place}`;
/** @param {number} count @param {number} seeds */
export const contestRunText = (count, seeds) => `Run ${count} × ${seeds} seeds`;
/** @param {number} drives */
export const drivesChoice = (drives) => `${grouped(drives)} drives`;
/** How the contest counts a drive from many starts. @param {number} starts */
export const asOne = (starts) => (starts > 1 ? ` (all ${starts} starts count as one)` : '');
export const wholeNumber = grouped;
/** @param {number} low @param {number} high */
export const intervalText = (low, high) => `${grouped(low)}–${Number.isFinite(high) ? grouped(high) : '∞'}`;

/** @param {number} done @param {number} all */
export const contestProgress = (done, all) => `${done} of ${all} runs`;
/** @param {number} drives */
export const tooLong = (drives) =>
  `That would be ${grouped(drives)} drives, far too many to wait for: take fewer seeds, drives, starts or contestants.`;
/** @param {number} budget @param {number} most */
export const runTooLong = (budget, most) =>
  `One run of ${grouped(budget)} drives takes too long here; ${grouped(most)} would be the most: take fewer drives or starts, a shorter horizon, or a longer sample time.`;
/** @param {number} done @param {number} all */
export const contestCancelled = (done, all) =>
  `Cancelled after ${done} of ${all} runs: what you see is what these say.`;
export const otherContest = 'Out of date: this is the earlier contest. Run the one that is set up now.';
/** @param {{ seeds: number, budget: number }} asked @param {number} starts */
export const contestInvitation = ({ seeds, budget }, starts) =>
  `Which part does the work? Every contestant runs with the same ${seeds} seeds, ${grouped(budget)} drives each${asOne(starts)}. Then count drives, not generations.`;

/** @param {Lowest} lowest */
export const usualTargetText = ({ cost, name, seed }) =>
  `0.2 % above ${targetText(cost)}, the lowest J (${shortName(name)}, seed ${seed})`;
/** @param {string} was */
export const targetRefused = (was) => `The target must be a number; ${wasText(was)}`;

export const drivesAxis = 'drives';
/** What comes where no contest has run. */
export const emptyCosts = 'median J of each contestant';
export const shareAxis = 'share at the target';
export const targetsAxis = 'share of 51 targets';
/** @param {number} drives */
export const untilText = (drives) => `read after ${grouped(drives)} drives; to the end`;
/** @param {number} count @param {number} seeds */
export const seedsText = (count, seeds) => `${count} of ${seeds} seeds`;
/** @param {number} told @param {number} count */
export const toldText = (told, count) =>
  `In ${told} of 100 draws of ${count} ${count === 1 ? 'seed' : 'seeds'} one can tell.`;
/** @param {number} target */
export const targetLine = (target) => `target ${targetText(target)}`;

export const contestColumns = [
  { text: 'reached', hint: 'How many runs reached the target; two are compared by Fisher’s exact test' },
  {
    text: 'ERT',
    hint: `Expected running time: the drives of all runs until the target or the budget, divided by the number of those that reached it; beside it, of ${leastRuns} runs or more, its 95 % confidence interval (bootstrap); after a factor, its own`,
  },
  { text: 'median J', hint: 'The median of J at the budget' },
  {
    text: 'A12',
    hint: 'How probable it is that a run of it is better than one of the first: sooner at the target, or, if neither is there, with a lower J',
  },
  {
    text: 'p',
    hint: 'Mann–Whitney, two-sided, by the same order; Holm’s correction for the number of lines. It ignores that the seeds are shared, so it is cautious at a target that is reached early',
  },
];
/** The columns in a line; their hints have it in full. */
export const columnsText = 'ERT: drives per success. A12: pairs won. p: how often chance does as much.';
/** @param {number} reached @param {number} count */
export const reachedText = (reached, count) => `${reached} of ${count}`;

/** @param {Factor} factor */
const betweenText = ({ between: [low, high] }) => `(${timesText(low)} to ${timesText(high)})`;

/** @param {Verdict} verdict @param {Contestant | null} name */
export function verdictText(verdict, name) {
  switch (verdict.kind) {
    case 'same':
      return `Run by run the same as the first: in these drives it changes nothing.${verdict.isBefore ? ' (While only the first random robots drive, no method changes anything.)' : ''}`;
    case 'undecided':
      return verdict.runs === 1
        ? 'One run cannot tell these two apart.'
        : `${verdict.runs} runs cannot tell these two apart${verdict.alone === null ? '' : ` (p would be ${probability(verdict.alone)}, were it alone and not one of ${1 + verdict.others})`}.`;
    case 'sooner':
      return `${shortName(name)} gets there ${timesText(verdict.times)} times sooner ${betweenText(verdict)}.`;
    case 'later':
      return `${shortName(name)} takes ${timesText(verdict.times)} times as many drives to get there ${betweenText(verdict)}.`;
    case 'mostly':
      return `${shortName(name)} gets there in ${verdict.reached} of ${verdict.runs} runs, the first in only ${verdict.first}.`;
    case 'hardly':
      return `${shortName(name)} gets there in only ${verdict.reached} of ${verdict.runs} runs, the first in ${verdict.first}.`;
    case 'only-this':
      return `${shortName(name)} gets there in ${verdict.reached} of ${verdict.runs} runs, the first in none.`;
    case 'only-first':
      return `${shortName(name)} never gets there; the first does in ${verdict.reached} of ${verdict.runs} runs.`;
    case 'surer':
      return `${shortName(name)} is behind in ${percent(1 - verdict.a12)} of all pairs, but fails less often${verdict.factor ? `: in the mean it gets there ${timesText(verdict.factor.times)} times sooner ${betweenText(verdict.factor)}` : ''}.`;
    case 'riskier':
      return `${shortName(name)} is ahead in ${percent(verdict.a12)} of all pairs, but fails more often${verdict.factor ? `: in the mean it takes ${timesText(verdict.factor.times)} times as many drives ${betweenText(verdict.factor)}` : ''}.`;
    default:
      return `In ${percent(verdict.kind === 'better' ? verdict.a12 : 1 - verdict.a12)} of all pairs of runs the ${verdict.kind === 'better' ? 'better' : 'worse'} one is that of ${shortName(name)}.`;
  }
}

/** @param {readonly string[]} sentences */
export const contestLabel = (sentences) =>
  `The best J over drives, and the share of runs at the target. ${sentences.join(' ')}`;
/** @param {number} cost */
export const medianText = (cost) => (Number.isFinite(cost) ? targetText(cost) : costText(cost));
