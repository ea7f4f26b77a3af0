// A contest as Node has it, and how the page's is run and read.
import assert from 'node:assert/strict';
import { trials } from '../../../pkg/ep_locomotion.js';
import { entered } from '../../../www/parts/luck/contestants.js';
import { standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { experiment } from '../harness/core.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/parts/luck/contestants.js').Contestant} Contestant */
/** @typedef {import('../../../www/parts/luck/contest-request.js').Contest} Contest */

export const velocityLimits = experiment('velocity-limits');

/** The same contest in Node. @param {readonly Contestant[]} others @param {number} seeds @param {number} budget @returns {Contest} */
export const contestOf = (others, seeds, budget) => ({
  experiment: velocityLimits,
  seeds,
  budget,
  lines: [null, ...others].map((name) => ({
    name,
    trials: trials(entered(velocityLimits, name), { seeds: [1, 1 + seeds], drives: budget }),
    error: '',
  })),
  cancelled: false,
});
/** @type {Contestant[]} */
export const others = ['truncation', 'fixed', 'de'];
export const small = contestOf(others, 15, 1000);

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

/** @param {Contest} contest @param {number | null} target */
export const expectedTable = (contest, target) =>
  standingsOf(contest, { target }).lines.map(
    ({ name, reached, count, ert, interval, median, comparison }) => ({
      name: name ?? 'lab',
      cells: [
        `${reached} of ${count}`,
        ert === Infinity
          ? '∞'
          : `${Math.round(ert)} ${interval.map((end) => (end === Infinity ? '∞' : Math.round(end))).join('–')}`,
        median.toFixed(4),
        comparison?.a12.toFixed(2) ?? '',
        comparison ? (comparison.p < 0.001 ? '< 0.001' : comparison.p.toFixed(3)) : '',
      ],
    }),
  );

export const withoutVerdict = (/** @type {Awaited<ReturnType<typeof readTable>>} */ table) =>
  table.map(({ name, cells }) => ({ name, cells }));
