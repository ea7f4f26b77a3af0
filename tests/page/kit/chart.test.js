// Where the lines of a chart go: of many samples, only those that are seen.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { scaleLinear } from 'd3-scale';
import { levelsOn, pointsOf, ticksOn } from '../../../www/kit/chart.js';
import { extentOf, largest, outlineOf } from '../../../www/kit/extent.js';
import { labelHeight, spread, standingFree } from '../../../www/kit/names.js';
import { sameDigits } from '../../../www/kit/steps.js';
import { test } from '../harness/once.js';

const frame = { left: 40, right: 140, top: 10, bottom: 210 };

/** Axes that show all of a curve. @param {readonly number[]} values */
const axesOf = (values) => ({
  frame,
  x: scaleLinear([0, values.length - 1], [frame.left, frame.right]),
  y: scaleLinear([-1, 1], [frame.bottom, frame.top]),
});

/** A curve of many samples, which trembles. @param {number} count @param {readonly number[]} some */
const tremblingOf = (count, some) =>
  Array.from({ length: count }, (_, i) => 0.8 * Math.sin(i / 700) + 0.2 * some[(i * 7) % some.length]);

/** The least and the greatest height within each pixel from the left. @param {readonly (readonly [number, number])[]} points */
function reachOf(points) {
  /** @type {Map<number, [number, number]>} */
  const reach = new Map();
  for (const [px, py] of points) {
    const [low, high] = reach.get(Math.floor(px)) ?? [py, py];
    reach.set(Math.floor(px), [Math.min(low, py), Math.max(high, py)]);
  }
  return reach;
}

const amplitudes = fc.array(fc.double({ min: -1, max: 1, noNaN: true }), { minLength: 5, maxLength: 40 });

test('of many samples the points reach as high and as low as all do, and are few', () => {
  fc.assert(
    fc.property(fc.integer({ min: 401, max: 30_000 }), amplitudes, fc.boolean(), (count, some, isTyped) => {
      const values = tremblingOf(count, some);
      const { x, y } = axesOf(values);
      const points = pointsOf(
        axesOf(values),
        values.map((_, i) => i),
        // Of a column of the core an outline is kept.
        isTyped ? Float64Array.from(values) : values,
      );
      const all = values.map((value, i) => /** @type {const} */ ([x(i), y(value)]));
      const places = new Set(all.map(String));
      assert.ok(
        points.every((point) => places.has(String(point))),
        'every point is a sample',
      );
      const seen = reachOf(points);
      for (const [px, [low, high]] of reachOf(all)) {
        // What lies less than half a pixel from a point that is drawn is left out, also over the edge of its pixel.
        const near = [px - 1, px, px + 1].flatMap((one) => seen.get(one) ?? []);
        assert.ok(Math.min(...near) <= low + 0.5, `pixel ${px} of ${count}`);
        assert.ok(Math.max(...near) >= high - 0.5, `pixel ${px} of ${count}`);
      }
      assert.ok(points.length <= 8 * (frame.right - frame.left) + 2, `${points.length} of ${count}`);
      const last = values.length - 1;
      assert.deepEqual(points[0], [x(0), y(values[0])]);
      assert.deepEqual(points.at(-1), [x(last), y(values[last])]);
    }),
    { numRuns: 60 },
  );
});

test('names that would lie on each other are moved apart, as little as it takes, and the others stay', () => {
  const heights = fc.array(fc.double({ min: -50, max: 250, noNaN: true }), { minLength: 1, maxLength: 8 });
  fc.assert(
    fc.property(heights, (wanted) => {
      const places = wanted.map((y) => ({ y, was: y }));
      spread(places, 0, 200);
      const sorted = [...places].sort((a, b) => a.y - b.y);
      for (const [i, { y }] of sorted.entries()) {
        assert.ok(y >= -1e-9 && y <= 200 + 1e-9, `${y}`);
        if (i > 0) assert.ok(y - sorted[i - 1].y >= labelHeight - 1e-9);
      }
      assert.ok(sorted.every(({ was }, i) => i === 0 || was >= sorted[i - 1].was));
    }),
  );
  const places = [{ y: 8 }, { y: 150 }, { y: 197 }, { y: 200 }];
  spread(places, 0, 200);
  assert.deepEqual(
    places.map(({ y }) => y),
    [8, 150, 183, 200],
  );
});

test('a chart that is narrower than its margins has points all the same', () => {
  for (const right of [frame.left, frame.left - 30]) {
    const values = tremblingOf(500, [0, 1]);
    const xs = values.map((_, i) => i);
    assert.ok(pointsOf({ ...axesOf(values), frame: { ...frame, right } }, xs, values).length > 0);
  }
});

test('a curve goes from its first number to where it has none', () => {
  for (const count of [50, 5000]) {
    const values = tremblingOf(count, [0.3, -0.3]);
    values.fill(Number.NaN, 0, 10);
    values[40] = Number.NaN;
    const { x } = axesOf(values);
    const points = pointsOf(
      axesOf(values),
      values.map((_, i) => i),
      values,
    );
    assert.equal(points[0][0], x(10));
    assert.ok(points.every(([px]) => px < x(40)));
    assert.ok(points.every(([, py]) => Number.isFinite(py)));
  }
});

