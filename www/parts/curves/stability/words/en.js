// Every word of the Lyapunov function beside the robot.
/** @import { Summary } from '../summary.js' */
import { amount, errorNames, gainNames, termsOf } from './common.js';
import { fixed, threeDigits } from '../../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  stabilityPicture: 'V and its rate against time',
  stabilityTable: 'Table',
  stabilityLog: 'log',
};

export const terms = termsOf({ rate: ['V̇ robot'], promised: ['V̇ law ='] });

/** @param {boolean} limited */
export const limitedText = (limited) => (limited ? 'yes' : '');

/** @param {string} name @param {number} step */
export const tableCaption = (name, step) =>
  `${name}: one row for every ${threeDigits(step)} s, and the end. V̇ robot is what limits and disturbance leave of V̇ law, which is the sum of its three parts.`;

export const tableColumns = [
  't s',
  'xₑ m',
  'yₑ m',
  'θₑ °',
  'V',
  'part of xₑ',
  'part of yₑ',
  'part of θₑ',
  'V̇ law',
  'V̇ robot',
  'cut by limits',
];

/** @param {readonly string[]} names */
const listed = (names) => names.join(names.length > 2 ? ', ' : ' and ');

/** What the picture shows, in whole sentences. @param {Summary} summary */
export const noteText = (summary) =>
  summary.seconds === 0
    ? 'The robot has arrived where it starts: nothing is driven.'
    : [valueText, raisedText, limitsText, samplingText, lawText]
        .map((text) => text(summary))
        .filter(Boolean)
        .join(' ');

/** @param {Summary} summary */
function valueText({ from, to, rising, seconds }) {
  if (from === 0 && to === 0) return 'V is 0: the robot is at its goal from the start.';
  const [first, last] = [from, to].map(amount);
  const ends = `from ${first} to ${last}`;
  if (rising > 0)
    return `V goes ${ends} and rises (thick, marked below) for ${fixed(rising, 2)} of ${fixed(seconds, 2)} s.`;
  if (first === last) return `V never rises: it stays at ${first}.`;
  return to < 0.01 * from ? `V falls all the way, ${ends}.` : `V never rises: it goes ${ends}.`;
}

/** @param {Summary} summary */
function raisedText({ raised, negative, referenceSpeed }) {
  if (raised.length === 0) return '';
  const guilty = raised.filter((part) => negative.includes(part));
  const what =
    raised.length === 1
      ? `The part of ${errorNames[raised[0]]} is`
      : `The parts of ${listed(raised.map((part) => errorNames[part]))} are`;
  const why =
    guilty.length > 0
      ? `, because ${listed(guilty.map((part) => gainNames[part]))} ${guilty.length > 1 ? 'are' : 'is'} negative`
      : referenceSpeed < 0
        ? ', because the reference drives backwards'
        : '';
  return `${what} above zero${why}: the law itself drives V up.`;
}

/** @param {Summary} summary */
function limitsText({ limited, disturbed, isPromised, isLaw }) {
  const pushed = disturbed ? 'The disturbance moves V̇ robot off V̇ law.' : '';
  if (limited === 0)
    return disturbed || !isPromised
      ? pushed
      : isLaw
        ? 'No limit cuts the command: V̇ robot is V̇ law.'
        : 'No limit cuts the command, but where the law would divide by 0 it is guarded: there V̇ robot is not V̇ law.';
  return `Under the bar on top: for ${fixed(limited, 2)} s limits cut the command, and V̇ robot is not V̇ law. ${pushed}`.trim();
}

/** @param {Summary} summary */
const samplingText = ({ causes, sampleTime }) =>
  causes.includes('sampling')
    ? `Between two samples V can rise though V̇ is below zero at both: a command is held for ${threeDigits(sampleTime)} s.`
    : '';

/** @param {Summary} summary */
function lawText({ law, isPromised, referenceSpeed }) {
  if (law !== 'kanayama') return '';
  if (!isPromised) return 'Kanayama’s rule promises nothing unless ky > 0; V is that of law (5).';
  return referenceSpeed === 0
    ? 'Kanayama’s rule, goal at rest: only x, how far the goal is ahead, is in V̇. Once beside the goal the robot stays there.'
    : 'Kanayama’s rule has a V of its own; x is how far the reference is ahead of the robot.';
}

/** @param {string} name @param {Summary} summary */
export const pictureLabel = (name, summary) =>
  `V and V̇ against time: ${name}. ${noteText(summary)} Under “Table” are the numbers.`;
