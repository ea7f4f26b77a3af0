// Every word of checking hand-ins.
/** @import { Row, Worth } from '../check.js' */
/** @import { Column } from './common.js' */

export * from './common.js';

export const texts = {
  help: 'Paste what your students handed in, or drop files and folders here: receipts, links, a column or the whole table of Moodle or Canvas, their online texts. A zip is to be unpacked first. Every drive is computed again here, and nothing leaves this page.',
  paste: 'What was handed in',
  exercise: 'Link of the exercise (if empty: that of most students)',
  files: 'Choose files',
  folder: 'Choose a folder',
  empty: 'Another class',
  check: 'Check',
  cancel: 'Cancel',
  csv: 'Table for the gradebook (CSV)',
  progress: 'Checked so far',
  open: 'Open',
  before: 'Previous',
  after: 'Next',
  table: 'The hand-ins',
  histogram: 'How many have which J',
  gains: 'Their gains',
  costAxis: 'J',
  larger: 'larger',
  strip: 'The hand-ins',
  stripBack: 'The browser’s Back leads to the run that was here before.',
  countAxis: 'hand-ins',
};

/** Half have at most the middle one. @param {number} count @param {string} least @param {string} middle @param {string} most */
export const histogramLabel = (count, least, middle, most) =>
  `${texts.histogram}: ${count}, from J ${least} to ${most}, half of them at most ${middle}`;
/** @param {string} name @param {string} low @param {string} high */
export const reachText = (name, low, high) => `${name} from ${low} to ${high}`;
/** @param {readonly string[]} reaches */
export const gainsLabel = (reaches) => `${texts.gains}: ${reaches.join(', ')}`;

/** @type {Readonly<Record<Column, string>>} */
export const columns = {
  number: 'No.',
  pin: 'Pin',
  name: 'Name',
  who: 'Claims to be',
  cost: 'J',
  met: 'Aim',
  points: 'Points',
  drives: 'Drives',
  remark: 'Remarks',
  open: 'See it',
};

/** @param {string} column */
export const sortBy = (column) => `Sort by ${column}`;

/** @param {string} name */
export const openLabel = (name) => `Open the run of ${name}`;

/** @param {string} name */
export const pinLabel = (name) => `Pin the run of ${name}`;

export const met = 'met';
export const notMet = 'not met';
/** Of a receipt that did not come whole: it has no points. */
export const cut = 'cut';

/** @param {number} drives @param {boolean} isTold */
export const drivesText = (drives, isTold) => (isTold ? `${drives} (says)` : String(drives));

/** @type {Readonly<Record<Exclude<Worth, 'holds' | 'otherResult'>, string>>} */
export const worths = {
  broken: 'the receipt was cut or changed: no points',
  otherProgram: 'made by another version of the program',
  none: 'a link without a receipt',
};

export const lacksWho = 'not judged: it has no name or number, for which the exercise is drawn';
export const unseen = 'its name or number holds characters that nobody sees';
export const lacksDrives = 'not judged: nobody knows how many drives it took';

/** @param {number} told */
export const otherResult = (told) => `says J = ${told}, which its drive does not have`;

/** @param {readonly string[]} names */
export const differs = (names) => `differs from the exercise in ${names.join(', ')}`;

/** @param {string} cost */
export const ownCost = (cost) => `J = ${cost} in what was handed in`;

/** @param {readonly { number: number, name: string }[]} twins @param {number} more */
export const same = (twins, more) =>
  `same answer as ${twins.map(({ number, name }) => `${number} ${name}`.trim()).join(', ')}${more > 0 ? ` and ${more} more` : ''}`;

/** @param {readonly number[]} numbers @param {number} more */
export const also = (numbers, more) =>
  `the same student also has ${numbers.join(', ')}${more > 0 ? ` and ${more} more` : ''}`;

/** @param {string} text @param {Row['problem']} problem @param {number} most Of one student. */
export function problemText(text, problem, most) {
  const began = text ? ` “${text}”` : '';
  if (problem === 'none') return `no hand-in in it:${began || ' empty'}`;
  if (problem === 'long') return `too long for a hand-in${began}`;
  if (problem === 'more') return `of this file only its receipts were checked, at most the last ${most}`;
  if (problem === 'bytes')
    return 'no text but a document, a zip or a picture: unpack a zip, else ask for the text of the receipt';
  if (problem === 'heavy') return 'would take too long to compute';
  return problem === '' ? '' : `cannot be read: ${problem.said}`;
}

/** @param {number} all @param {number} met @param {number} unread @param {number} marked @param {number} milliseconds */
export const summary = (all, met, unread, marked, milliseconds) =>
  `${all} ${all === 1 ? 'hand-in' : 'hand-ins'} in ${(milliseconds / 1000).toFixed(1)} s: ${met} ${met === 1 ? 'meets' : 'meet'} the aim, ${unread} cannot be read, ${marked} more ${marked === 1 ? 'has' : 'have'} a remark.`;

/** @param {string} exercise @param {string} task */
export const judgedBy = (exercise, task) => `Judged by exercise ${exercise}${task ? `: ${task}` : ''}`;

/** @param {number} checked @param {number} all */
export const onlyFirst = (checked, all) =>
  `Only the first ${checked} of ${all} were checked: check the others by themselves.`;
/** @param {number} read @param {number} all */
export const cutText = (read, all) =>
  `Only the first ${read} of the ${all} characters that were pasted were read.`;

/** The marks in the pictures. @type {Readonly<Record<string, string>>} */
export const legend = {
  met: 'meets the aim',
  not: 'does not meet it',
  unjudged: 'not judged',
  aim: 'the aim',
  far: 'farther out, that way',
};

/** @param {string} cost */
export const costText = (cost) => `J = ${cost}`;
/** @param {string} met */
export const aimText = (met) => `aim ${met}`;
/** @param {number} points */
export const pointsText = (points) => `${points} ${points === 1 ? 'point' : 'points'}`;
/** @param {number} place @param {number} count */
export const placeText = (place, count) => `${place} of ${count}`;

export const noLink =
  'this address holds no exercise. Copy the whole link, with all that stands behind its #.';
export const nothing = 'There is nothing to check yet.';
export const cancelled = 'Cancelled.';
/** @param {string} reason */
export const failed = (reason) => `It could not be checked: ${reason}`;
/** @param {string} reason */
export const noExercise = (reason) => `The link of the exercise cannot be read: ${reason}`;
/** @param {number} files */
export const filesText = (files) => (files === 0 ? '' : files === 1 ? 'and one file' : `and ${files} files`);
/** @param {string} name */
export const pinned = (name) => `Pinned: ${name}, on the plane and in Curves.`;
/** @param {string} name */
export const unpinned = (name) => `No longer pinned: ${name}.`;
/** @param {string} name @param {number} most */
export const notPinned = (name, most) =>
  `Not pinned: ${name}. ${most} drives are pinned, and no more can be: take one away first, here or on the page.`;
/** @param {number} first @param {number} last @param {number} count */
export const rowsText = (first, last, count) => `${first} to ${last} of ${count}`;
export const csvHead = {
  points: 'Points',
  aim: 'Aim',
  drives: 'Drives',
  minutes: 'Minutes',
  how: 'Found by',
  answers: 'Answers',
  remarks: 'Remarks',
  link: 'Link',
  reached: 'Reached',
};
