// Every word of the training part.
/** @import { Evolved, Result, RowName } from '../request.js' */
import { cost, isEvolved, shareOf } from './common.js';
import { fixed, grouped, postureText, tookText } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  trainingPicture: 'The starts of training',
  trainingTitle: 'Training',
  trainingGenerations: 'Generations of each evolution',
  trainingProgress: 'Evolution on all three sets of starts',
  trainingTable:
    'What each robot’s gains are worth from starts that evolution saw and from those it never saw',
};

export const evolveAll = 'Evolve all three';
export const evolveAgain = 'Evolve again';
/** @param {number} count */
export const seedsButton = (count) => `${count} seeds`;
/** @param {number} count */
export const seedsHint = (count) => `Evolve all three again with other seeds: a dot for each of ${count}`;
export const cancel = 'Cancel';
/** @param {number} generations */
export const generationsChoice = (generations) => `${generations} generations`;

/** Groups of three digits, when there are more than four. @param {number} value */
const whole = (value) => (value < 10_000 ? String(value) : grouped(value));

/** @param {number} part @param {number} count */
export const percent = (part, count) => `${shareOf(part, count)}\u202f%`;

/** @param {number} count */
const starts = (count) => (count === 1 ? 'one start' : `${count} starts`);

/** @param {RowName} name @param {number} count The number of starts that it was evolved on. */
export const rowName = (name, count) =>
  ({
    one: `… ${starts(count)}`,
    circle: `… circle of ${count}`,
    grid: `… grid of ${count}`,
    'paper-ep': 'Paper: EP',
    'paper-arbitrary': 'Paper: arbitrary',
    hand: 'By hand',
  })[name];

/** @param {number} unseen @param {number} own The starts of the experiment. */
export const columnsOf = (unseen, own) => [
  'gains evolved on …',
  'arrives, trained on',
  `arrives, of ${whole(unseen)} never seen`,
  'mean J',
  own === 1 ? 'J from start' : `J from ${own} starts`,
];

/** @param {number} part @param {number} count */
export const of = (part, count) => `${whole(part)} of ${whole(count)}`;
/** @param {RowName} name @param {Result | null} result @param {number} count */
export function trainingTitle(name, result, count) {
  if (!result) return `${count === 1 ? 'The start' : `The ${count} starts`} to train on`;
  const all = result.training.starts.length;
  const arrives = of(result.training.count, all);
  return `${isEvolved(name) ? 'Trained on' : all === 1 ? 'From the start' : 'From the starts'}: ${arrives}`;
}

/** @param {Result | null} result @param {number} count */
export const unseenTitle = (result, count) =>
  result ? `Never seen: ${of(result.unseen.count, count)}` : `${whole(count)} starts never seen`;

/** @param {string} title */
export const pictureLabel = (title) =>
  `${title}. Left and Right go from start to start, each drives from there.`;

/** @param {import('../../../core/engine.js').Posture} start @param {string} outcome */
export const readout = (start, outcome) => `From ${postureText(start)}: the robot ${outcome}.`;

export const signs = { arrives: 'Filled arrives,', misses: 'small, pale and open does not.' };

export const pressOne = 'Press one to drive from it.';

/** What the pictures and the columns mean. @param {number} count @param {number} radius @param {number} horizon */
export const key = (count, radius, horizon) =>
  `Never seen: ${whole(count)} starts within ${fixed(radius, 0)} m of the goal, any heading. Mean J is over all of them, each stopped at ${Number(horizon.toFixed(3))} s at the latest.`;

/** @param {Evolved} evolved */
export const evolvedNote = ({ experiment, generations, drives, milliseconds }) =>
  `seed ${experiment.evolution.seed}, ${generations} generations: ${whole(drives)} drives in ${tookText(milliseconds)}`;

export const driving = 'the robots are driving …';

/** @param {number} count The starts of the experiment. */
export const invitation = (count) =>
  `Evolve on ${count === 1 ? 'one start and on many' : 'three sets of starts'}: which robot gets further?`;

