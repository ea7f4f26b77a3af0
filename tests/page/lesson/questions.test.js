// The questions of the lesson, as one who has not understood would guess them.
import assert from 'node:assert/strict';
import { steps } from '../../../www/lesson/steps.js';
import { test } from '../harness/once.js';
import { en as english, ko as korean } from '../harness/words.js';
import { answered } from './live.js';

/** @type {any} */
const en = english.lesson;
/** @type {any} */
const ko = korean.lesson;

test('the right choice stands anywhere: no place has more than four in ten', async () => {
  /** @type {number[]} */
  const places = [];
  for (const { name, blocks } of steps)
    for (const block of blocks) {
      // Who wins a contest depends on who plays.
      if (block.kind !== 'quiz' || name === 'duel') continue;
      const count = en.steps[name].quizzes[block.name].choices.length;
      const order = block.quiz.order ?? Array.from({ length: count }, (_, i) => i);
      assert.deepEqual(
        [...order].sort(),
        Array.from({ length: count }, (_, i) => i),
        `${name}.${block.name}`,
      );
      const { outcome } = await answered(name, block.name);
      places.push(order.indexOf(outcome.right));
    }
  const share = (/** @type {number} */ place) => places.filter((one) => one === place).length / places.length;
  assert.ok(Math.max(share(0), share(1), share(2)) <= 0.4, `${places}`);
  assert.ok(Math.min(share(0), share(1), share(2)) >= 0.2, `${places}`);
});

test('no choice of a question stands out by its form: all of them give a reason, or none', () => {
  for (const words of [en, ko])
    for (const { name, blocks } of steps)
      for (const block of blocks) {
        if (block.kind !== 'quiz') continue;
        /** @type {string[]} */
        const choices = words.steps[name].quizzes[block.name].choices;
        const reasons = choices.filter((choice) => /[:.] /.test(choice)).length;
        assert.ok(reasons === 0 || reasons === choices.length, `${name}.${block.name}: ${choices}`);
      }
});
