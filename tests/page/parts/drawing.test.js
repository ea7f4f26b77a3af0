// Numbers below the axes of parts, however large or small what is shown is.
import assert from 'node:assert/strict';
import { scaleLinear } from 'd3-scale';
import { numbersApart } from '../../../www/parts/drawing.js';
import { timeTicks } from '../../../www/parts/disturbance/words/common.js';
import { medianGain, ticks } from '../../../www/parts/luck/words/common.js';
import { test } from '../harness/once.js';

/** About as wide as letters are. @param {string} text */
const widthOf = (text) => 8 * text.length;

test('numbers below an axis stand apart at any length of it, and are as many as there is room for', () => {
  for (const write of [ticks, timeTicks])
    for (const width of [60, 250, 900])
      for (let power = -6; power <= 6; power += 1) {
        const scale = scaleLinear([-(10 ** power), 10 ** power], [0, width]);
        const numbers = numbersApart(scale, 7, write, widthOf);
        assert.ok(numbers.length > 0);
        for (const [i, { tick, text }] of numbers.entries()) {
          if (i === 0) continue;
          const before = numbers[i - 1];
          const apart = scale(tick) - scale(before.tick);
          assert.ok(
            apart > Math.max(widthOf(text), widthOf(before.text)),
            `${power}, ${width}: ${before.text}|${text}`,
          );
        }
      }
  const usual = numbersApart(scaleLinear([0, 12], [0, 500]), 7, ticks, widthOf);
  assert.deepEqual(
    usual.map(({ text }) => text),
    ['0', '2', '4', '6', '8', '10', '12'],
  );
});

test('large gains are short, and small ones as they were', () => {
  assert.deepEqual(ticks([-1e6, 0, 1e6]), ['−1M', '0', '1M']);
  assert.deepEqual(ticks([-0.5, 0, 0.5, 1]), ['−0.5', '0', '0.5', '1']);
  assert.deepEqual([8.61749, -999.5, 539611.956].map(medianGain), ['8.617', '−999.500', '539612']);
  assert.deepEqual(timeTicks([0, 2, 4]), ['0 s', '2 s', '4 s']);
});
