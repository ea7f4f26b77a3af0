// Python with the wheel, asked from here.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { python } from '../../../.tasks/examples.mjs';

/** @typedef {{ expression: string, given?: unknown }} Question */
/** @typedef {{ value?: any, error?: string, message?: string }} Answer */

const program = fileURLToPath(new URL('computing.py', import.meta.url));

/** What Python answers to each, all in one process. @param {readonly Question[]} questions @returns {Answer[]} */
export function askPython(questions) {
  const input = questions
    .map(({ expression, given = null }) => `${JSON.stringify({ expression, given })}\n`)
    .join('');
  const output = execFileSync(python, ['-B', program], { input, encoding: 'utf8', maxBuffer: 1 << 28 });
  const answers = output
    .trimEnd()
    .split('\n')
    .map((line) => JSON.parse(line, revived));
  assert.equal(answers.length, questions.length);
  return answers;
}

/** The values of what Python answers without an error. @param {readonly Question[]} questions @returns {any[]} */
export const valuesFrom = (questions) =>
  askPython(questions).map(({ value, message }, i) => {
    assert.equal(message, undefined, questions[i].expression);
    return value;
  });

/** @param {string} _ @param {any} value */
function revived(_, value) {
  const infinite = value?.float;
  if (typeof infinite !== 'string') return value;
  return Number(infinite.replace('inf', 'Infinity'));
}

/** A value of the core as Python has it: columns are lists, flags truths. @param {any} value @returns {any} */
export function asPython(value) {
  if (value instanceof Uint8Array) return [...value].map(Boolean);
  if (value instanceof Float64Array) return [...value];
  if (Array.isArray(value)) return value.map(asPython);
  if (value === null || typeof value !== 'object') return value;
  return Object.fromEntries(Object.entries(value).map(([name, field]) => [name, asPython(field)]));
}
