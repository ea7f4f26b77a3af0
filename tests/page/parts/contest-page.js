// The contest on the page: how it is opened, run and read.
import assert from 'node:assert/strict';

/** @typedef {import('../harness/browsers.js').Page} Page */

export const link = '#luck&v=1&luck=contest&seeds=15&budget=1000';

/** @param {Page} page @param {string} address */
export async function openContest(page, address) {
  await page.open(address);
  await page.until('the contest is there', () => {
    const run = document.getElementById('contest-run');
    return run !== null && run.getBoundingClientRect().width > 0;
  });
}

/** @param {Page} page */
export async function runContest(page) {
  await page.until('it can run', () => document.getElementById('contest-run'));
  const text = await page.text('#contest-run');
  await page.click('#contest-run');
  await page.until(
    'it has run',
    (ready) =>
      document.getElementById('contest-csv')?.hidden === false &&
      document.getElementById('contest-run')?.textContent === ready,
    text,
  );
  // Nobody has pressed again.
  assert.doesNotMatch(await page.text('#contest-status'), /Cancelled|취소/);
}

/** The cells of the table; thin spaces are none. @param {Page} page */
export const readTable = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#contest-table tbody')].map((body) => ({
      name: /** @type {HTMLElement} */ (body).dataset.contestant,
      cells: [...body.querySelectorAll('tr:first-child td')].map((cell) =>
        (cell.textContent ?? '').replaceAll('\u202f', ''),
      ),
      verdict: body.querySelector('.verdict')?.textContent ?? '',
    })),
  );

export const withoutVerdict = (/** @type {Awaited<ReturnType<typeof readTable>>} */ table) =>
  table.map(({ name, cells }) => ({ name, cells }));
