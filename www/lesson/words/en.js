// Every word that the steps of the lesson share, and the steps.
import { drive } from './en/drive.js';
import { error } from './en/error.js';
import { law } from './en/law.js';
import { stability } from './en/stability.js';
import { limits } from './en/limits.js';
import { cost } from './en/cost.js';
import { generation } from './en/generation.js';
import { sigma } from './en/sigma.js';
import { duel } from './en/duel.js';
import { landscape } from './en/landscape.js';
import { task } from './en/task.js';
import { disturbance } from './en/disturbance.js';
import { paper } from './en/paper.js';
import { lecturers } from './en/lecturers.js';

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
