// For lecturers. A demonstration, a lab sheet, questions for an exam; every claim is held by a test of its link.
import { sheet } from '../sheet.js';

/** @import { Written } from '../steps.js' */

export const demonstration = sheet('demonstration', [
  ['park', 'lab&drives=hand&gains=3,0,0'],
  ['random', 'lab'],
  ['run', 'lab&generation=50'],
  ['open', 'generation&generation=1&phase=tournament'],
  ['steps', 'lab&generation=300&curve=sigmas'],
  ['landscape', 'landscape&generation=30'],
  ['elsewhere', 'robustness&generation=100'],
  ['training', 'training'],
  ['close', 'disturbance'],
]);

const plan = sheet('plan', [
  ['play', 'lesson&step=drive'],
  ['model', 'lesson&step=error'],
  ['theory', 'lesson&step=stability'],
  ['limits', 'lesson&step=limits'],
  ['cost', 'lesson&step=cost'],
  ['evolution', 'lesson&step=generation'],
  ['contest', 'lesson&step=duel'],
  ['task', 'lesson&step=task'],
  ['end', 'lesson&step=build'],
]);

/** @type {Parameters<typeof sheet>[1]} */
const labItems = [
  ['beside', 'lab&drives=hand&gains=3,0,5&start=1,3,45deg'],
  ['works', 'lab&weights.velocity=4,1&generation=150'],
  ['seeds', 'lab&seed=2&generation=100'],
  ['population', 'lab&population=6&generation=150'],
  ['kanayama', 'lab&law=kanayama&generation=50'],
  ['acceleration', 'curves&preset=acceleration-limits&drives=hand&gains=10,10,10'],
  ['unseen', 'training&generation=100'],
];

export const lab = sheet('lab', labItems, 'tasks');

/** @type {Parameters<typeof sheet>[1]} */
const examItems = [
  ['negative', null],
  ['best', null],
  ['old', null],
  ['collapse', null],
  ['ky', null],
  ['compare', null],
];

export const exam = sheet('exam', examItems, 'tasks');

/** @type {Written} */
export const lecturers = {
  figure: 'driver',
  blocks: [
    { kind: 'text', name: 'begin' },
    demonstration,
    plan,
    lab,
    exam,
    sheet('lab', labItems, 'answers'),
    sheet('exam', examItems, 'answers'),
    { kind: 'text', name: 'cite' },
  ],
  values: ({ engine }) => ({ version: engine.version() }),
};
