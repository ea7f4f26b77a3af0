// Which row of Training drives once all have evolved.
import assert from 'node:assert/strict';
import { furthestOf } from '../../../www/parts/training/request.js';
import { createSets, setNames, testOn } from '../../../www/parts/training/sets.js';
import { rangesOf } from '../../../www/parts/training/spread.js';
import * as en from '../../../www/parts/training/words/en.js';
import * as ko from '../../../www/parts/training/words/ko.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, experiment, fares, startsOnCircle } from '../harness/core.js';
import { test } from '../harness/once.js';
import { delayWorkers, releaseWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const generations = 50;
/** Few robots, with which the rows differ as well. */
const few = { population: 4, seed: 2 };
const link = `training&v=1&evolve=${generations}&population=${few.population}&seed=${few.seed}`;

test('the furthest row arrives from the most starts, then has the lowest J', () => {
  const of = (/** @type {[number, number][]} */ ...rows) =>
    furthestOf(
      /** @type {any} */ (
        Object.fromEntries(rows.map(([count, cost], i) => [setNames[i], { unseen: { count, cost } }]))
      ),
    );
  assert.equal(of([3, 9], [2, 1], [1, 1]), 'one');
  assert.equal(of([3, 9], [5, 20], [4, 1]), 'circle');
  assert.equal(of([3, 9], [5, 20], [5, 19]), 'grid');
  // Where the reference moves.
  assert.equal(of([0, 9], [0, 7], [0, 8]), 'circle');
});

test('of an experiment with many starts nothing says that it has one', () => {
  const faring = (/** @type {number} */ count) => ({ starts: Array(count), count, cost: 9 });
  const result = (/** @type {number} */ count) =>
    /** @type {any} */ ({ training: faring(count), unseen: faring(1000 + count), own: count });
  const many = result(99);
  const ranges = rangesOf({ one: [10, 20], circle: [500, 600], grid: [700, 800] });
  for (const [words, ofOne] of /** @type {const} */ ([
    [en, /\b(one )?start\b/],
    [ko, /출발점 하나|출발점 1개|^출발점\sJ$/m],
  ])) {
    const said = [1, 5].map((count) => [
      words.columnsOf(1000, count).at(-1),
      words.invitation(count),
      words.question(result(count)),
      words.spreadText(ranges, 1000, count),
      words.lesson(/** @type {any} */ ({ results: { one: result(count), circle: many, grid: many } })),
    ]);
    for (const text of said[0]) assert.match(String(text), ofOne);
    for (const text of said[1]) assert.doesNotMatch(String(text), ofOne);
  }
});

/** From how many unseen starts each arrives. @param {import('../../../pkg/ep_locomotion.js').Preset} preset */
function countsOf(preset) {
  const usual = experiment(preset);
  const from = { ...usual, evolution: { ...usual.evolution, ...few } };
  const sets = createSets({ startsOnCircle })(from);
  return setNames.map((name) => {
    const evolution = new Evolution({ ...from, starts: sets[name] });
    for (let i = 0; i < generations; i += 1) evolution.step();
    const { arrived } = fares(testOn(from, sets.unseen), evolution.statistics().best.gains);
    return arrived.reduce((sum, one) => sum + one, 0);
  });
}

/** Evolves all, and says which row drives then. @param {Page} page @param {string} note That is no longer there. */
async function evolveAgain(page, note) {
  await page.click('#training-evolve');
  await page.until(
    'all have evolved',
    (before) =>
      document.getElementById('training-evolve')?.innerText === 'Evolve again' &&
      document.getElementById('training-finding')?.innerText !== before,
    note,
  );
  return page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const rows = [...document.querySelectorAll('#training-table .chosen')].map(({ id }) => id);
    const finding = document.getElementById('training-finding')?.innerText ?? '';
    const title = document.getElementById('training-unseen-title')?.innerText;
    return { rows: String(rows), finding, title };
  });
}

