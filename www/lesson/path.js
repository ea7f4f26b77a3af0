// The path of the lesson: the names of its steps in their order, each with the link of what is on screen when it is opened.
// What the steps hold is loaded when the lesson is.
import { language, usualLanguage } from '../words/language.js';

/** @typedef {keyof typeof path} StepName */

export const path = Object.freeze({
  drive: 'lab&drives=hand&gains=1,4,1',
  error: 'lab&drives=hand&gains=3,5,5&start=1,0,90deg',
  law: 'lab&drives=hand&gains=3,0,0&start=1.5,0.5,0',
  stability: 'curves&view=stability&drives=hand&gains=3,1,5&limits.speed=off&limits.turnRate=off',
  limits: 'curves&drives=paper-ep',
  cost: 'lab&drives=hand&gains=3,1,5',
  generation: 'generation&generation=1&phase=parents&individual=26',
  sigma: 'lab&generation=60&curve=sigmas',
  duel: 'lab&drives=hand&gains=1,1,1&weights.velocity=1,0.1',
  landscape: 'landscape&third=0.05',
  contest: 'luck&luck=contest&contestants=truncation&seeds=51&budget=4000&target=7.72',
  task: 'lab&generation=100',
  disturbance: 'disturbance&drives=paper-ep&under=slip,0.1,0,1',
  paper: 'curves&drives=paper-ep',
  build: 'generation&generation=1&phase=parents&individual=26',
  lecturers: 'lab',
});

export const stepNames = /** @type {readonly StepName[]} */ (Object.keys(path));

/** What students go through; the place for lecturers lies beside it. */
export const pathLength = stepNames.indexOf('build') + 1;

/** Links of the first edition know the steps by these numbers, and so do those of today as far as they are the same. @type {readonly StepName[]} */
const numbered = [
  ...stepNames.slice(0, stepNames.indexOf('contest')),
  ...stepNames.slice(stepNames.indexOf('contest') + 1, pathLength - 1),
  'lecturers',
];

/** How links name a step. @param {number} number */
export const textOfStep = (number) => {
  const name = stepNames[number - 1];
  return numbered[number - 1] === name ? String(number) : name;
};

/** The step that a link names; where there is none of that name or number, the nearest. @param {string} text @returns {{ number: number, isThere: boolean }} */
export function stepNamed(text) {
  const number = Number(text);
  const name = numbered[number - 1] ?? stepNames.find((one) => one === text);
  if (name) return { number: stepNames.indexOf(name) + 1, isThere: true };
  if (number === pathLength) return { number, isThere: true };
  if (number === 0) return { number: 0, isThere: true };
  return { number: number > numbered.length ? pathLength : 1, isThere: false };
}

/** The link with the step of the lesson in it; with 0, by itself. @param {string} link @param {number} number @returns {string} */
export function hrefOf(link, number) {
  const step = /^lesson&step=(\w+)$/.exec(link);
  if (step) return `#${linkOfStep(stepNamed(step[1]).number)}`;
  const [part, ...pairs] = link.split('&');
  const read = language === usualLanguage ? [] : [`lang=${language}`];
  const beside = number === 0 ? [] : [`lesson=${textOfStep(number)}`];
  return `#${[part, 'v=1', ...read, ...pairs, ...beside].join('&')}`;
}

/** The same from the number of a step alone. @param {number} number */
export const linkOfStep = (number) => hrefOf(path[stepNames[number - 1]], number).slice(1);
