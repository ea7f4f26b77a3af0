// σ is shown of the methods that have it, and of no other.
import assert from 'node:assert/strict';
import { hasSigmas } from '../../../www/core/methods.js';
import { fitnessTable } from '../../../www/lab/fitness-table.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { generationTable } from '../../../www/parts/generation/table.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment, historyOf, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment['evolution']['method']} Method */

const base = experiment('velocity-limits');
const methods = /** @type {readonly Method[]} */ (
  wordFields().find(({ path }) => path === 'evolution.method')?.words
);
/** @param {Method} method */
const by = (method) => ({ ...base, evolution: { ...base.evolution, method } });

test('a method has σ just where the core’s σ is a step, which changes', () => {
  for (const method of methods) {
    const seen = new Set(historyOf(by(method), 20).flatMap(({ meanSigmas }) => meanSigmas));
    assert.equal(hasSigmas(method), seen.size > 1, method);
  }
});

test('where a method has no σ its cells are empty in both tables, and no others', () => {
  for (const method of methods) {
    const evolution = new Evolution(by(method));
    const history = [evolution.statistics(), evolution.step(), evolution.step()];
    const anatomy = dissect(evolution.record(2), by(method).evolution);
    for (const [table, from] of /** @type {const} */ ([
      [fitnessTable({ history, experiment: by(method) }), 5],
      [generationTable(anatomy), 7],
    ])) {
      const row = table.rowOf(1);
      assert.equal(row.length, table.columns.length);
      assert.ok(table.columns.slice(from, from + 3).every((name) => /σ/.test(String(name))));
      for (const text of row.slice(from, from + 3)) assert.equal(text !== '', hasSigmas(method), method);
      for (const text of row.slice(0, 3)) assert.notEqual(text, '');
    }
  }
});

test('in the fitness table the points of σ stand under each other, and what is small has its power of ten', () => {
  const history = historyOf(base, 200);
  const { rowOf } = fitnessTable({ history, experiment: base });
  const texts = history.flatMap((_, row) => rowOf(row).slice(5));
  for (const text of texts) assert.match(String(text), /^\d+\.\d{3}$|^\d(\.\d+)?×10⁻/);
  assert.equal(texts[0], '1.000');
  assert.ok(texts.some((text) => /⁻/.test(String(text))));
});

pageTest('where a method has no σ the choice is gone, and a link that asks for it opens', async (page) => {
  const shown = () =>
    page.evaluate(() =>
      ['curve', 'sigmas', 'curve-choice'].map((id) => document.getElementById(id)?.checkVisibility()),
    );
  for (const method of ['nelder-mead', 'cma-es']) {
    const isOf = method === 'cma-es';
    await page.open(`#lab&v=1&evolution.method=${method}&generation=4&curve=sigmas`);
    await page.until('it is there', () => document.getElementById('generation')?.textContent === '4');
    assert.deepEqual(await shown(), [!isOf, isOf, isOf], method);
    assert.deepEqual(await page.problems(), []);
    assert.equal(await page.evaluate(() => document.getElementById('message')?.hidden), true);
    assert.match(await page.evaluate(() => location.hash), /curve=sigmas/);
  }
});
