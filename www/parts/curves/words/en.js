// Every word of the curves.
/** @import { Run } from '../../../core/engine.js' */
import { numberColumnsOf } from './common.js';
import { isTracking } from '../../../core/reference.js';
import { costText, fixed, threeDigits } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  curvesPicture: 'The drive against time',
  curvesTitle: 'Curves',
  comparisonTable: 'Table of the pinned drives',
  numbersTable: 'Table of the drive in numbers',
};

export const viewLegend = 'What is shown';
/** @type {import('../../../kit/segmented.js').Choices<import('../state.js').CurvesView>} */
export const views = {
  time: 'Against time',
  stability: { text: 'Stability', hint: 'The Lyapunov function V and its rate' },
  compare: 'Compare',
  numbers: 'Numbers',
};

export const limit = 'limit';

/** @param {string} name @param {Run} run @param {string} outcome @param {string} comparison @param {readonly string[]} pins */
export const pictureLabel = (name, run, outcome, comparison, pins) =>
  `x and y, θ, v, ω and J against time: ${name}, J ${costText(run.cost.total)}, ${outcome}. Dotted: ${comparison}.${pins.map((pin) => ` Pinned: ${pin}.`).join('')} Under “Numbers” all of it is a table.`;

/** @param {'5' | '7'} figure */
export const figureNote = (figure) =>
  figure === '5'
    ? 'Figure 5 of the paper shows this pair: EP’s gains solid, the arbitrary ones dotted.'
    : 'Figure 7 of the paper shows this pair, but θ below 60°: no limits tried give that.';

/** @param {string} name @param {number} step */
export const numbersCaption = (name, step) =>
  `${name}: one row for every ${threeDigits(step)} s, and the end. v and ω are what the robot does from then on.`;

export const numberColumns = numberColumnsOf({
  'command-linear': 'v asked',
  'command-angular': 'ω asked',
  paid: 'J paid',
});

export const noPinsText =
  'Pin a drive with “Pin this drive”, then evolve on, take another seed or setting, or drive by hand: here you see what differs.';
/** @param {number} count */
export const pinsText = (count) => `${count} of 4 pinned; names can be changed.`;
/** @param {number} slot */
export const nameLabel = (slot) => `Name of pinned drive ${slot + 1}`;
/** @param {string} name */
export const unpin = (name) => `Unpin ${name}`;
export const nameNeeded = 'A pinned drive needs a name of at least one letter; it keeps its old one.';

export const unpinShort = 'Unpin';

/** @param {string} name */
export const drivingColumn = (name) => `now: ${name}`;
/** With a place to break in a narrow column. @param {string} name */
export const breakable = (name) => name.replaceAll('generation', 'gener\u00adation');

export const outcomeHead = 'goal';
/** @param {Run} run */
export const outcomeShort = (run) =>
  isTracking(run) ? 'followed' : { arrived: 'reached', horizon: 'missed', diverged: 'missed' }[run.outcome];
export const finalTimeHead = 'end';
/** @param {Run} run */
export const finalTimeText = ({ finalTime }) => `${fixed(finalTime, 2)} s`;
export const settingsThatDiffer = 'Settings that differ';
export const sameSettings = 'All settings are the same.';
export const startsHead = 'Evolved on';
/** @param {number} count */
export const startsText = (count) => (count === 1 ? '1 start' : `${count} starts`);
