// The panel in which an exercise is made, as a lecturer opens it.

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {string} [fragment] */
export async function openMaker(page, fragment = '#lab&v=1') {
  await page.open(fragment);
  await page.click('#keep-button');
  await page.until('Share is there', () => document.getElementById('keep-exercise'));
  await page.click('#keep-exercise');
  await page.until('the maker is open', () => document.getElementById('maker-task')?.checkVisibility());
}
