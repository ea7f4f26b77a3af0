// Every word of the lab and of what all pages share.
/** @import { Posture, Run, Statistics } from '../../core/engine.js' */
/** @import { Driver, Restart, Until } from '../common/kinds.js' */
import { isTracking } from '../../core/reference.js';
import { counted } from './counted.js';
import {
  clockTime,
  costText,
  fixed,
  grouped,
  postureText,
  sixDigits,
  textBelow,
  textsApart,
  wasText,
} from './numbers.js';

export * from '../common/lab.js';
export * from './computing.js';
export * from './numbers.js';

/** Texts of elements with data-text, labels of elements with data-label. */
export const texts = {
  pageTitle: 'Evolving a robot’s controller',
  pageDescription:
    'Watch evolutionary programming find the gains of a mobile robot’s posture controller (Kim and Shim 1995).',
  pages: 'Parts of this page',
  skip: 'Skip to the content',
  evolutionSection: 'Evolution',
  planeSection: 'The robots',
  robotClock: 'Clock of the robots',
  speed: 'Speed of the robots',
  scrub: 'Time of the robots',
  curveTitle: 'Fitness curve',
  generationBefore: 'generation',
  generationAfter: '',
  evolutionClock: 'Clock of evolution',
  pauseEvolution: 'Pause evolution',
  oneGeneration: '1 generation',
  oneBack: '1 generation back',
  timeline: 'Generation',
  pace: 'Pace of evolution',
  until: 'When evolution pauses',
  untilValue: 'Generation or J at which evolution pauses',
  reset: 'Reset',
  newSeed: 'New seed',
  seedWord: 'seed',
  gainsTitle: 'Gains',
};

export const presetLegend = 'Limits of the robot';
/** @type {import('../../kit/segmented.js').Choices<import('../../core/engine.js').Preset>} */
export const presets = {
  'velocity-limits': { text: 'Velocity limits', hint: 'Figures 4 and 5 of the paper' },
  'acceleration-limits': { text: '+ acceleration limits', hint: 'Figures 6 and 7 of the paper' },
};

export const driverLegend = 'What drives';
/** @type {import('../../kit/segmented.js').Choices<Driver>} */
export const drivers = {
  evolved: 'Evolved best',
  hand: 'By hand',
  'paper-ep': {
    text: 'Paper: EP',
    hint: 'The gains that evolutionary programming found in the paper',
  },
  'paper-arbitrary': {
    text: 'Paper: arbitrary',
    hint: 'The gains that the paper compares with, chosen without evolution',
  },
};

export const labName = 'Lab';
/** What it is for. @param {number} population How many robots there are. */
export const labPurpose = (population) =>
  `${counted(population, 'robot with three random gains drives', 'robots, each with three random gains, drive')} to the goal. Evolution keeps what drives well.`;

export const endTrial = 'Back to its own start';

/** Gains by hand, by where they are from. @type {Record<import('../common/kinds.js').Found, string>} */
export const foundName = {
  hand: 'your gains',
  map: 'gains from the landscape',
  training: 'gains from Training',
  luck: 'gains from Luck',
};

/** @param {Driver} driver @param {number} generation @param {import('../common/kinds.js').Found} found */
export const driverName = (driver, generation, found) =>
  ({
    evolved: `best of generation ${generation}`,
    hand: foundName[found],
    'paper-ep': 'paper’s EP gains',
    'paper-arbitrary': 'paper’s arbitrary gains',
  })[driver];

/** @param {number} starts Of which the first is driven from. */
export const costMeaning = (starts) =>
  starts > 1 ? `J from the first of ${starts} starts, lower is better` : 'J, lower is better';

/** @param {Driver} driver @param {import('../common/kinds.js').Found} found @param {boolean} isLowest Of all generations: some searches forget theirs. */
export const costTitle = (driver, found, isLowest) =>
  ({
    evolved: isLowest ? 'Cost of the best robot' : 'Cost of this generation’s best robot',
    hand: found === 'hand' ? 'Cost of your gains' : 'Cost of these gains',
    'paper-ep': 'Cost of the paper’s EP gains',
    'paper-arbitrary': 'Cost of the paper’s arbitrary gains',
  })[driver];

