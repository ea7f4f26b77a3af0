// The equations of a mutation, as they are written, against the record of the core.
import assert from 'node:assert/strict';
import { detailsOf, ratesOf } from '../../../www/parts/generation/details.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { createEngine, Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { written } from '../harness/templates.js';
import { numbersIn } from './generation-page.js';

const usual = experiment('velocity-limits');

/** The numbers of each equation of an offspring. @param {number} adaptation @param {number} chosen */
function equationsOf(adaptation, chosen) {
  const evolution = new Evolution({ ...usual, evolution: { ...usual.evolution, adaptation } });
  evolution.step();
  const model = /** @type {any} */ ({ anatomy: dissect(evolution.record(1)), phase: 'mutation', chosen });
  const rates = ratesOf(createEngine().learningRates(), adaptation);
  const text = written(detailsOf(model, { rates, choose() {} }));
  return [...text.matchAll(/<p class="equation">(.*?)<\/p>/gs)].map(([, equation]) =>
    numbersIn(equation.replaceAll(/<[^>]*>/g, ' ')).map(Number),
  );
}

test('what is written of a mutation is true, however fast σ adapts', () => {
  for (const adaptation of [0, 0.5, 1])
    for (const chosen of [0, 3, 11]) {
      const equations = equationsOf(adaptation, chosen);
      assert.equal(equations.length, 6);
      for (const [i, numbers] of equations.entries()) {
        const [before, a, b, c, after] = numbers;
        const result = i % 2 === 0 ? before + a * b : before * Math.exp(a + b * c);
        const printed = i % 2 === 0 ? c : after;
        assert.ok(Math.abs(result - printed) < 0.005 * (1 + Math.abs(printed)), `${adaptation}: ${numbers}`);
      }
    }
});
