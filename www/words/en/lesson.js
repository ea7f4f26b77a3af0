// Every word of the lesson that its steps share, and the steps.
import { drive } from './lesson/drive.js';
import { error } from './lesson/error.js';
import { law } from './lesson/law.js';
import { stability } from './lesson/stability.js';
import { limits } from './lesson/limits.js';
import { cost } from './lesson/cost.js';
import { generation } from './lesson/generation.js';
import { sigma } from './lesson/sigma.js';
import { duel } from './lesson/duel.js';
import { landscape } from './lesson/landscape.js';
import { task } from './lesson/task.js';
import { disturbance } from './lesson/disturbance.js';
import { paper } from './lesson/paper.js';
import { lecturers } from './lesson/lecturers.js';

export const texts = { lesson: 'Lesson' };

export const nav = 'Lesson';
export const tagline = 'Predict, try, see, explain: the method step by step, with the lab’s own views.';
export const stepLabel = 'Step of the lesson';
/** @param {number} number @param {number} count */
export const stepOf = (number, count) => `Step ${number} of ${count}`;
/** @param {string} title */
export const nextStep = (title) => `Next: ${title}`;
/** @param {string} title */
export const previousStep = (title) => `Back: ${title}`;
/** What of the figure stays in sight on a telephone. */
export const sights = 'In sight while you read';
export const sightOfRobot = 'Robot';
export const notice = 'Things to notice';
export const tries = 'Things to try';
export const showNumbers = 'with the numbers of now';
export const hideNumbers = 'without the numbers';
export const formula = 'Formula';
export const right = 'so it is';
export const wrong = 'your prediction';
export const asPredicted = 'As you said.';
export const otherwise = 'It is otherwise.';
export const computing = 'Driving …';
export const askAgain = 'Ask me again';

export const steps = {
  drive,
  error,
  law,
  stability,
  limits,
  cost,
  generation,
  sigma,
  duel,
  landscape,
  task,
  disturbance,
  paper,
  lecturers,
};
