// Every word of an exercise that students see.

export const texts = {
  exercise: 'Exercise',
  taskLabel: 'Task from this link',
  leaveExercise: 'Open the whole page',
  handles: 'Start and goal',
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

/** @param {readonly string[]} locked @param {readonly string[]} hidden */
export const locksText = (locked, hidden) =>
  [
    locked.length > 0 ? `Locked by this link: ${locked.join(', ')}.` : '',
    hidden.length > 0 ? `Hidden by this link: ${hidden.join(', ')}.` : '',
  ]
    .filter((text) => text !== '')
    .join(' ');
