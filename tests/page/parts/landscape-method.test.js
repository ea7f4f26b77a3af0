// What the map draws of a method is what the core says of its generation.
import assert from 'node:assert/strict';
import { ringOf } from '../../../www/kit/ellipse.js';
import { hasCrosses, sketchOf } from '../../../www/parts/landscape/method.js';
import { linearRange } from '../../../www/parts/landscape/request.js';
import { axesOf } from '../../../www/parts/landscape/view.js';
import * as en from '../../../www/parts/landscape/words/en.js';
import * as ko from '../../../www/parts/landscape/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';

/** @typedef {import('../harness/core.js').Experiment['evolution']['method']} Method */
/** @typedef {import('../../../www/core/engine.js').Triple} Triple */

const base = experiment('velocity-limits');
/** @param {Method} method @param {number} generations */
function recordsOf(method, generations) {
  const evolution = new Evolution({ ...base, evolution: { ...base.evolution, method } });
  for (let i = 0; i < generations; i += 1) evolution.step();
  return Array.from({ length: generations + 1 }, (_, g) => evolution.record(g));
}
/** @type {import('../../../www/kit/ellipse.js').Shadow} */
const shadow = ([kx, , ktheta]) => [kx, ktheta];

test('the ellipse is where the density of two gains has fallen as far as at one deviation', () => {
  for (const { ellipse } of recordsOf('cma-es', 30)) {
    assert.ok(ellipse);
    const { mean, axes } = ellipse;
    const [a, b, c] = [
      [0, 0],
      [0, 2],
      [2, 2],
    ].map(([i, j]) => axes.reduce((sum, axis) => sum + axis[i] * axis[j], 0));
    const determinant = a * c - b * b;
    for (const deviations of [1, 2])
      for (const [px, py] of ringOf(ellipse, shadow, deviations)) {
        const [x, y] = [px - mean[0], py - mean[2]];
        const distance = (c * x * x - 2 * b * x * y + a * y * y) / determinant;
        assert.ok(Math.abs(distance / deviations ** 2 - 1) < 1e-6, `${distance}`);
      }
  }
});

test('most robots of CMA-ES stand within two deviations of its ellipse', () => {
  const records = recordsOf('cma-es', 60).slice(1);
  let [inside, all] = [0, 0];
  for (const { ellipse, offspring } of records) {
    assert.ok(ellipse);
    const { mean, axes } = ellipse;
    for (const { gains } of offspring) {
      // In units of the axes, which stand at right angles.
      const apart = axes.map((axis) => {
        const squared = axis.reduce((sum, x) => sum + x * x, 0);
        return axis.reduce((sum, x, j) => sum + x * (gains[j] - mean[j]), 0) / squared;
      });
      all += 1;
      inside += Number(apart.reduce((sum, x) => sum + x * x, 0) < 4);
    }
  }
  // Of a normal distribution of three dimensions 74 %.
  assert.ok(Math.abs(inside / all - 0.7385) < 0.03, `${inside / all}`);
});

test('a line of DE leads from a to a + F (b − c), but for what is crossed', () => {
  let seen = 0;
  for (const record of recordsOf('de', 20).slice(1)) {
    const { lines, faint } = sketchOf('de', record, shadow);
    const won = record.survivors.filter((number) => number >= record.parents.length).length;
    assert.equal(lines.length, won);
    assert.equal(faint.length, record.offspring.length - won + won);
    for (const [i, [a, b, c]] of record.donors.entries()) {
      const [from, plus, minus] = [a, b, c].map((n) => record.parents[n].gains);
      const { gains } = record.offspring[i];
      const crossed = gains.filter((gain, j) => gain === from[j] + 0.5 * (plus[j] - minus[j]));
      assert.ok(crossed.length >= 1, 'one gain at least is of the mutant');
      seen += 1;
    }
  }
  assert.equal(seen, 400);
});

test('the simplex has six edges between its four corners, whatever decides over a fifth', () => {
  for (const record of recordsOf('nelder-mead', 120)) {
    const { lines } = sketchOf('nelder-mead', record, shadow);
    assert.equal(lines.length, 6, `generation ${record.generation}`);
    const places = new Set(lines.flat().map(String));
    // A corner that is one step away in the third gain falls on the first.
    assert.ok(places.size >= 3);
  }
});