pageTest('the row that comes furthest drives, until somebody chooses another', async (page) => {
  await page.open(`#${link}`);
  const furthest = ['velocity-limits', 'acceleration-limits'].map((preset) => {
    const counts = countsOf(/** @type {any} */ (preset));
    const most = Math.max(...counts);
    return { rows: `training-${setNames[counts.indexOf(most)]}`, title: `Never seen: ${most} of 1000` };
  });
  assert.notEqual(furthest[0].rows, furthest[1].rows);
  assert.notEqual(furthest[0].rows, 'training-grid');
  let finding = await page.text('#training-finding');
  for (const [i, preset] of ['velocity-limits', 'acceleration-limits'].entries()) {
    await page.click(`#preset-${preset}`);
    const evolved = await evolveAgain(page, finding);
    ({ finding } = evolved);
    assert.deepEqual(evolved, { finding, ...furthest[i] });
  }

  await page.click('#training-grid .training-name');
  await page.click('#preset-velocity-limits');
  assert.equal((await evolveAgain(page, finding)).rows, 'training-grid');
  assert.deepEqual(await page.problems(), []);
});

/** Evolves all while something else is done, and says who drives then. @param {Page} page @param {() => Promise<unknown>} act */
async function evolveWhile(page, act) {
  const hasName = (/** @type {string} */ name) =>
    page.until(name, (wanted) => document.getElementById('training-evolve')?.innerText === wanted, name);
  await delayWorkers(page);
  await page.click('#training-evolve');
  await hasName('Cancel');
  await act();
  await releaseWorkers(page);
  await hasName('Evolve again');
  return page.evaluate(() => {
    const inputs = /** @type {NodeListOf<HTMLInputElement>} */ (
      document.querySelectorAll('#drives input:checked, #gain-kx, #gain-ky, #gain-ktheta')
    );
    const [driver, ...gains] = [...inputs].map(({ value }) => value);
    const rows = [...document.querySelectorAll('#training-table .chosen')].map(({ id }) => id);
    return { driver, gains: gains.map(Number), rows: String(rows) };
  });
}

pageTest('who comes to drive while all evolve goes on driving, but for a row of the table', async (page) => {
  await page.open(`#${link}`);
  const other = await evolveWhile(page, () => follow(page, link.replace(/seed=\d/, 'seed=7')));
  assert.equal(other.driver, 'evolved');
  const linked = await evolveWhile(page, () => follow(page, `${link}&drives=hand&gains=2,3,4`));
  assert.deepEqual(linked, { driver: 'hand', gains: [2, 3, 4], rows: 'training-hand' });

  await page.click('#training-circle .training-name');
  const slid = await evolveWhile(page, async () => {
    await page.click('#page-lab');
    await page.focus('#slider-ky');
    await page.press(Key.HOME);
    await page.click('#page-training');
  });
  assert.deepEqual([slid.gains[1], slid.rows], [-2, 'training-hand']);

  await page.click('#training-circle .training-name');
  await page.click('#preset-acceleration-limits');
  const picked = await evolveWhile(page, () => page.click('#training-grid .training-name'));
  assert.equal(picked.rows, 'training-grid');
  assert.deepEqual(await page.problems(), []);
});

pageTest('both costs stand in their columns, however many digits they have', async (page) => {
  for (const link of [
    'weights.velocity=100000,1000',
    'goal.x=-150&goal.y=-150',
    'goal.x=900&goal.y=900&lang=ko',
  ]) {
    await page.open(`#training&v=1&${link}`);
    await page.until('the paper’s gains have driven', () =>
      /\d{4}|×/.test(document.querySelector('#training-paper-ep .training-own')?.textContent ?? ''),
    );
    for (const width of [320, 390, 430, 1440]) {
      await page.resize(width, 844);
      const found = await page.evaluate(() => {
        const wide = [...document.querySelectorAll('#training-table :is(thead th, td)')].filter(
          (cell) => cell.scrollWidth > cell.clientWidth,
        );
        const { scrollWidth, clientWidth } = document.documentElement;
        return { wide: wide.map(({ textContent }) => textContent), beyond: scrollWidth - clientWidth };
      });
      assert.deepEqual(found, { wide: [], beyond: 0 }, `${link}, ${width}`);
    }
  }
});
