// What Tab comes to in a formula, and every table, says what it is.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { counted, slide } from '../parts/parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Those in sight, each with its name. @param {Page} page @param {string} selector */
const namesOf = (page, selector) =>
  page.evaluate(
    (all) =>
      [...document.querySelectorAll(all)]
        .filter((element) => element.checkVisibility())
        .map((element) => {
          const ids = element.getAttribute('aria-labelledby')?.split(' ') ?? [];
          const named = ids.map((id) => document.getElementById(id)?.textContent ?? '').join(' ');
          const caption = element instanceof HTMLTableElement ? element.caption?.textContent : '';
          return (element.getAttribute('aria-label') ?? (named || caption || '')).trim();
        }),
    selector,
  );

pageTest('a term of a formula that arrows come to has a name and a role', async (page) => {
  /** @type {Record<string, string[]>} */
  const terms = {
    law: ['kx', 'ky', 'kθ', 'ky', 'kx'],
    cost: ['time', 'final', 'path', 'energy', 'penalty'],
  };
  for (const [step, names] of Object.entries(terms)) {
    await page.open(`#lesson&step=${step}`);
    assert.deepEqual(await namesOf(page, '#lesson mrow[data-term][role="group"]'), names, step);
    await page.focus('#lesson .formula-lines:not(.formula-now)');
    for (let press = 0; press < 4; press += 1) {
      await page.press(Key.ARROW_RIGHT);
      const found = await namesOf(page, '#lesson .formula [data-term][role]:focus');
      assert.ok(found.length === 1 && found[0] !== '', `${step}: ${found}`);
    }
  }
});

pageTest('every table has a name', async (page) => {
  const areNamed = async (/** @type {string} */ where, /** @type {string} */ selector) => {
    await page.until('the table is there', (one) => document.querySelector(one)?.checkVisibility(), selector);
    const names = await namesOf(page, 'table');
    assert.ok(names.length > 0 && names.every((name) => name !== ''), `${where}: ${names}`);
  };
  for (const [link, selector] of [
    ['curves&v=1&view=compare&pin1=a~5,1,5', '#pins-table'],
    ['curves&v=1&view=numbers', '#curves-numbers table'],
    ['disturbance', '#remains'],
    ['lesson&step=paper', '.choices-table'],
    ['lesson&step=build', '#check-values'],
  ]) {
    await page.open(`#${link}`);
    await areNamed(link, selector);
  }
  await page.open('#park');
  await slide(page, 'kx', 4);
  await page.click('#park-evolve');
  await counted(page);
  await areNamed('park', '.park-table');
});
