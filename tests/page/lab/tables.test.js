import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment, robustness, shown, simulate } from '../harness/core.js';
import { readTable } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');

pageTest('the fitness curve can be read as a table', async (page) => {
  for (let i = 0; i < 3; i += 1) await page.click('#one-generation');
  const [head, ...rows] = await readTable(page, 'fitness-table');
  assert.deepEqual(head.slice(0, 3), ['generation', 'drives', 'best J']);
  const evolution = new Evolution(velocityLimits);
  for (const row of rows) {
    const { generation, evaluations, best, median, worst } = evolution.statistics();
    assert.deepEqual(row.slice(0, 4), [generation, evaluations, shown(best.cost), shown(median)].map(String));
    assert.equal(Number(row[4]).toFixed(1), worst.toFixed(1));
    evolution.step();
  }
  assert.equal(rows.length, 4);
});

pageTest('a long table is read fifty rows at a time', async (page) => {
  await page.open('#lab&v=1&generation=130');
  await page.click('#fitness-table');
  const shown = () =>
    page.evaluate(() => {
      const { rows } = /** @type {HTMLTableElement} */ (document.getElementById('table-rows'));
      const isOff = (/** @type {string} */ id) => document.getElementById(id)?.ariaDisabled === 'true';
      return {
        names: [rows[1], rows[rows.length - 1]].map((row) => row.cells[0].innerText),
        said: /** @type {HTMLElement} */ (document.querySelector('#table [role="status"]')).innerText,
        off: [isOff('table-before'), isOff('table-after')],
      };
    });
  const first = { names: ['0', '49'], said: 'Rows 1 to 50 of 131', off: [true, false] };
  assert.deepEqual(await shown(), first);
  await page.click('#table-after');
  assert.deepEqual(await shown(), {
    names: ['50', '99'],
    said: 'Rows 51 to 100 of 131',
    off: [false, false],
  });
  await page.click('#table-after');
  assert.deepEqual(await shown(), {
    names: ['100', '130'],
    said: 'Rows 101 to 131 of 131',
    off: [false, true],
  });
  await page.click('#table-before');
  await page.click('#table-before');
  assert.deepEqual(await shown(), first);
  assert.deepEqual(await page.obstacles('#table'), []);
});

pageTest('the landscape can be read as a table', async (page) => {
  await page.open('#landscape&v=1&drives=paper-ep&third=0.1');
  await page.until('the fine landscape is there', () =>
    document.getElementById('landscape-note')?.textContent?.replace(/\s/g, '').startsWith('16384drives'),
  );
  const [head, ...rows] = await readTable(page, 'landscape-table');
  assert.deepEqual([head.length, rows.length], [14, 13]);
  assert.deepEqual([head[13], rows[0][0], rows[12][0]], ['12', '12', '0']);
  const corner = simulate(velocityLimits, [12, 0.1, 12]);
  assert.equal(rows[0][13], shown(corner.cost.total));
});

pageTest('the robustness map can be read as a table', async (page) => {
  await page.open('#robustness&v=1&drives=paper-ep');
  await page.until('the fine map is there', () =>
    document.getElementById('robustness-note')?.textContent?.replace(/\s/g, '').startsWith('118098'),
  );
  const [head, ...rows] = await readTable(page, 'robustness-table');
  assert.deepEqual([head.length, rows.length], [14, 13]);
  const edge = (/** @type {number} */ middle) => ({ from: middle - 4, to: middle + 4, count: 81 });
  const gains = [3.23673, 0.09678, 5.17891];
  const { arrived } = robustness(velocityLimits, {
    gains,
    x: edge(2),
    y: edge(2),
    headings: 18,
    part: [0, 18],
  });
  const first = arrived.reduce((sum, one) => sum + one, 0);
  assert.equal(rows[12][1], String(first));
  assert.deepEqual([rows[12][0], head[1]], ['−2.00', '−2.00']);
});

pageTest('a table can be read where all is four times as large', async (page) => {
  await page.resize(320, 256);
  for (const [link, button, told] of [
    ['#lab&v=1&generation=60', 'fitness-table', 'generation'],
    ['#landscape', 'landscape-table', 'landscape-lowest'],
  ]) {
    await page.open(link);
    await page.until('there is something to read', (id) => document.getElementById(id)?.textContent, told);
    await page.click(`#${button}`);
    await page.until('the table is there', () => document.querySelector('dialog[open] tbody tr'));
    const seen = await page.evaluate(() => {
      const rows = /** @type {HTMLTableElement} */ (document.getElementById('table-rows')).rows;
      const sheet = /** @type {Element} */ (document.querySelector('dialog[open]'));
      const row = rows[2];
      row.scrollIntoView({ block: 'center' });
      const { top, bottom } = row.getBoundingClientRect();
      const box = sheet.getBoundingClientRect();
      const middle = document.elementFromPoint(box.left + box.width / 2, (top + bottom) / 2);
      return top >= box.top && bottom <= box.bottom && row.contains(middle);
    });
    assert.ok(seen, link);
  }
});