/** @param {Result} ep */
export const question = (ep) =>
  `The paper’s EP gains arrive from ${percentOf(ep)} of ${whole(ep.unseen.starts.length)} starts around the goal. ${invitation(ep.training.starts.length)}`;

/** @param {Result} result */
const percentOf = ({ unseen }) => percent(unseen.count, unseen.starts.length);

/** What the three evolutions have found. @param {Evolved} evolved */
export function lesson({ results: { one, circle, grid } }) {
  const found = [
    `Evolved on ${starts(one.training.starts.length)}: arrives from ${percentOf(one)} of ${whole(one.unseen.starts.length)} starts it never saw.`,
    `On a circle of ${circle.training.starts.length}: ${percentOf(circle)}, on a grid of ${grid.training.starts.length}: ${percentOf(grid)}.`,
  ];
  const best = circle.unseen.count >= grid.unseen.count ? circle : grid;
  return `${found.join(' ')} ${moral(one, best, best === circle ? 'circle' : 'grid')}`.trim();
}

export const tracking =
  'The reference moves: the robots follow it, and none arrives. Evolve on each set of starts, and compare the mean J.';

/** The same where the reference moved. @param {Evolved} evolved */
export const followed = ({ results: { one, circle, grid } }) =>
  `The reference moves, so none arrives: compare the mean J from ${whole(one.unseen.starts.length)} starts never seen. Evolved on ${starts(one.training.starts.length)}: ${cost(one.unseen.cost)}. On a circle of ${circle.training.starts.length}: ${cost(circle.unseen.cost)}, on a grid of ${grid.training.starts.length}: ${cost(grid.unseen.cost)}.`;

/** How far luck reaches. @param {Record<import('../sets.js').SetName, import('../spread.js').Range>} ranges @param {number} unseen @param {number} own The starts of the experiment. */
export function spreadText({ one, circle, grid }, unseen, own) {
  const told = (/** @type {import('../spread.js').Range} */ { least, median, most }) =>
    `${percent(median, unseen)} (${shareOf(least, unseen)} to ${percent(most, unseen)})`;
  return `One seed is a matter of luck. With ${one.seeds} seeds the robots evolved on ${starts(own)} arrive from a median (least to most) of ${told(one)} of the starts they never saw, those of the circle from ${told(circle)}, those of the grid from ${told(grid)}.`;
}

/** What more arrivals cost, or why there are no more. Nothing where neither is so. @param {Result} one @param {Result} many @param {string} where */
function moral(one, many, where) {
  const arrivesMore = many.unseen.count > one.unseen.count;
  if (arrivesMore && many.own > one.own)
    return `The price: evolved on the ${where}, J from the experiment’s ${one.training.starts.length === 1 ? 'start' : 'starts'} is ${cost(many.own)}, not ${cost(one.own)}.`;
  if (!arrivesMore && many.unseen.cost < one.unseen.cost)
    return `Yet the mean J falls to ${cost(many.unseen.cost)} from ${cost(one.unseen.cost)}: J asks for a cheap drive, not for an arrival.`;
  return '';
}

/** @param {('start' | 'goal' | 'limits' | 'seed' | 'settings')[]} changes */
export function outOfDate(changes) {
  const names = { start: 'start', goal: 'goal', limits: 'limits', seed: 'seed', settings: 'settings' };
  const all = changes.map((change) => names[change]);
  const other = all.some((name) => name.endsWith('s')) || all.length > 1 ? 'other' : 'another';
  return `Evolved for ${other} ${all.join(' and ')}: evolve again.`;
}

/** @param {boolean} kept */
export const cancelled = (kept) =>
  kept ? 'Cancelled: these are the results from before.' : 'Cancelled before there was a result.';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? 'What is shown is the last that could be computed' : 'This could not be computed'}: ${message}`;

/** @param {string} name */
export const chooseHint = (name) => `Drive with these gains: ${name}`;
