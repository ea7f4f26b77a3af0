// Every word of handing in.
/** @import { Wanted } from '../../../run/aim.js' */
/** @import { Thing } from '../own.js' */
import { counted } from '../../../words/en/counted.js';
import { costBeside, costLine, gainsLine, head } from './common.js';

export * from './common.js';

export const texts = {
  handIn: 'Hand in',
  title: 'Hand in',
  close: 'Close',
  whoLabel: 'Your name or number',
  whoHelp: 'It is asked once. From then on it stands in the address and in what you copy or save here.',
  whoDrawn: 'The exercise was drawn for this name: for another, open the link that your lecturer gave.',
  begin: 'Begin',
  whoFirst:
    'Everyone has a slightly different exercise: say who you are, and yours is drawn. What runs until then is not kept.',
  make: 'Make the receipt',
  help: 'Give this to your lecturer as you were told: paste the text, or send the link or the file. Nothing is sent by this page.',
  helpWithin:
    'If no learning platform here says that it has your result, give this to your lecturer: paste the text, or send the link or the file.',
  proves:
    'Whoever opens it sees the robot drive and J computed again, to the last digit. It proves the result, not whose it is.',
  text: 'The receipt',
  link: 'Link of the receipt',
  copyText: 'Copy the text',
  copyLink: 'Copy the link',
  save: 'Save as a file',
  computing: 'Computing …',
  made: 'The receipt is made.',
  counts: 'What counts is the exercise as it was given.',
  away: 'What is tried in Park is not handed in.',
  toLab: 'To the lab',
  backToExercise: 'Back to the exercise as given',
};

export const copied = 'Copied.';
export const notCopied = 'This browser lets no page copy: it is selected, copy it with the keyboard.';

/** @param {string} reason */
export const failed = (reason) => `The receipt could not be made: ${reason}`;

/** @param {Wanted} wanted */
export const wantedText = (wanted) =>
  wanted.kind === 'cost'
    ? `J below ${wanted.below}`
    : wanted.kind === 'parks'
      ? `parks from ${wanted.least} of ${wanted.of} starts`
      : `parks from ${Math.round(1000 * wanted.share) / 10} % of 1000 starts that nobody has evolved on`;

/** @param {number | null} drives */
export const budgetText = (drives) =>
  drives === null ? '' : `, within ${counted(drives, 'drive', 'drives')}`;

/** @param {Wanted} wanted @param {number} value */
export const valueText = (wanted, value) =>
  wanted.kind === 'cost'
    ? `J ${costBeside(value, wanted.below)}`
    : wanted.kind === 'parks'
      ? `${value} of ${wanted.of}`
      : `${Math.round(1000 * value) / 10} %`;

/** @type {Readonly<Record<Thing, string>>} */
const things = {
  starts: 'start',
  goal: 'goal',
  referenceVelocity: 'reference',
  limits: 'limits',
  tolerance: 'tolerance',
  weights: 'weights of J',
  law: 'control law',
  sampleTime: 'sample time',
  horizon: 'horizon',
  disturbance: 'disturbance',
  seed: 'seed',
  evolution: 'evolution',
  drives: 'what drives',
  gains: 'gains',
  generation: 'generation',
};

/** @param {readonly Thing[]} apart */
const listed = (apart) => apart.map((thing) => things[thing]).join(', ');

/** @param {readonly Thing[]} apart */
export const apartText = (apart) => `Changed here: ${listed(apart)}.`;

/** @param {boolean} isMet @param {boolean} isWithin Whether there are no more drives than the aim allows. */
export const metText = (isMet, isWithin) =>
  isMet ? 'met' : isWithin ? 'not yet met' : 'not met, too many drives';

/** @param {boolean} isMet */
export const metWord = (isMet) => (isMet ? 'met' : 'not met');

/** @param {number} drives @param {number} most */
export const drivesText = (drives, most) => `${drives} of ${most} drives`;

/** @param {number} points @param {number} most */
export const pointsText = (points, most) => `${points} of ${most} points`;

/** The text of a receipt. @param {import('../receipt.js').Receipt} receipt */
export function receiptText(receipt, address = receipt.link) {
  const { who, program, exercise, cost, parked, starts, drives, minutes, answers } = receipt;
  const { apart, there, wanted, judged, gains, how } = receipt;
  const found =
    how.driver === 'evolved'
      ? `, found by ${how.method === 'ep' ? 'EP' : how.method} with seed ${how.seed} in generation ${how.generation}`
      : how.driver === 'hand'
        ? ', by hand'
        : ', from the paper';
  const reached = wanted && wanted.kind !== 'cost' ? `: ${valueText(wanted, there.value)}` : '';
  return [
    head(program, exercise),
    `Name: ${who}`,
    `${costLine(cost)}, parks from ${parked} of ${starts} ${starts === 1 ? 'start' : 'starts'}`,
    ...(judged
      ? [
          `Aim ${metWord(judged.isMet)}${reached}${judged.points === null ? '' : `, ${judged.points} of ${judged.most} points`}`,
        ]
      : []),
    ...(apart.length > 0
      ? [`In the exercise as it was given (changed here: ${listed(apart)}): ${costLine(there.cost)}`]
      : []),
    `${gainsLine(gains)}${found}`,
    `${counted(drives, 'drive', 'drives')} in ${minutes} min`,
    ...(answers ? [`Answers: ${answers}`] : []),
    address,
  ].join('\n');
}

/** @param {string} who @param {number} cost */
export const held = (who, cost) =>
  `Handed in by ${who || 'somebody'}: J = ${cost}. It holds: computed again here, to the last digit.`;

/** @param {number} told @param {number} found */
export const heldNot = (told, found) =>
  `This receipt does not hold: it says J = ${told}, but its drive has J = ${found}.`;

export const broken = 'This receipt was cut or changed on its way: ask for it again.';

/** @param {string} program @param {string} own */
export const otherProgram = (program, own) =>
  `It was made by version ${program} of the program, this is ${own}.`;
