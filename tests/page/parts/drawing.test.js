// Numbers below the axes of parts, however large or small what is shown is.
import assert from 'node:assert/strict';
import { scaleLinear } from 'd3-scale';
import { endOf, timeTicks as curveTicks } from '../../../www/parts/curves/axes.js';
import { seconds } from '../../../www/parts/curves/words/common.js';
import { rangeOf } from '../../../www/parts/luck/curve.js';
import { besideEnd } from '../../../www/parts/luck/curve-names.js';
import { sameDigits } from '../../../www/kit/steps.js';
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

test('a drive of any length fills its axis, whose numbers stand apart', () => {
  for (const last of [1e-5, 0.001, 0.0073, 0.01, 0.5, 4.2, 10, 1000]) {
    const end = endOf({ time: Float64Array.of(0, last) }, []);
    assert.ok(end >= last * (1 - 1e-9) && end < 1.3 * last, `${last} on an axis to ${end}`);
    for (const width of [150, 300, 900]) {
      const time = scaleLinear([0, end], [0, width]);
      const ticks = curveTicks(time);
      const widest = Math.max(...sameDigits(ticks).map((text) => 7.5 * seconds(text).length));
      assert.ok(
        ticks.length < 3 || time(ticks[1]) - time(ticks[0]) > widest,
        `${last} s in ${width}: ${ticks}`,
      );
    }
  }
  assert.equal(endOf({ time: Float64Array.of(0) }, []), 0.01);
});

test('where every J is 0 the axis of the seeds has numbers, and what will stand there is not on the curve of the lab', () => {
  const model = {
    survey: null,
    log: false,
    generations: 5,
    lab: { name: '', costs: [0, 0] },
    seed: null,
    index: -1,
    theme: 0,
  };
  const [low, high] = rangeOf(model);
  assert.ok(low < 0 && high > 0);
  const frame = { top: 20, bottom: 220 };
  for (const end of [30, 70, 119, 121, 210]) {
    const middle = frame.top + 200 * besideEnd(end, frame);
    assert.ok(Math.abs(middle - end) > 10, `${end}`);
  }
  assert.notEqual(besideEnd(70, frame), 0.2);
});
