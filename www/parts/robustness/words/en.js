// Every word of the robustness part.
/** @import { Quantity } from '../request.js' */
/** @import { Drive, Place } from './common.js' */
import { placeText, shareText } from './common.js';
import { costText, degrees, fixed, grouped, tookText } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  robustnessPicture: 'The map of starts',
  robustnessTitle: 'Robustness',
  robustnessExtent: 'Metres from the goal to the edge of the map',
  robustnessAround: 'around the goal',
};

export const quantityLegend = 'What the colour means';
/** @type {import('../../../kit/segmented.js').Choices<Quantity>} */
export const quantities = {
  share: { text: 'Arrives', hint: 'How many of the headings arrive' },
  time: { text: 'Time', hint: 'The time of those that arrive' },
  cost: { text: 'J', hint: 'The cost of those that arrive' },
};

export const headingLegend = 'Headings of the starts';
/** @type {import('../../../kit/segmented.js').Choices<'all' | 'one'>} */
export const headingChoices = {
  all: { text: 'All', hint: 'All headings together' },
  one: { text: 'One heading', hint: 'One heading, chosen on the dial' },
};

/** @param {number} share */
export const percent = (share) => `${shareText(share)} %`;

/** @param {number} starts @param {number} milliseconds */
export const startsText = (starts, milliseconds) => `${grouped(starts)} starts in ${tookText(milliseconds)}`;

export const tracking = 'The reference moves: no drive ends by arriving.';
export const computing = 'the robots are driving …';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? 'The map could not be computed anew' : 'This could not be computed'}: ${message}`;

/** What follows the share, which is of all headings also where the map shows one. @param {string} name @param {boolean} isOne */
export const summary = (name, isOne) =>
  `arrive${isOne ? ', of all headings,' : ''} with ${withArticle(name)}`;

/** @param {string} name @param {number | null} share */
export const rivalText = (name, share) =>
  share === null ? `${withArticle(name)}: …` : `${percent(share)} with ${withArticle(name)}`;

/** Nobody says “the your gains”. @param {string} name */
const withArticle = (name) => (name.startsWith('your ') ? name : `the ${name}`);

/** @param {Record<'behind' | 'front' | 'left' | 'right', number>} shares */
export const sides = ({ behind, front, left, right }) =>
  `It arrives from ${percent(behind)} of the starts behind the goal, ${percent(front)} of those in front of it, ${percent(left)} of those on its left and ${percent(right)} of those on its right.`;

export const mapLabel =
  'Map of starts around the goal. Arrow keys move a cursor from cell to cell, with Shift by eight; Enter lets the robot drive from there.';
/** @param {number} step In degrees. */
export const roseLabel = (step) =>
  `Heading of the starts. Left and Right turn it by ${step}°; Escape takes all headings together.`;

/** @param {number | null} angle */
export const headingText = (angle) => (angle === null ? 'all headings' : degrees(angle));
export const allShort = 'all';
/** What the ring shows, and the lines where one points. @param {number} headings @param {boolean} withLines */
export const ring = (headings, withLines) =>
  withLines
    ? `Ring and lines: the ${headings} headings of one place. Empty or dashed: it does not arrive.`
    : `The ring: ${headings} headings at one place. Empty: it does not arrive.`;
/** The same where the disturbance is random: the map drives each start with a draw of its own. @param {number} headings @param {boolean} withLines */
export const ownDraws = (headings, withLines) =>
  `Ring: ${headings} headings of one place. ${withLines ? 'Lines and what you watch: other draws' : 'What you watch: another draw'} of the disturbance.`;
/** @param {'x' | 'y'} axis */
export const axisName = (axis) => `${axis} of the start (m)`;

/** @param {Quantity} quantity @param {boolean} all */
export const legendTitle = (quantity, all) =>
  ({
    share: all ? 'headings arriving' : 'arrives',
    time: all ? 'mean time of those that arrive' : 'time',
    cost: all ? 'mean J of those that arrive' : 'J',
  })[quantity];

/** @param {Quantity} quantity @param {string} text @param {boolean} open */
export const lastTick = (quantity, text, open) =>
  `${open ? '≥\u202f' : ''}${text}${{ share: ' %', time: ' s', cost: '' }[quantity]}`;

/** @param {boolean} all */
export const never = (all) => (all ? 'none arrives' : 'does not arrive');
export const few = '<\u202fhalf arrive';

export const goal = 'goal';
export const ownStart = 'start of J';

/** @param {number} arrived @param {number} headings */
const arrivals = (arrived, headings) =>
  arrived === headings
    ? `all ${headings} headings arrive`
    : arrived === 0
      ? `none of ${headings} headings arrives`
      : `${arrived} of ${headings} headings ${arrived === 1 ? 'arrives' : 'arrive'}`;

/** @param {Place} place @param {{ arrived: number, headings: number, time: number, cost: number }} cell */
export const cellText = (place, { arrived, headings, time, cost }) =>
  `${placeText(place)}: ${arrivals(arrived, headings)}${
    arrived === 0
      ? ''
      : `, ${arrived > 1 && arrived < headings ? 'these ' : ''}in ${fixed(time, 2)} s${arrived > 1 ? ' on average' : ''}, J\u00a0${fixed(cost, 2)}`
  }.`;

/** @param {Place} place @param {Drive} drive */
export const driveText = (place, drive) =>
  `${placeText(place)}, heading ${degrees(drive.heading)}: ${drive.outcome}, J\u00a0${costText(drive.cost)}.`;

/** @param {Drive} drive @param {number} next */
export const watching = (drive, next) =>
  `You watch ${degrees(drive.heading)}: ${drive.outcome}. Press again: ${degrees(next)}.`;

/** @param {number} worst @param {boolean} arrives */
export const invitation = (worst, arrives) =>
  arrives
    ? `Press: watch ${degrees(worst)}, the highest J of all.`
    : `Press: watch ${degrees(worst)}, the worst of those that fail.`;

/** @param {boolean} watched */
export const clickToWatch = (watched) => (watched ? 'You watch it.' : 'Press: watch it.');

/** Of the run on the plane. @param {Place} place @param {Drive} drive */
export const watched = (place, drive) => `You watch the start at ${driveText(place, drive)}`;

/** @param {number} arrived @param {number} headings */
export const there = (arrived, headings) => `From about there ${arrivals(arrived, headings)}.`;
