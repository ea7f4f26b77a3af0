// Every word of an exercise: what students see of it, and the panel in which it is made.

export const texts = {
  exercise: 'Exercise',
  taskLabel: 'Task from this link',
  leaveExercise: 'Open the whole page',
  handles: 'Start and goal',
  keepExerciseTitle: 'Exercise',
  keepExerciseHelp:
    'Gives students this run with a task of yours; what would distract or tell too much is locked or hidden.',
  keepExercise: 'Make an exercise',
  makerTitle: 'Make an exercise',
  makerHelp:
    'The page shows at once what your students will see. Nothing is secret: they can open the whole page.',
  makerTask: 'Your task',
  makerLink: 'Link to the exercise',
  makerCopyLink: 'Copy link',
  makerFrame: 'Frame for another page',
  makerCopyFrame: 'Copy frame',
  makerClose: 'Close the exercise',
};

/** What is locked or hidden together. @type {Record<import('../common/kinds.js').Group, string>} */
export const groups = {
  gains: 'gains',
  drives: 'what drives',
  paper: 'paper’s gains',
  postures: 'start and goal',
  run: 'running evolution',
  seed: 'new seed',
  clock: 'clock of the robots',
  settings: 'settings and limits',
  parts: 'other parts',
  lesson: 'the lesson',
  share: 'sharing',
};

/** @type {readonly import('../../kit/segmented.js').Choice<import('../common/kinds.js').Way>[]} */
export const ways = [
  { value: 'free', text: 'Free' },
  { value: 'locked', text: 'Locked' },
  { value: 'hidden', text: 'Hidden' },
];

/** @param {readonly string[]} locked @param {readonly string[]} hidden */
export const locksText = (locked, hidden) =>
  [
    locked.length > 0 ? `Locked by this link: ${locked.join(', ')}.` : '',
    hidden.length > 0 ? `Hidden by this link: ${hidden.join(', ')}.` : '',
  ]
    .filter((text) => text !== '')
    .join(' ');

/** @param {number} count @param {number} most */
export const countText = (count, most) => `${count} of at most ${most} characters`;
