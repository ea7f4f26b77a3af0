import assert from 'node:assert/strict';
import fc from 'fast-check';
import { lowestOf, markedOf } from '../../../www/parts/landscape/lowest.js';
import { placeNames } from '../../../www/parts/landscape/names.js';
import { namesOf } from '../../../www/parts/landscape/points.js';
import { isInSlice, linearRange } from '../../../www/parts/landscape/request.js';
import { landscapeSlice } from '../../../www/parts/landscape/state.js';
import * as en from '../../../www/parts/landscape/words/en.js';
import * as ko from '../../../www/parts/landscape/words/ko.js';
import { createCostScale, numbersAt } from '../../../www/parts/landscape/scale.js';
import { legendOf, noteText } from '../../../www/parts/landscape/told.js';
import words from '../../../www/parts/landscape/words/index.js';
import { pageTest } from '../harness/browsers.js';
import { evaluate, experiment, landscape, paperGains, simulate, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../../../www/parts/landscape/request.js').Spec} Spec */
/** @typedef {import('../../../www/parts/landscape/names.js').Spot} Spot */

const velocityLimits = experiment('velocity-limits');
const [, paperKy] = paperGains('velocity-limits', 'ep');
const count = 128;
const [from, to] = linearRange['velocity-limits'];

/** What the map of kx and kθ shows. @param {import('../harness/core.js').Experiment} own @param {number} third */
function mapOf(own, third) {
  const axis = (/** @type {'kx' | 'ktheta'} */ gain) => ({ gain, log: false, from, to, count });
  const costs = landscape(own, { x: axis('kx'), y: axis('ktheta'), gains: [0, third, 0] });
  /** @type {Spec} */
  const spec = {
    experiment: own,
    x: { gain: 'kx', log: false },
    y: { gain: 'ktheta', log: false },
    range: [from, to],
    third,
  };
  return { spec, count, costs, milliseconds: 0 };
}

test('whoever drives with the gains of the lowest point pays what the map says, and nobody on the map pays less', () => {
  for (const theta of [Math.PI / 4, Math.PI / 2]) {
    const own = experiment({ ...velocityLimits, goal: { ...velocityLimits.goal, theta } });
    const map = mapOf(own, paperKy);
    const lowest = lowestOf(map);
    assert.ok(lowest);
    assert.equal(lowest.cost, Math.min(...map.costs));
    assert.equal(evaluate(own, lowest.gains)[0], lowest.cost);
    assert.equal(lowest.gains[1], paperKy);
  }
});

test('the lowest point is said to be that of the points that were computed, however many', () => {
  for (const [size, text] of /** @type {const} */ ([
    [64, /\b4[\s,]096\b/],
    [128, /\b16[\s,]?384\b/],
  ])) {
    const lowest = lowestOf({
      ...mapOf(velocityLimits, paperKy),
      count: size,
      costs: new Float64Array(size ** 2),
    });
    assert.equal(lowest?.points, size ** 2);
    for (const words of [en, ko]) assert.match(words.lowestText(lowest.points, 'kx 1', lowest.cost), text);
  }
});

test('where every J is infinite nothing is lowest', () => {
  const map = mapOf(velocityLimits, paperKy);
  assert.equal(lowestOf({ ...map, costs: map.costs.map(() => Number.POSITIVE_INFINITY) }), null);
  // Nor where all are alike is one marked.
  assert.equal(markedOf({ ...map, costs: map.costs.map(() => 8.6) }), null);
  assert.deepEqual(markedOf(map), lowestOf(map));
});

test('the drives of a landscape are counted from every start', () => {
  const { starts } = velocityLimits;
  for (const from of [starts, [...starts, ...starts, ...starts]]) {
    const result = { ...mapOf({ ...velocityLimits, starts }, paperKy), milliseconds: 5 };
    const spec = { ...result.spec, experiment: { ...velocityLimits, starts: from } };
    const note = noteText({ ...landscapeSlice.first, result: { ...result, spec } }, spec);
    assert.equal(Number(note.replace(/ drives.*/, '').replace(/\D/g, '')), count * count * from.length, note);
  }
});

const frame = { left: 44, right: 500, top: 10, bottom: 300 };
const somewhere = fc.record({
  x: fc.double({ min: 44, max: 500, noNaN: true }),
  y: fc.double({ min: 10, max: 300, noNaN: true }),
});

test('names stay on the map, and one that has a free side covers no mark', () => {
  fc.assert(
    fc.property(somewhere, fc.array(somewhere, { maxLength: 3 }), (own, others) => {
      const spots = [own, ...others].map(({ x, y }) => /** @type {Spot} */ ([x, y, 8]));
      const [place] = placeNames(frame, [{ ...own, name: 'name', width: 60 }], spots);
      assert.ok(place);
      assert.ok(place.left >= frame.left && place.left + place.width <= frame.right);
      assert.ok(place.top >= frame.top && place.top <= frame.bottom - 17);
      const isFar = others.every(({ x, y }) => Math.hypot(x - own.x, y - own.y) > 120);
      const covered = spots.some(
        ([x, y]) => x > place.left && x < place.left + place.width && y > place.top && y < place.top + 17,
      );
      assert.ok(!isFar || !covered);
    }),
  );
});

test('a name beside which somebody stands goes to another side', () => {
  const named = { x: 200, y: 150, name: 'name', width: 60 };
  const [free] = placeNames(frame, [named], [[200, 150, 8]]);
  assert.ok(free && free.left > 200);
  const [moved] = placeNames(frame, [named], [[200, 150, 8], [240, 150, 8]]); // biome-ignore format: two marks
  assert.ok(moved && moved.left + moved.width < 200);
});

test('no name lies on what is sought: it covers a mark instead, or gives way', () => {
  const named = { x: 200, y: 150, name: 'name', width: 60 };
  const [beside] = placeNames(frame, [named], [[200, 150, 8], [160, 150, 8]], [[240, 150, 8]]); // biome-ignore format: marks
  assert.ok(beside && (beside.left + 60 < 200 || Math.abs(beside.top + 8.5 - 150) > 8));
  const all = /** @type {const} */ ([[240, 150, 8], [160, 150, 8], [200, 125, 8], [200, 175, 8]]); // biome-ignore format: all sides
  assert.deepEqual(placeNames(frame, [named], [], all), [null]);
});

test('a name that has no room before the edge stands at the other side, and its halo ends on the map', () => {
  for (const x of [426, 430, 440, 500]) {
    const [place] = placeNames(frame, [{ x, y: 150, name: 'name', width: 60 }], [[x, 150, 8]]);
    assert.ok(place && place.left + 60 < x, `${x}: ${place?.left}`);
  }
  const [last] = placeNames(frame, [{ x: 420, y: 298, name: 'name', width: 60 }], []);
  assert.ok(last && last.left + 60 + 4 < frame.right && last.top + 17 + 4 < frame.bottom);
});

test('no name lies on another: where there is no side left, the later ones give way', () => {
  fc.assert(
    fc.property(fc.array(somewhere, { minLength: 2, maxLength: 8 }), (points) => {
      const named = points.map((one) => ({ ...one, name: 'name', width: 60 }));
      const places = placeNames(frame, named, []);
      assert.ok(places[0]);
      for (const [i, a] of places.entries())
        for (const b of places.slice(i + 1))
          assert.ok(!a || !b || Math.abs(a.top - b.top) >= 17 || Math.abs(a.left - b.left) >= 60);
    }),
  );
  const crowd = Array(6).fill({ x: 200, y: 150, name: 'name', width: 60 });
  const kept = placeNames(frame, crowd, []).map((place) => place !== null);
  assert.deepEqual(kept, [true, true, true, true, false, false]);
});

test('the lowest point has its name and all its four strokes, wherever others stand around it', () => {
  const at = { x: 200, y: 150 };
  for (const [dx, dy] of [
    [-24, -18],
    [-24, 18],
    [24, -18],
    [0, -26],
    [-30, 0],
  ]) {
    // biome-ignore format: places
    const point = (/** @type {number} */ x, /** @type {number} */ y, /** @type {any} */ mark) =>
      /** @type {const} */ ({ gains: [0, 0, 0], name: mark, mark, place: [x, y], isPale: false });
    const points = [point(at.x, at.y, 'sight'), point(at.x + dx, at.y + dy, 'diamond')];
    const names = namesOf(frame, points, [], () => 80);
    assert.equal(names[0].name, 'sight');
    assert.ok(names[0].place);
    const place = names[1].place;
    assert.ok(place);
    for (const [x, y] of [[-11, 0], [11, 0], [0, -11], [0, 11]]) // biome-ignore format: strokes
      assert.ok(
        at.x + x <= place.left ||
          at.x + x >= place.left + 80 ||
          at.y + y <= place.top ||
          at.y + y >= place.top + 17,
        `beside it at ${dx}, ${dy}`,
      );
  }
});

test('what is not in the slice is told to be paler, and what is in it is not', () => {
  const map = mapOf(velocityLimits, paperKy);
  const [own, other] = [paperGains('velocity-limits', 'ep'), paperGains('velocity-limits', 'arbitrary')];
  assert.equal(isInSlice(map.spec, own), true);
  assert.equal(isInSlice(map.spec, other), false);
  const told = (/** @type {typeof own[]} */ ...gains) =>
    legendOf(
      /** @type {any} */ ({ experiment: velocityLimits, population: [] }),
      map.spec,
      gains.map((one) => ({ gains: one })),
    );
  assert.ok(told(own, other).includes(words.paler('ky')), told(own, other));
  assert.ok(!told(own).includes(words.paler('ky')), told(own));
});

pageTest(
  'the lowest point of the picture is told, with its J, and follows what the picture shows',
  async (page) => {
    await page.open('#landscape&drives=paper-ep');
    const told = (/** @type {string} */ cost) =>
      page.until(
        `the lowest point at J ${cost}`,
        (wanted) => {
          const text = document.getElementById('landscape-lowest')?.innerText ?? '';
          return (
            /^Lowest of these 16\s384 points: /.test(text.trim()) && text.includes(`: J ${wanted} `) && text
          );
        },
        cost,
      );
    const lowest = lowestOf(mapOf(velocityLimits, paperKy));
    assert.ok(lowest);
    const text = await told(lowest.cost.toFixed(3));
    const [kx, , ktheta] =
      /kx\s([\d.]+), ky\s([\d.]+), kθ\s([\d.]+)/.exec(String(text))?.slice(1).map(Number) ?? [];
    assert.ok(Math.abs(kx - lowest.gains[0]) < 0.01 && Math.abs(ktheta - lowest.gains[2]) < 0.01);
    assert.ok(simulate(velocityLimits, lowest.gains).arrived);

    await page.open('#landscape&drives=paper-ep&goal.theta=90deg');
    const turned = experiment({ ...velocityLimits, goal: { ...velocityLimits.goal, theta: Math.PI / 2 } });
    const other = lowestOf(mapOf(turned, paperKy));
    assert.ok(other && other.cost > lowest.cost);
    await told(other.cost.toFixed(3));
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('in the sentences of the landscape the gains are written as in formulas', async (page) => {
  await page.open('#landscape');
  await page.until('the lowest point is told', () => document.querySelector('#landscape-lowest .symbol'));
  const written = await page.evaluate(() =>
    ['lowest', 'readout', 'method'].map((id) =>
      [...document.querySelectorAll(`#landscape-${id} .symbol`)].map(({ className }) => className),
    ),
  );
  const all = ['symbol kx', 'symbol ky', 'symbol ktheta'];
  assert.deepEqual(written, [all, all, ['symbol ky']]);
});

test('whatever searches, the path is said to be that of the best so far', () => {
  const methods = /** @type {Parameters<typeof en.methodSketch>[0][]} */ (
    wordFields().find(({ path }) => path === 'evolution.method')?.words ?? []
  );
  assert.ok(methods.length > 5);
  for (const method of methods) {
    assert.match(en.methodSketch(method), / Line: best so far\. Contours/);
    assert.match(ko.methodSketch(method), / 선: 지금까지의 최우수\. 등고선/);
  }
});

test('crosses are told of where a σ is above 0', () => {
  const { spec } = mapOf(velocityLimits, paperKy);
  const told = (/** @type {number} */ sigma) =>
    legendOf(
      /** @type {any} */ ({
        experiment: velocityLimits,
        population: [{ gains: [1, paperKy, 1], sigmas: [0, sigma, 0] }],
      }),
      spec,
      [],
    );
  assert.match(told(0.1), /Crosses/);
  assert.doesNotMatch(told(0), /Crosses/);
});

test('the bar of J has the levels of the picture, or where there are not two its ends', () => {
  const texts = (/** @type {number[]} */ ...costs) =>
    numbersAt(createCostScale(Float64Array.from(costs))).map(({ text }) => text);
  assert.deepEqual(texts(8.6, 8.62, 8.626), ['8.600', '≥\u202f8.620']);
  assert.deepEqual(texts(8.617, 8.617), ['8.617']);
  const wide = Array.from({ length: 1000 }, (_, i) => 264.4 + i / 150);
  assert.deepEqual(texts(...wide).length, 2);
  const high = Array.from({ length: 1000 }, (_, i) => 1.2e7 + i);
  assert.deepEqual(texts(...high), ['1.2×10⁷', '≥\u202f1.2001×10⁷']);
  assert.ok(texts(...wide.map((_, i) => 5 + i / 10)).length > 2);
});