test('dashed lines lead from the simplex to what was not taken, or to the corner that went', () => {
  let [kept, taken] = [0, 0];
  for (const record of recordsOf('nelder-mead', 120).slice(1)) {
    const { parents, offspring, survivors } = record;
    if (offspring.length > 1) continue;
    const isTaken = survivors.length === 4 && survivors.includes(parents.length);
    // The parents are ranked.
    const end = isTaken ? parents[parents.length - 1] : offspring[0];
    if (isTaken) assert.ok(!survivors.includes(parents.length - 1), `generation ${record.generation}`);
    const { faint } = sketchOf('nelder-mead', record, shadow);
    assert.deepEqual(
      faint.map(([, to]) => to),
      Array(4).fill(shadow(end.gains)),
    );
    if (isTaken) taken += 1;
    else kept += 1;
  }
  assert.ok(kept > 5 && taken > 5, `${kept}, ${taken}`);
  assert.match(en.methodSketch('nelder-mead'), /tried .* corner that went/);
});

test('crosses are named where they are drawn, and there alone: of who steps from its own place by its own σ', () => {
  const methods = /** @type {readonly Method[]} */ (
    wordFields().find(({ path }) => path === 'evolution.method')?.words
  );
  assert.deepEqual(methods.filter(hasCrosses), ['ep', 'one-plus-one-es']);
  for (const method of methods) {
    assert.equal(/cross/i.test(en.methodSketch(method)), hasCrosses(method), method);
    assert.equal(/십자/.test(ko.methodSketch(method)), hasCrosses(method), method);
    for (const words of [en, ko]) assert.doesNotMatch(words.methodSketch(method, true), /cross|십자/i);
  }
  const evolution = new Evolution({ ...base, evolution: { ...base.evolution, method: 'one-plus-one-es' } });
  for (let generation = 1; generation <= 20; generation += 1) {
    evolution.step();
    assert.deepEqual(evolution.population()[0].sigmas, evolution.record(generation).next.steps);
  }
});

test('of a method that goes from point to point the line is its step; EP and random search have their own marks', () => {
  for (const method of /** @type {const} */ (['one-plus-one-es', 'one-at-a-time', 'finite-differences']))
    for (const record of recordsOf(method, 20).slice(1)) {
      const { lines } = sketchOf(method, record, shadow);
      assert.deepEqual(
        lines,
        record.offspring.map(({ gains }) => [
          shadow(/** @type {Triple} */ (record.parents[0].gains)),
          shadow(/** @type {Triple} */ (gains)),
        ]),
      );
    }
  for (const method of /** @type {const} */ (['ep', 'random'])) {
    const { rings, lines, faint } = sketchOf(method, recordsOf(method, 1)[1], shadow);
    assert.equal(rings.length + lines.length + faint.length, 0);
  }
});

/** Which share of these points of the marks is light. @param {import('../harness/browsers.js').Page} page @param {readonly (readonly [number, number])[]} points */
const lightAt = (page, points) =>
  page.evaluate((places) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('landscape-marks'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    const isLight = (/** @type {readonly [number, number]} */ [x, y]) => {
      const at = [x, y].map((place) => Math.floor(place * devicePixelRatio));
      return Math.min(...context.getImageData(at[0], at[1], 1, 1).data) > 180;
    };
    return places.filter(isLight).length / places.length;
  }, points);

pageTest('the map draws what a method sees, and says what it draws', async (page) => {
  await page.open('#landscape&v=1&generation=6');
  const says = (/** @type {Method} */ method) =>
    page.until(
      `it says what is drawn of ${method}`,
      (text) =>
        document.getElementById('generation')?.textContent === '6' &&
        document.getElementById('landscape-method')?.textContent?.startsWith(text),
      en.methodSketch(method),
    );
  await says('ep');
  for (const method of /** @type {const} */ (['cma-es', 'de', 'nelder-mead'])) {
    await follow(page, `landscape&v=1&evolution.method=${method}&generation=6`);
    await says(method);
    const size = await page.evaluate(() => {
      const { clientWidth, clientHeight } = /** @type {Element} */ (document.getElementById('landscape-map'));
      return { width: clientWidth, height: clientHeight };
    });
    const spec = /** @type {any} */ ({
      x: { log: false },
      y: { log: false },
      range: linearRange['velocity-limits'],
    });
    const { x, y } = axesOf(/** @type {any} */ ({ spec, size }));
    const { rings, lines } = sketchOf(method, recordsOf(method, 6)[6], shadow);
    const middles = lines.map(
      ([[ax, ay], [bx, by]]) => /** @type {const} */ ([(ax + bx) / 2, (ay + by) / 2]),
    );
    const points = [...rings.flat(), ...middles].filter(([kx, ktheta]) => x.holds(kx) && y.holds(ktheta));
    assert.ok(points.length > 2, method);
    const share = await lightAt(
      page,
      points.map(([kx, ktheta]) => [x.at(kx), y.at(ktheta)]),
    );
    assert.ok(share > 0.8, `${method}: ${share} of ${points.length}`);
  }
  assert.deepEqual(await page.problems(), []);
});
