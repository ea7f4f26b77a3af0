// Of the disturbance part, what is the same in every language.
/** @import { PartName, Place, Summary } from '../summary.js' */
import { sameDigits } from '../../../kit/steps.js';
import { fixed, powerText } from '../../../words/numbers.js';

export const parts = /** @type {const} */ (['x', 'y', 'theta']);
export const unitOf = /** @type {const} */ ({ x: 'm', y: 'm', theta: '' });

/** The rows of a kind, for the linear and the angular part. */
export const sizes = /** @type {const} */ ({
  random: [
    { id: 'epsilon1', name: 'ε1', letter: 'ε', index: '1' },
    { id: 'epsilon2', name: 'ε2', letter: 'ε', index: '2' },
  ],
  slip: [
    { id: 'delta1', name: 'δ1', letter: 'δ', index: '1' },
    { id: 'delta2', name: 'δ2', letter: 'δ', index: '2' },
  ],
});
export const units = /** @type {const} */ (['m/s', 'rad/s']);

/** What each part is, the subscripts being every second piece. */
export const formulas = /** @type {const} */ ({
  x: ['|x', 'e', ' cos θ', 'e', '|'],
  y: ['|y', 'e', '|'],
  theta: ['|sin θ', 'e', '|'],
});

/** @param {PartName} part */
export const formulaText = (part) => formulas[part].map((piece, i) => (i % 2 ? 'ₑ' : piece)).join('');

/** With three digits that count. @param {number} value */
export function sizeText(value) {
  if (!Number.isFinite(value)) return '∞';
  if (value === 0) return '0';
  if (value < 0.001 || value >= 1e5) return powerText(value);
  return value < 100 ? value.toPrecision(3) : fixed(value, 0);
}

/** @param {PartName} part @param {number} value */
export const amount = (part, value) => `${sizeText(value)}${unitOf[part] && ' '}${unitOf[part]}`;

/** Of seconds, below the plots. @param {readonly number[]} times */
export const timeTicks = (times) => sameDigits(times).map((text) => `${text} s`);

/** @param {number} count @param {number} starts */
export const shareText = (count, starts) => `${count}/${starts}`;

/** What stands before a number that is on the edge of its set, and before how many are. */
export const edgeMark = '≈';

/** Of the other starts, the largest of each so many seconds is drawn. */
export const crestSeconds = 0.2;

/** Where there is no set, or none that a push opens. */
export const none = '–';

/** The equations of the sets. */
export const equations = /** @type {const} */ ({ x: '(6)', y: '(7)', theta: '(8)' });

/** Whether Theorem 2 is about this drive. @param {Pick<Summary, 'law' | 'isPositive'>} summary */
export const isPromised = ({ law, isPositive }) => law === 'shim-kim' && isPositive;

/** Which sets the drive leaves, and to the edges of which it comes. @param {Pick<Summary, 'rows'>} summary */
export function farthestOf({ rows }) {
  const at = (/** @type {Place} */ place) => parts.filter((part) => rows[part].place === place);
  return { outside: at('outside'), edge: at('edge') };
}

/** Whether the drive or one of the others is on the edge of a set. @param {Summary} summary */
export const hasEdge = (summary) =>
  isPromised(summary) &&
  summary.pushed.some((part) => summary.rows[part].place === 'edge' || summary.rows[part].edge > 0);
