// The sheet on which hand-ins are checked, worked from a test.
import { exercise } from './hand-ins.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {string} [link] */
export async function openSheet(page, link = exercise) {
  await page.open(`#${link}`);
  await openCollect(page);
}

/** @param {Page} page With a page that is ready. */
export async function openCollect(page) {
  await page.click('#keep-button');
  await page.until('Share is there', () => document.getElementById('keep-collect'));
  await page.click('#keep-collect');
  await page.until('the sheet is there', () => document.getElementById('collect-text'));
}

/** @param {Page} page @param {string} text */
export const paste = (page, text) =>
  page.evaluate((value) => {
    /** @type {HTMLTextAreaElement} */ (document.getElementById('collect-text')).value = value;
  }, text);

/** What stands in the table, row by row. @param {Page} page */
export const cells = (page) =>
  page.evaluate(() =>
    [...document.querySelectorAll('#collect tbody tr')].map((row) =>
      [...row.children].map((cell) => cell.textContent),
    ),
  );

/** @param {Page} page @param {number} count */
export const checked = (page, count) =>
  page.until(
    'all are checked',
    (most) =>
      document.querySelectorAll('#collect tbody tr').length === Math.min(100, most) &&
      document.getElementById('collect-progress')?.hidden,
    count,
  );

/** @param {Page} page @param {RegExp} what */
export const stripSays = (page, what) =>
  page.until(
    `whose run it is: ${what}`,
    (source) => {
      const strip = document.getElementById('collect-strip');
      return strip?.hidden === false && new RegExp(source).test(strip.innerText.replace(/\s+/g, ' '));
    },
    what.source,
  );
