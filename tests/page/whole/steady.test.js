// What is pressed does not move what stands beside it, and what stands in a field is seen whole.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { holdWorkers } from '../harness/workers.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {string} selector */
const lefts = (page, selector) =>
  page.evaluate(
    (all) => [...document.querySelectorAll(all)].map((one) => one.getBoundingClientRect().left),
    selector,
  );

pageTest(
  'what stands beside a button stays where it is while the button is one that cancels',
  async (page) => {
    for (const [link, button, beside] of [
      ['luck', '#luck-run', '.luck-bar select'],
      ['luck&v=1&luck=contest&seeds=15', '#contest-run', '.contest-bar select'],
      ['training', '#training-evolve', '#training-generations, #training-seeds'],
    ]) {
      await page.open(`#${link}`);
      await holdWorkers(page);
      const before = await lefts(page, beside);
      assert.ok(before.length >= 2, link);
      await page.click(button);
      await page.until('it cancels', (id) => document.querySelector(id)?.textContent === 'Cancel', button);
      assert.deepEqual(await lefts(page, beside), before, link);
    }
  },
);

pageTest('the parts’ names stay where they are, whichever is open', async (page) => {
  await page.resize(1366, 768);
  await page.open('#lab');
  const names = '.pages a';
  const before = await lefts(page, names);
  assert.ok(before.length > 5);
  for (const part of ['luck', 'robustness', 'lab']) {
    await page.click(`#page-${part}`);
    assert.deepEqual(await lefts(page, names), before, part);
  }
});

pageTest('J or σ stay where they are pressed while the generation gets its second digit', async (page) => {
  await page.open('#lab&v=1&generation=9');
  const choice = '#curve-choice label';
  const before = await lefts(page, choice);
  assert.equal(before.length, 2);
  await page.click('#one-generation');
  await page.until('generation 10', () => document.getElementById('generation')?.textContent === '10');
  for (const [i, left] of (await lefts(page, choice)).entries())
    assert.ok(Math.abs(left - before[i]) < 0.5, `${before[i]} → ${left}`);
});

pageTest('a gain of six digits is seen whole, in every row of gains', async (page) => {
  await page.resize(1366, 768);
  for (const link of ['lab&v=1', 'curves&v=1', 'lesson&step=law']) {
    await page.open(`#${link}&drives=hand&gains=123.456,10,-100.5`);
    const fields = await page.evaluate(() =>
      [...document.querySelectorAll('#gains input[type="text"]')]
        .filter((field) => field.checkVisibility())
        .map(({ scrollWidth, clientWidth }) => scrollWidth > clientWidth),
    );
    assert.deepEqual(fields, [false, false, false], link);
  }
});