/** @param {Run} run */
export const outcomeText = (run) =>
  ({
    arrived: `arrives after ${fixed(run.finalTime, 2)} s`,
    horizon: isTracking(run)
      ? `follows the reference for ${sixDigits(run.finalTime)} s`
      : `has not arrived after ${sixDigits(run.finalTime)} s`,
    diverged: 'diverges',
  })[run.outcome];

/** @param {string} name @param {number} cost */
export const costNote = (name, cost) => `${name} here: J\u00a0${costText(cost)}`;

/** @param {number} starts @param {number} cost */
export const meanNote = (starts, cost) => `mean over all ${starts} starts:\u00a0${costText(cost)}`;

/** @param {number} value */
export const partText = (value) => (value < 100 ? fixed(value, 2) : costText(value));

/** @type {readonly (readonly [part: Exclude<keyof import('../../core/engine.js').Cost, 'total'>, name: string])[]} */
export const costParts = [
  ['time', 'time'],
  ['path', 'path'],
  ['energy', 'energy'],
  ['finalError', 'final'],
  ['penalty', 'penalty'],
];

/** @param {{ others: number, population: number, arrived: number | null }} drives Null where nobody can arrive. */
export function othersText({ others, population, arrived }) {
  const areAll = others === population - 1;
  if (others === 1) {
    const one = areAll ? 'the other one' : `the next of ${population}`;
    return arrived === null ? one : `${one} ${arrived === 1 ? 'arrives' : 'does not arrive'}`;
  }
  const who = areAll ? `the other ${others}` : `the next ${others} of ${population}`;
  return arrived === null ? who : `${who}, ${arrived} of them ${arrived === 1 ? 'arrives' : 'arrive'}`;
}

/** @param {string} name @param {Run} run */
export const comparisonText = (name, run) => `${name}, J ${costText(run.cost.total)}`;

export const withoutDisturbance = 'the same without the disturbance';

export const dragHint = 'drag or turn them';
export const startName = 'Start';
export const goalName = 'Goal';
export const referenceName = 'reference';
export const restorePostures = 'Back to the paper’s postures';

/** @param {string} name */
export const positionLabel = (name) =>
  `${name}. Arrow keys move it by 0.1 m, with Alt by 0.01 m; Shift with Left or Right turns it by 5°.`;

/** @param {string} name */
export const headingLabel = (name) =>
  `Heading of the ${name.toLowerCase()}. Left and Right turn it by 5°, with Alt by 1°.`;

export const planeLabel = 'The plane, with the robots driving from start to goal';

/** `time` is empty while the clock runs. @param {string} name @param {Run} run @param {Posture} start @param {Posture} goal @param {string} time @param {string} others @param {string[]} pins */
export const planeText = (name, run, start, goal, time, others, pins) =>
  `Driving: ${name}, from ${postureText(start)} to ${postureText(goal)}; it ${outcomeText(run)}.${time && ` Shown at ${time}.`} ${others}${pins.length > 0 ? ` Pinned: ${pins.join('; ')}.` : ''}`;

/** @param {number} time @param {number} finalTime */
export const clockText = (time, finalTime) =>
  `${clockTime(time, finalTime)} of ${clockTime(finalTime, finalTime)} s`;

export const play = 'Let the robots drive';
export const pause = 'Hold the robots';
export const run = 'Run';
export const pauseEvolution = 'Pause';

/** @param {number} pace Generations in a second; with 0 it is one phase at a time. */
export const paceText = (pace) =>
  pace === 0 ? 'one phase at a time' : Number.isFinite(pace) ? `${pace} gen/s` : 'fastest';

/** @type {readonly (readonly [kind: Until['kind'], text: string])[]} */
export const untils = [
  ['every', 'pause every 100'],
  ['generation', 'until generation'],
  ['cost', 'until J is below'],
];

/** What is wrong with it, if anything. @param {Until['kind']} kind @param {number} value @param {string} text @param {number} next The first generation that is yet to come. @param {number} last */
export const untilRefused = (kind, value, text, next, last) =>
  kind === 'generation'
    ? Number.isInteger(value) && value >= next && value <= last
      ? ''
      : `The generation to stop at must be a whole number from ${next} to ${last}; ${wasText(text)}`
    : value > 0 && value < Number.POSITIVE_INFINITY
      ? ''
      : `The J to stop at must be a number over 0; ${wasText(text)}`;

