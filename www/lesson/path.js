// The path of the lesson: the names of its steps in their order, each with the link of what is on screen when it is opened.
// What the steps hold is loaded when the lesson is.
import { language, usualLanguage } from '../words/language.js';

/** @typedef {keyof typeof path} StepName */

export const path = Object.freeze({
  drive: 'lab&drives=hand&gains=3,0,0',
  error: 'lab&drives=hand&gains=3,5,5&start=1,0,90deg',
  law: 'lab&drives=hand&gains=3,0,0&start=1.5,0.5,0',
  stability: 'curves&view=stability&drives=hand&gains=3,1,5&limits.speed=off&limits.turnRate=off',
  limits: 'curves&drives=paper-ep',
  cost: 'lab&drives=hand&gains=3,1,5',
  generation: 'generation&generation=1&phase=parents&individual=26',
  sigma: 'lab&generation=60&curve=sigmas',
  duel: 'lab&drives=hand&gains=1,1,1',
  landscape: 'landscape&third=0.05',
  task: 'lab&generation=100',
  disturbance: 'disturbance&drives=paper-ep&under=slip,0.1,0,1',
  paper: 'curves&drives=paper-ep',
  lecturers: 'lab',
});

export const stepNames = /** @type {readonly StepName[]} */ (Object.keys(path));

/** The link with the step of the lesson in it. @param {string} link @param {number} number @returns {string} */
export function hrefOf(link, number) {
  const step = /^lesson&step=(\d+)$/.exec(link);
  if (step) return `#${linkOfStep(Number(step[1]))}`;
  const [part, ...pairs] = link.split('&');
  const read = language === usualLanguage ? [] : [`lang=${language}`];
  return `#${[part, 'v=1', ...read, ...pairs, `lesson=${number}`].join('&')}`;
}

/** The same from the number of a step alone. @param {number} number */
export const linkOfStep = (number) => hrefOf(path[stepNames[number - 1]], number).slice(1);
