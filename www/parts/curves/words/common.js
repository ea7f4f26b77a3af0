// Of the curves, what is the same in every language.
/** @import { Run } from '../../../core/engine.js' */
import { costText, fixed, powerText, threeDigits } from '../../../words/numbers.js';

export const symbols = /** @type {const} */ ({
  position: ['x', 'y'],
  theta: ['θ'],
  linear: ['v'],
  angular: ['ω'],
});
export const units = /** @type {const} */ ({ position: 'm', theta: '', linear: 'm/s', angular: 'rad/s' });

/** @param {string} name @param {string} number */
export const tickText = (name, number) => `${number}${name === 'theta' ? '°' : ''}`;

/** @param {string} number */
export const seconds = (number) => `${number} s`;

/** With the digits of the step from one row to the next. @param {number} seconds @param {number} step */
export const timeText = (seconds, step) =>
  fixed(seconds, Math.max(2, String(Number(step.toPrecision(6))).split('.')[1]?.length ?? 0));

/** A number that keeps its width as long as it can. @param {number} value @param {number} digits */
const steady = (value, digits) => (Math.abs(value) < 1e5 ? fixed(value, digits) : powerText(value, 2));

/** What is read at the cursor. @type {readonly { id: string, symbol: string, className: string, unit: string, text: (run: Run, i: number, paid: number) => string }[]} */
export const readings = [
  { id: 'x', symbol: 'x', className: 'x', unit: ' m', text: (run, i) => steady(run.x[i], 2) },
  { id: 'y', symbol: 'y', className: 'y', unit: ' m', text: (run, i) => steady(run.y[i], 2) },
  {
    id: 'theta',
    symbol: 'θ',
    className: 'theta',
    unit: '°',
    text: (run, i) => steady((run.theta[i] * 180) / Math.PI, 1),
  },
  {
    id: 'linear',
    symbol: 'v',
    className: 'linear',
    unit: ' m/s',
    text: (run, i) => steady(run.linear[i], 2),
  },
  {
    id: 'angular',
    symbol: 'ω',
    className: 'angular',
    unit: ' rad/s',
    text: (run, i) => steady(run.angular[i], 2),
  },
  { id: 'cost', symbol: 'J', className: 'cost-symbol', unit: '', text: (_, __, paid) => costText(paid) },
];

/** The columns of a run in numbers, with the heads that are words. @param {Record<'command-linear' | 'command-angular' | 'paid', string>} heads @returns {readonly { id: string, head: string, text: (run: Run, i: number, paid: number, step: number) => string }[]} */
export const numberColumnsOf = (heads) => [
  { id: 'time', head: 't s', text: (run, i, _, step) => timeText(run.time[i], step) },
  { id: 'x', head: 'x m', text: (run, i) => steady(run.x[i], 3) },
  { id: 'y', head: 'y m', text: (run, i) => steady(run.y[i], 3) },
  { id: 'theta', head: 'θ °', text: (run, i) => steady((run.theta[i] * 180) / Math.PI, 1) },
  { id: 'linear', head: 'v m/s', text: (run, i) => steady(run.linear[i], 2) },
  {
    id: 'command-linear',
    head: heads['command-linear'],
    text: (run, i) => steady(run.commandLinear[i], 2),
  },
  { id: 'angular', head: 'ω rad/s', text: (run, i) => steady(run.angular[i], 2) },
  {
    id: 'command-angular',
    head: heads['command-angular'],
    text: (run, i) => steady(run.commandAngular[i], 2),
  },
  { id: 'paid', head: heads.paid, text: (_, __, paid) => costText(paid) },
];

/** @param {number} value */
export const gainText = (value) => threeDigits(value);
