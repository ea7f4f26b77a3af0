// Every word that the steps of the lesson share, and the steps.
import { costText, fixed } from '../../words/en/numbers.js';

export * as steps from './en/all.js';

export const stepLabel = 'Step of the lesson';
/** @param {number} number @param {number} count */
export const stepOf = (number, count) => `Step ${number} of ${count}`;
/** @param {string} title */
export const nextStep = (title) => `Next: ${title}`;
/** @param {string} title */
export const previousStep = (title) => `Back: ${title}`;
/** What of the figure stays in sight on a telephone. */
export const sights = 'In sight while you read';
export const sightOfStage = 'Picture';
export const sightOfRobot = 'Robot';
export const notice = 'Things to notice';
export const tries = 'Things to try';
export const showNumbers = 'with the current numbers';
export const hideNumbers = 'without the numbers';
export const formula = 'Formula';
export const right = 'correct';
export const yours = 'your prediction';
export const asPredicted = 'Right.';
export const otherwise = 'Not quite.';
export const computing = 'Driving …';
export const watching = 'Watch the drive: the answer comes when it has ended.';
export const besidePath = 'Beside the path';
/** @param {string} title */
export const toPath = (title) => `To the lesson: ${title}`;
/** After the last step. */
export const pathEnds =
  'That was the path. From here: the open task above, [Park them all](park) once more, and beside the path a page [for lecturers](lesson&step=lecturers).';
export const stage = 'What this step is about';

/** @type {Record<import('./common.js').Mark['name'], string>} */
const markNames = {
  fives: '5, 5, 5',
  arbitrary: 'the paper’s arbitrary gains',
  ep: 'the paper’s evolved gains',
};
/** What one has beaten by hand, said aloud. @param {readonly import('./common.js').Mark[]} marks */
export const beaten = (marks) =>
  marks.length === 0
    ? ''
    : `Your lowest J is below that of ${marks.map(({ name, cost }) => `${markNames[name]} (${costText(cost)})`).join(', ')}.`;

/** @param {readonly number[]} gains */
const gainsText = (gains) => gains.map((gain) => fixed(gain, gain < 10 ? 2 : 0)).join(', ');
export const swarm = {
  /** @param {string} name @param {number} parked @param {number} starts */
  label: (name, parked, starts) =>
    `${name}: robots drive from ${starts} starts around one goal. In the end ${parked} of them ${parked === 1 ? 'has' : 'have'} parked.`,
  parked: 'parked',
  /** @param {number} starts */
  ofStarts: (starts) => `of ${starts}`,
  mean: 'mean J',
  tooLong: 'With these settings the drives are too long to watch 32 at once.',
  again: 'Drive again',
  own: gainsText,
  /** @param {readonly number[]} gains */
  evolution: (gains) => `evolution: ${gainsText(gains)}`,
};
export const askAgain = 'Ask me again';
export const lapsed = 'Something was changed before the answer was there. Predict again.';
export const saidElsewhere = 'It was explained in the other language. To read it here, press “Ask me again”.';
export const otherWeights = 'The other weights';
