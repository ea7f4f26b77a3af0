// Many seeds while they run: those that have run stand in the pictures, and what they say together follows at the end.
import assert from 'node:assert/strict';
import { createSurveys } from '../../../www/core/surveys.js';
import { sight } from '../../../www/parts/luck/sight.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import { summaryOf } from '../../../www/parts/luck/statistics.js';
import * as en from '../../../www/parts/luck/words/en.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { seedRuns } from '../../../pkg/ep_locomotion.js';
import { pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { slowEngine } from '../harness/slow-engine.js';
import { holdWorkers, releaseWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const usual = experiment('velocity-limits');
const [count, generations] = [20, 50];

test('runs are told from the first seed on, as far as all before them are there', async () => {
  /** @type {number[][]} */
  const told = [];
  /** @type {any} */
  const pool = {
    size: 1,
    async run(/** @type {any} */ { parts }, /** @type {any} */ { onPart }) {
      const results = parts.map((/** @type {any} */ [, { seeds }]) => [{ seed: seeds[0] }]);
      for (const i of [1, 0, 3, 2]) onPart(results[i], i);
      return results;
    },
  };
  const runs = await createSurveys(pool).seedRuns(
    usual,
    { first: 7, count: 4, generations: 1000 },
    { onRuns: (/** @type {any[]} */ some) => told.push(some.map(({ seed }) => seed)) },
  );
  assert.deepEqual(told, [
    [7, 8],
    [7, 8, 9, 10],
  ]);
  assert.equal(runs.length, 4);
});

/** What the part says and shows. @param {Page} page */
const readSight = (page) =>
  page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const of = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
    const { arcs } = /** @type {{ arcs: Map<unknown, number> }} */ (/** @type {unknown} */ (window));
    return {
      finding: of('luck-finding').innerText,
      curve: of('luck-curve').getAttribute('aria-label') ?? '',
      gains: of('luck-gains').getAttribute('aria-label') ?? '',
      circles: arcs.get(of('luck-gains')),
      hasTable: of('luck-table').checkVisibility(),
      hasSeed: of('luck-rank').checkVisibility({ visibilityProperty: true }),
      status: of('luck-status').innerText,
    };
  });

/** Counts the circles that stand on each canvas. @param {Page} page */
const countCircles = (page) =>
  page.evaluate(() => {
    const { arc, clearRect } = CanvasRenderingContext2D.prototype;
    const arcs = new Map();
    Object.assign(window, { arcs });
    Object.assign(CanvasRenderingContext2D.prototype, {
      clearRect(/** @type {any[]} */ ...args) {
        arcs.set(/** @type {any} */ (this).canvas, 0);
        return clearRect.apply(this, /** @type {any} */ (args));
      },
      arc(/** @type {any[]} */ ...args) {
        arcs.set(/** @type {any} */ (this).canvas, (arcs.get(/** @type {any} */ (this).canvas) ?? 0) + 1);
        return arc.apply(this, /** @type {any} */ (args));
      },
    });
  });

test('what has run is told in whole seeds, also where their share is a bit less', () => {
  const { engine } = slowEngine();
  const state = firstState(engine, 'velocity-limits', atEnd);
  for (let done = 0; done <= 100; done += 1) {
    const luck = { ...luckSlice.first, progress: done / 100, count: 100 };
    const { values } = sight({ ...state, slices: { luck } }, -1, true, /** @type {any} */ ({}));
    assert.ok(values.includes(en.seedsOf(done, 100)), `${done}`);
  }
});

/** Lets so many seeds run and holds the others; who presses twice means once. @param {Page} page @param {number} done */
async function runSome(page, done) {
  // And the paper's gains, which are asked for first.
  await holdWorkers(page, done + 1);
  // Of a real double press the second counts as one only where the page is quick.
  await page.evaluate(() => {
    for (const detail of [1, 2])
      document.getElementById('luck-run')?.dispatchEvent(new MouseEvent('click', { detail, bubbles: true }));
  });
  await page.until(
    'some have run',
    (label) =>
      document.getElementById('luck-run')?.textContent === 'Cancel' &&
      document.getElementById('luck-curve')?.getAttribute('aria-label')?.includes(label),
    done > 0 ? en.seedsOf(done, count) : en.emptyCurveLabel,
  );
  assert.equal(await (await page.element('#luck-count')).isEnabled(), false);
}

/** @param {Page} page */
async function cancel(page) {
  await page.click('#luck-run');
  await page.until('no seeds run', () => document.getElementById('luck-run')?.textContent?.startsWith('Run'));
  await releaseWorkers(page);
}

pageTest(
  'the pictures grow with the seeds that have run, and say so; cancelled, they show what they did',
  async (page) => {
    await page.open(`#luck&runs=${count}&length=${generations}`);
    await countCircles(page);
    const before = await readSight(page);
    const runs = seedRuns(usual, { seeds: [1, 1 + count], generations });

    await runSome(page, 6);
    const six = await readSight(page);
    assert.equal(six.gains, en.gainsLabel(/** @type {any} */ ({ summary: summaryOf(runs.slice(0, 6)) })));
    // A dot a seed and gain, and a ring around the lab's own.
    assert.equal(six.circles, 3 * 6 + 3);
    assert.equal(six.finding, before.finding);
    assert.deepEqual([six.hasTable, six.hasSeed], [false, false]);
    await cancel(page);
    const { status, circles, ...cancelled } = await readSight(page);
    assert.equal(status, en.cancelled(false));
    assert.equal(circles, 0);
    assert.deepEqual(cancelled, {
      finding: before.finding,
      curve: before.curve,
      gains: before.gains,
      hasTable: false,
      hasSeed: false,
    });

    await page.click('#luck-run');
    await page.until('the seeds have run', () => document.getElementById('luck-seed')?.hidden === false);
    const whole = await readSight(page);
    assert.equal(whole.gains, en.gainsLabel(/** @type {any} */ ({ summary: summaryOf(runs) })));
    assert.equal(whole.circles, 3 * count + 3);
    assert.ok(whole.curve.includes(whole.finding) && whole.finding !== before.finding, whole.curve);
    assert.deepEqual([whole.hasTable, whole.hasSeed, whole.status], [true, true, '']);

    await runSome(page, 3);
    const again = await readSight(page);
    assert.equal(again.circles, 3 * 3 + 3);
    assert.equal(again.finding, before.finding);
    assert.deepEqual([again.hasTable, again.hasSeed], [false, false]);
    await cancel(page);
    assert.deepEqual(await readSight(page), { ...whole, status: en.cancelled(true) });
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('while seeds run, what runs is told, whatever a link has set since', async (page) => {
  const told = async () => ({
    finding: (await readSight(page)).finding,
    note: await page.text('#luck-note'),
  });
  await page.open(`#luck&runs=${count}&length=${generations}`);
  await countCircles(page);
  for (const done of [0, 6]) {
    await runSome(page, done);
    const before = await told();
    assert.equal(before.note, en.seedsOf(done, count));
    await follow(page, 'luck&v=1&runs=500&length=200&population=30');
    await page.until('it is set', () => document.querySelector('#luck-count [value="500"]:checked'));
    assert.deepEqual(await told(), before);
    await cancel(page);
    const { note, finding } = await told();
    assert.ok(note !== before.note && finding !== before.finding, finding);
    await follow(page, `luck&v=1&runs=${count}&length=${generations}`);
    await page.until('it is set back', () => document.querySelector('#luck-count [value="20"]:checked'));
  }
  assert.deepEqual(await page.problems(), []);
});
