// Every word of the disturbance part.
/** @import { Experiment } from '../../../core/engine.js' */
/** @import { PartName, Summary } from '../summary.js' */
import { edgePercent, usualStarts } from '../numbers.js';
import {
  amount,
  crestSeconds,
  edgeMark,
  equations,
  farthestOf,
  formulaText,
  hasEdge,
  isPromised,
  parts,
  unitOf,
} from './common.js';
import { grouped, sixDigits, threeDigits } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  disturbancePicture: 'What remains of the error',
  disturbanceTitle: 'Disturbance',
  disturbanceControls: 'The disturbance',
  disturbanceSizes: 'Size of the disturbance',
  disturbanceDraw: 'New draw',
  remainsPart: 'error',
  remainsDrive: 'this drive',
  remainsSet: 'its set',
  remainsInside: 'others inside',
  remainsInsideHint: `How many stay, in these seconds, within the farthest reach of their own set; ${edgeMark}: how many come to its edge`,
  remainsEdge: 'others on the edge',
};

export const kindLegend = 'Kind of disturbance';
/** @type {import('../../../kit/segmented.js').Choices<Experiment['disturbance']['kind']>} */
export const kinds = {
  none: 'None',
  random: { text: 'Random', hint: 'Drawn afresh at each sample, evenly between −ε and ε' },
  slip: { text: 'Slip', hint: 'The same at every sample' },
};

/** @param {Experiment['disturbance']} disturbance */
export const kindText = ({ kind, seed }) =>
  ({
    none: 'nothing is added to the velocity that the robot applies',
    random: `|δ1| ≤ ε1, |δ2| ≤ ε2, drawn afresh at each sample; draw ${seed}`,
    slip: 'δ1 and δ2 are added to v and ω, the same at every sample',
  })[kind];

/** Where the experiment has another. @param {Experiment['disturbance']} own */
export const ownText = ({ kind, linear, angular }) =>
  `only tried here; in the experiment: ${kind}, ${threeDigits(linear)} m/s, ${threeDigits(angular)} rad/s`;

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? 'These are the last that could be measured' : 'This could not be computed'}: ${message}`;

/** @param {PartName} part */
export const axisUnit = (part) => (unitOf[part] ? ` in ${unitOf[part]}` : '');

/** @param {number} starts */
const startsText = (starts) => `${starts} other ${starts === 1 ? 'start' : 'starts'}`;
/** Of all that was measured. @param {number} starts */
export const othersColumns = (starts) => [`median of ${startsText(starts)}`, 'largest of them'];
/** @param {PartName} part */
export const measureText = (part) => `${formulaText(part)}${axisUnit(part)}`;
/** @param {PartName} part */
export const calmText = (part) => `${measureText(part)}, undisturbed`;
/** @param {number} seconds */
export const tableCaption = (seconds) =>
  `${texts.disturbancePicture}: the largest of the ${lastText(seconds)}`;
/** @param {number} seconds */
export const lastText = (seconds) => `last ${sixDigits(seconds)} s`;
/** @param {Summary} summary */
export const captionText = (summary) =>
  `largest of the ${lastText(summary.seconds)}${summary.disturbed ? '; small: undisturbed' : ''}${hasEdge(summary) ? `; ${edgeMark}: edge ± ${edgePercent} %` : ''}`;

export const legend = {
  solid: 'this drive',
  others: `other starts, largest of each ${crestSeconds} s`,
  set: 'set of Theorem 2, (6) to (8): outside all three, V̇ < 0',
};
export const equationHints = {
  x: 'ε1 / kx',
  y: 'the cube root of ε1 |sin θₑ| / ky',
  theta: 'ε2 / kθ',
};

/** @param {PartName} part @param {Summary} summary */
export const plotLabel = (part, summary) => {
  const { rows, seconds, horizon } = summary;
  const { drive, set } = rows[part];
  return `${formulaText(part)} over ${sixDigits(horizon)} s: in the last ${sixDigits(seconds)} s this drive stays within ${amount(part, drive)}${isPromised(summary) ? `; its set of Theorem 2 reaches to ${amount(part, set)}` : ''}.`;
};

/** What came out, in whole sentences. @param {Summary} summary */
export function summaryText(summary) {
  return [driveText(summary), othersText(summary), fewText(summary), theoremText(summary)]
    .filter(Boolean)
    .join(' ');
}

/** @param {readonly PartName[]} of */
const setsText = (of) =>
  of.length === 3
    ? 'all three sets'
    : `set${of.length > 1 ? 's' : ''} ${of.map((part) => equations[part]).join(' and ')}`;

/** @param {Summary} summary */
function driveText(summary) {
  const { rows, pushed, seconds, disturbed } = summary;
  const last = `In the last ${sixDigits(seconds)} s`;
  if (!disturbed || !isPromised(summary)) {
    const left = parts.map((part) => `${formulaText(part)} ${amount(part, rows[part].drive)}`).join(', ');
    const promise = isPromised(summary) ? 'Without a disturbance, Theorem 2 lets the error go to 0. ' : '';
    return `${promise}${last} this drive still has up to ${left}.`;
  }
  const { outside, edge } = farthestOf(summary);
  if (outside.length === 0)
    return edge.length === 0
      ? `${last} this drive stays within reach of ${setsText(pushed)}.`
      : `${last} this drive comes within ${edgePercent} % of the edge of ${setsText(edge)}.`;
  const excess = outside.map(
    (part) =>
      `${formulaText(part)} reaches to ${amount(part, rows[part].drive)}, its set to ${amount(part, rows[part].set)}`,
  );
  return `${last} this drive leaves ${setsText(outside)}: ${excess.join('; ')}.`;
}

/** @param {Summary} summary */
function othersText(summary) {
  const { calm, starts, allInside, allEdge, pushed, worst, disturbed } = summary;
  const most = `up to ${amount(worst, calm[worst].largest)} of ${formulaText(worst)} remain`;
  if (!isPromised(summary))
    return `From ${startsText(starts)}, ${disturbed ? 'even undisturbed, ' : ''}${most}.`;
  const all = pushed.length === 3 ? 'all three' : setsText(pushed);
  const atEdge = `, ${allEdge} within ${edgePercent} % of an edge`;
  const others = disturbed
    ? `Of ${startsText(starts)}, ${allInside || 'none'} ${allInside > 1 ? 'stay' : 'stays'} within reach of ${all}${allEdge > 0 ? atEdge : ''}; even undisturbed, ${most}`
    : `From ${startsText(starts)}, ${most}`;
  return `${others}: the theorem does not say how soon; limits and samples are left out.`;
}

/** Why there are so few others. @param {Summary} summary */
const fewText = ({ starts, horizon, samples }) =>
  starts < usualStarts
    ? `Only ${startsText(starts)} instead of ${usualStarts}: a drive of ${sixDigits(horizon)} s has ${grouped(samples)} samples.`
    : '';

/** Why the theorem is not about this drive, or a set so wide that it says nothing. @param {Summary} summary */
function theoremText({ law, isPositive, rows, ky, disturbed }) {
  if (law !== 'shim-kim') return 'The theorem is about law (5), not about the rule that drives here.';
  if (!isPositive) return 'The theorem is about gains above 0: for any other there is no set.';
  if (!disturbed || rows.y.set < 1) return '';
  return `With ky ${threeDigits(ky)} the set of ${formulaText('y')} reaches to ${amount('y', rows.y.set)}: it promises little.`;
}
