// What is pressed does not move what stands beside it, and what stands in a field is seen whole.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
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

/** Where they are within the page. @param {Page} page @param {string} selector */
const placesOf = (page, selector) =>
  page.evaluate(async (all) => {
    await pageFrames.settled();
    return [...document.querySelectorAll(all)]
      .filter((one) => one.checkVisibility())
      .map((one) => one.getBoundingClientRect())
      .map(({ left, top }) => [left + scrollX, top + scrollY]);
  }, selector);

/** @param {readonly number[][]} now @param {readonly number[][]} before @param {string} when */
function assertSame(now, before, when) {
  assert.ok(before.length > 0, when);
  assert.equal(now.length, before.length, when);
  for (const [i, place] of now.entries())
    for (const [j, at] of place.entries())
      assert.ok(Math.abs(at - before[i][j]) < 0.5, `${when}: ${before[i]} → ${place}`);
}

pageTest('who drives is chosen anew at the same place, whatever opens above it', async (page) => {
  const choices = '#drives label';
  for (const link of ['lab', 'curves', 'landscape', 'robustness', 'disturbance&under=random,0.1,0.1,7']) {
    await page.open(`#${link}&v=1&generation=2`);
    await page.click('#drives-evolved');
    for (const [width, height] of /** @type {const} */ ([
      [1440, 900],
      [1024, 768],
    ])) {
      await page.resize(width, height);
      const before = await placesOf(page, choices);
      for (const driver of ['hand', 'paper-ep', 'paper-arbitrary', 'evolved']) {
        await page.click(`#drives-${driver}`);
        assertSame(await placesOf(page, choices), before, `${link}, ${width}, ${driver}`);
      }
    }
  }
});

pageTest('the keys go from the gains to who drives as they are seen', async (page) => {
  // Other engines do not know the property yet: there they go as the document has them.
  if (page.engine !== 'chromium') return;
  await page.resize(1440, 900);
  await page.open('#curves&v=1&generation=2&drives=hand&gains=5,1,5');
  await page.focus('#gain-ktheta');
  await page.press(Key.TAB);
  assert.equal(await page.evaluate(() => document.activeElement?.id), 'drives-hand');
});

pageTest('beside a map what is pressed stays where it is, whoever drives', async (page) => {
  await page.resize(1440, 900);
  for (const [part, pressed] of [
    ['landscape', '#run, .axes select, #landscape-table'],
    ['robustness', '.survey-bar label, #robustness-table'],
  ]) {
    await page.open(`#${part}&v=1&generation=2&drives=evolved`);
    const before = await placesOf(page, pressed);
    for (const driver of ['paper-ep', 'paper-arbitrary', 'hand']) {
      await page.click(`#drives-${driver}`);
      assertSame(await placesOf(page, pressed), before, `${part}, ${driver}`);
    }
  }
});

pageTest('through a generation one goes forth and back at one place, also while it runs', async (page) => {
  await page.resize(1440, 900);
  await page.open('#generation&v=1&generation=3&phase=parents');
  const steps = '#generation-back, #generation-next, #generation-phases label';
  const before = await placesOf(page, steps);
  for (let i = 0; i < 5; i += 1) {
    await page.click('#generation-next');
    assertSame(await placesOf(page, steps), before, `${i + 1} phases further`);
  }
  await page.setPace(0);
  const beside = '#one-back, #one-generation, #timeline';
  const still = await placesOf(page, beside);
  await page.click('#run');
  await page.until('it pauses', () => document.getElementById('run')?.textContent === 'Pause');
  assertSame(await placesOf(page, beside), still, 'while it runs');
});

pageTest('a new seed moves neither the head of the page nor J or σ', async (page) => {
  await page.resize(1440, 900);
  await page.open('#lab&v=1&generation=1');
  const pressed = '#preset label, .tools > *, #curve-choice label';
  const before = await placesOf(page, pressed);
  await page.click('#new-seed');
  await page.until('another seed', () => document.getElementById('seed')?.textContent !== '1');
  assertSame(await placesOf(page, pressed), before, 'new seed');
});

pageTest('what is at the head of every part stays where it is, also where nothing is set', async (page) => {
  for (const [width, height] of /** @type {const} */ ([
    [1440, 900],
    [820, 1180],
    [390, 844],
  ])) {
    await page.resize(width, height);
    await page.open('#park');
    const everywhere = '#keys-button, #keep-button, #language';
    const before = await placesOf(page, everywhere);
    await page.click('#page-lab');
    await page.until('the lab is open', () => document.getElementById('settings-button')?.checkVisibility());
    assertSame(await placesOf(page, everywhere), before, `${width}`);
  }
});