test('a value that is held until the next sample makes steps', () => {
  const values = [-0.5, 0.5, 0];
  const { x, y } = axesOf(values);
  const points = pointsOf(axesOf(values), [0, 1, 2], values, true);
  assert.deepEqual(points, [
    [x(0), y(-0.5)],
    [x(1), y(-0.5)],
    [x(1), y(0.5)],
    [x(2), y(0.5)],
    [x(2), y(0)],
  ]);
});

test('a column reaches from its least finite number to its largest, however long it is', () => {
  const numbers = fc.oneof(
    { weight: 30, arbitrary: fc.double({ min: -1e6, max: 1e6, noNaN: true }) },
    { weight: 1, arbitrary: fc.constantFrom(Number.NaN, Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY) },
  );
  fc.assert(
    fc.property(
      fc.array(numbers, { minLength: 1, maxLength: 50 }),
      fc.integer({ min: 1, max: 20_000 }),
      (some, count) => {
        const values = Array.from({ length: count }, (_, i) => some[(i * 13) % some.length] + 0);
        const finite = values.filter(Number.isFinite);
        const wanted = finite.reduce(
          ([low, high], one) => [Math.min(low, one), Math.max(high, one)],
          [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY],
        );
        for (const column of [values, Float64Array.from(values)])
          assert.deepEqual(extentOf([column]), wanted);
        const outline = outlineOf(Float64Array.from(values));
        assert.equal(outline !== null, count > 8192 && finite.length === count);
      },
    ),
    { numRuns: 60 },
  );
  // So many are too many for the arguments of a function.
  const many = Array.from({ length: 300_000 }, (_, i) => Math.sin(i));
  assert.deepEqual(extentOf([many], [-2, 0.5]), [-2, largest(many)]);
  assert.deepEqual(extentOf([]), [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY]);
});

test('the numbers of an axis are their ticks, however near together these are', () => {
  const ends = fc.double({ min: -100, max: 100, noNaN: true });
  fc.assert(
    fc.property(ends, fc.integer({ min: -9, max: 2 }), (low, power) => {
      const high = low + 10 ** power;
      const ticks = ticksOn(scaleLinear([low, high], [0, 400]), 50);
      const step = ticks[1] - ticks[0];
      for (const [i, text] of sameDigits(ticks).entries())
        assert.ok(
          Math.abs(Number(text.replace('−', '-')) - ticks[i]) < 1e-3 * step,
          `${text} for ${ticks[i]}`,
        );
    }),
  );
  assert.deepEqual(sameDigits([0, 0.25, 0.5]), ['0.00', '0.25', '0.50']);
  assert.deepEqual(sameDigits([0, 20, 40]), ['0', '20', '40']);
  assert.deepEqual(sameDigits([-150, -100]), ['−150', '−100']);
  // One alone has nothing to be told apart from.
  assert.deepEqual(sameDigits([5.41]), ['5.41']);
  assert.deepEqual(sameDigits([0]), ['0']);
  assert.deepEqual(sameDigits([9000, 9500, 10_000]), ['9000', '9500', '10000']);
  assert.deepEqual(sameDigits([0, 100_000, 200_000]), ['0', '100k', '200k']);
  assert.deepEqual(sameDigits([11_600_000, 11_700_000]), ['11.6M', '11.7M']);
  assert.deepEqual(sameDigits([-4e9, -2e9, 0]), ['−4G', '−2G', '0']);
  assert.deepEqual(sameDigits([0, 5e14]), ['0', '500T']);
  assert.deepEqual(sameDigits([-2e48, 0, 2e48]), ['−2e48', '0', '2e48']);
});

test('where a picture is low the numbers of its axis stand closer, before one stands alone', () => {
  const low = scaleLinear([8.7, 11.5], [54, 0]);
  assert.deepEqual(ticksOn(low, 32), [10]);
  assert.deepEqual(levelsOn(low), [9, 10, 11]);
  const high = scaleLinear([8.7, 11.5], [300, 0]);
  assert.deepEqual(levelsOn(high), ticksOn(high, 32));
});

test('numbers of an axis do not touch: the first of them stays, and so does each that has room', () => {
  const heights = fc.array(fc.double({ min: 0, max: 200, noNaN: true }), { minLength: 1, maxLength: 12 });
  fc.assert(
    fc.property(heights, (all) => {
      const kept = standingFree(all);
      assert.equal(kept[0], 0);
      const near = (/** @type {number} */ i) => kept.filter((other) => Math.abs(all[other] - all[i]) < 13);
      for (const i of all.keys())
        if (kept.includes(i)) assert.deepEqual(near(i), [i]);
        else assert.ok(near(i).some((other) => other < i));
    }),
  );
  // The limits of a low picture, then 0 between them.
  assert.deepEqual(standingFree([10, 27, 18.5]), [0, 1]);
});