/** @param {number} generation @param {number} newest */
export const generationText = (generation, newest) => `generation ${generation} of ${newest}`;

/** @param {number} generation @param {number} newest */
export const recordedText = (generation, newest) =>
  `Back in generation ${generation} of ${newest}: all of it is as it was.`;

/** @param {Restart} restart @param {number} population @param {boolean} isPapers Whether it is the paper's evolution. */
export const restartText = (restart, population, isPapers) =>
  ({
    begin: isPapers
      ? population === 1
        ? '1 random robot: it has one offspring, a tournament keeps one of the two.'
        : `${counted(population, 'random robot', 'random robots')}: each has one offspring, a tournament keeps ${population}.`
      : 'Generation 0 of another search than the paper’s.',
    moved: 'Start or goal has moved: evolution begins again at generation 0.',
    limits: 'Other limits: evolution begins again at generation 0.',
    seed: `New seed: ${counted(population, 'other robot', 'other robots')} at generation 0.`,
    setting: 'A setting has changed: evolution begins again at generation 0.',
    undone: 'One step back: evolution begins again at generation 0.',
    redone: 'One step forward again: evolution begins at generation 0.',
    given: 'As the exercise has it: evolution begins again at generation 0.',
    reset: 'Generation 0 again. The same seed gives the same evolution.',
  })[restart];

/** @param {Statistics} first @param {Statistics} newest */
export function progressText(first, newest) {
  const drives = `${grouped(newest.evaluations)} drives so far`;
  const [from, to] = textsApart(first.best.cost, newest.best.cost, costText);
  return from === to
    ? `${drives}; the best J is still ${to}.`
    : `${drives} took the best J from ${from} to ${to}.`;
}

/** @param {number} generation */
export const restText = (generation) => `Paused at generation ${generation}. Press Run to go on.`;

/** @param {number} value Below which J was to come. @param {Statistics} statistics */
export const reachedText = (value, { generation, best }) =>
  `Paused at generation ${generation}: J ${textBelow(best.cost, value, costText)} is below ${sixDigits(value)}.`;

/** @param {Statistics} statistics */
export const announcement = (statistics) =>
  `Generation ${statistics.generation}: best J ${costText(statistics.best.cost)}`;

export const bestLine = 'best';
export const medianLine = 'median';
export const paperLine = 'paper’s EP';
/** @param {number} metres */
export const outside = (metres) => `${fixed(metres, 1)} m outside`;

/** @param {Statistics} first @param {Statistics} newest */
export const curveLabel = (first, newest) =>
  `Fitness curve over ${newest.generation} generations: best J from ${costText(first.best.cost)} to ${costText(newest.best.cost)}, median from ${costText(first.median)} to ${costText(newest.median)}.`;

export const generationAxis = 'generation';
/** @param {Driver} driver @param {boolean} isPapers Whether a hand is compared with the paper's evolution. @param {number | null} cost Of what it is compared with, if it is of the same drive. */
export const gainsNote = (driver, isPapers, cost) =>
  ({
    evolved: 'move one to drive by hand',
    hand: `can you beat ${isPapers ? 'the paper' : 'evolution'}${cost === null ? '' : `’s ${costText(cost)}`}?`,
    'paper-ep': 'found by evolution in the paper',
    'paper-arbitrary': 'chosen without evolution',
  })[driver];

/** Where starts around it are asked for. */
export const goalAtEdge =
  'the goal is too near the edge of the plane, ±1000 m: starts around it would lie outside';

export const gainsReplaced = 'Undo (Ctrl+Z) brings yours back';

/** @param {string} name */
export const gainInputLabel = (name) => `${name}, value`;

/** @param {string} name @param {string} was */
export const notANumber = (name, was) => `${name} must be a number, for example 3.5; ${wasText(was)}`;
/** @param {string} name @param {string} message */
export const gainRefused = (name, message) => `${name} was refused: ${message}`;
