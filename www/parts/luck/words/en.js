// Every word of the luck part.
/** @import { SeedSurvey } from '../request.js' */
/** @import { Change } from './common.js' */
import { gainNames, isRandom } from './common.js';
import { costText, fixed, grouped, tookText } from '../../../words/en/numbers.js';

export * from './common.js';
export * from './contest-en.js';

export const texts = {
  luckGainsPicture: 'The gains of all seeds',
  luckCurvePicture: 'The fitness curve of all seeds',
  luckTitle: 'Luck of the seed',
  luckCount: 'How many seeds',
  luckGenerations: 'How many generations',
  luckTable: 'Table and CSV',
  luckProgress: 'Seeds that have run',
  luckCurve: 'Best J so far over the generations: median and quartiles',
  luckLog: 'log',
  luckGainsTitle: 'Gains in the end: a dot a seed',
  luckMedian: 'median',
  luckLuckiest: 'luckiest',
  luckUnluckiest: 'unluckiest',
  luckRank: 'One seed, from the luckiest to the unluckiest',
};

/** @param {number} count */
export const runText = (count) => `Run ${count} seeds`;
export const cancel = 'Cancel';

/** @param {number} count */
export const countChoice = (count) => `${count} seeds`;
/** @param {number} generations */
export const generationsChoice = (generations) => `${generations} generations`;

/** @param {SeedSurvey} survey */
export const surveyNote = ({ experiment, runs, drives, milliseconds }) =>
  `${countChoice(runs.length)}${drives === null ? '' : `, ${isRandom(experiment) ? '' : '2 × '}${grouped(drives)} drives each,`} in ${tookText(milliseconds)}`;

/** @param {number} seed @param {number} generation */
export const labNote = (seed, generation) => `the lab: seed ${seed}, generation ${generation}`;

/** What a press will do. @param {SeedSurvey['experiment']} experiment @param {number} count @param {number} generations @param {number | null} drives */
export const invitation = (experiment, count, generations, drives) =>
  `One run is one throw of the dice. Run ${count} seeds: ${isRandom(experiment) ? `with each, random search draws other robots for ${generations} generations` : `each evolves from other random robots for ${generations} generations, and beside it random search tries as many gains`}${drives === null ? '' : `, ${grouped(drives)} drives each`}.`;

/** How many of them have run. @param {number} done @param {number} count */
export const seedsOf = (done, count) => `${done} of ${count} seeds`;

/** @param {boolean} hasResult */
export const cancelled = (hasResult) =>
  hasResult
    ? 'Cancelled. What you see is the last result that was complete.'
    : 'Cancelled before any result was complete.';

/** @param {string} message @param {boolean} hasResult */
export const failed = (message, hasResult) =>
  hasResult ? `What you see is the last result that could be computed: ${message}` : message;

/** @param {readonly Change[]} changes */
export const outOfDate = (changes) =>
  `Out of date: these seeds ran ${listOf(changes.map((change) => earlier[change]))}.`;

/** @type {Readonly<Record<Change, string>>} */
const earlier = {
  start: 'from the earlier start',
  goal: 'to the earlier goal',
  limits: 'under the earlier limits',
  settings: 'with earlier settings',
};

/** @param {readonly string[]} parts */
const listOf = (parts) =>
  parts.length < 2 ? parts.join('') : `${parts.slice(0, -1).join(', ')} and ${parts[parts.length - 1]}`;

/** What was found, true for whatever comes out. @param {SeedSurvey} survey */
export function finding({ experiment, runs, generations, summary }) {
  const { final, finalRandom, randomWins, overtakes } = summary;
  const evolution = `After ${generations} generations half of the ${runs.length} seeds have J ${costText(final.median)} or lower, the unluckiest ${costText(final.most)}.`;
  // It is what is beside it.
  if (isRandom(experiment)) return evolution;
  const random = `Random search with as many drives ends at ${costText(finalRandom.median)} (median) and is better for ${seedsText(randomWins)}`;
  const isThere = overtakes > 0 && overtakes < generations;
  return `${evolution} ${random}${isThere ? `; evolution’s median is there at generation ${overtakes}` : ''}.`;
}

/** @param {number} count */
const seedsText = (count) => (count === 1 ? '1 seed' : `${count === 0 ? 'no' : count} seeds`);

export const evolutionLine = 'evolution';
export const randomLine = 'random search';
export const paperLine = 'paper’s EP';
/** After the title of the gains. */
export const paperSign = ', ◇ paper’s EP';
export const evolutionHead = 'evolution';
export const randomHead = 'random';
/** Where no seed has run yet. */
export const expectedText = 'Here will stand the median of all seeds, and beside it a dot for each.';
export const generationAxis = 'generation';
/** @param {number} lowest */
export const distanceAxis = (lowest) => `J above ${costText(lowest)}, the lowest of all`;
/** @param {number} seed */
export const labLine = (seed) => `the lab’s seed ${seed}`;
/** @param {number} seed */
export const seedLine = (seed) => `seed ${seed}`;

/** @param {SeedSurvey} survey @param {string} found */
export const curveLabel = ({ generations, paper }, found) =>
  `Best J over ${generations} generations. ${found}${Number.isFinite(paper.cost) ? ` The paper’s EP gains have J ${costText(paper.cost)} here.` : ''}`;
export const emptyCurveLabel = 'Best J over the generations of the lab’s run. No other seed has run yet.';

/** @param {SeedSurvey} survey */
export const gainsLabel = ({ summary }) =>
  `The gains in the end. ${summary.gains
    .map(
      ({ low, median, high }, i) =>
        `${gainNames[i]}: median ${fixed(median, 3)}, half of the seeds from ${fixed(low, 3)} to ${fixed(high, 3)}`,
    )
    .join('; ')}.`;
export const emptyGainsLabel = 'The gains in the end. No seed has run yet.';

/** @param {SeedSurvey} survey @param {number} index @param {number} rank */
export function readout({ first, runs }, index, rank) {
  const { champion } = runs[index];
  const gains = champion.gains.map((gain, i) => `${gainNames[i]} ${fixed(gain, 3)}`).join(', ');
  return `Seed ${first + index}, number ${rank} of ${runs.length}: J ${costText(champion.cost)}\n${gains}`;
}

/** @param {number} seed */
export const openSeed = (seed) => `Open seed ${seed} in the lab`;

/** @param {number} seeds @param {number} generations */
export const tableCaption = (seeds, generations) =>
  `${seeds} seeds over ${generations} generations: J of the best robot, its gains in the end, and random search with the same number of drives`;
export const seedColumn = 'seed';
/** @param {number} generation */
export const costColumn = (generation) => `J at generation ${generation}`;
export const randomColumn = 'J of random search';
export const quartiles = {
  least: 'lowest',
  low: 'lower quartile',
  median: 'median',
  high: 'upper quartile',
  most: 'highest',
};
