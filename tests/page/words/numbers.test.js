import assert from 'node:assert/strict';
import { test } from '../harness/once.js';
import * as numbers from '../../../www/words/numbers.js';

test('every number is written as one, also what is none', () => {
  const { fixed, threeDigits, sixDigits, powerText, costText, signed } = numbers;
  const ways = [
    (/** @type {number} */ value) => fixed(value, 2),
    threeDigits,
    sixDigits,
    powerText,
    costText,
    (/** @type {number} */ value) => signed(value, 2),
  ];
  for (const value of [0, -0, 1e-300, 0.1, -7.25, 12345.678, -1e15, 1e21, -1e308, Infinity, -Infinity, NaN])
    for (const write of ways) {
      const text = write(value);
      assert.match(text, /^(?:−?\d+(?:\.\d+)?(?:×10⁻?[⁰¹²³⁴⁵⁶⁷⁸⁹]+)?|−?∞)$/, `${value}: ${text}`);
      assert.equal(text.includes('∞'), !Number.isFinite(value), `${value}: ${text}`);
    }
});
