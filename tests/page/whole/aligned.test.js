// What belongs to one line stands in it, and what does not touch is apart.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { surround } from './surround.js';

/** @typedef {'left' | 'right' | 'top' | 'bottom' | 'middle'} Edge */
/** @typedef {import('./surround.js').Size} Size */
/** @typedef {{ link: string, edge: Edge, of: readonly [string, string], sizes?: readonly Size[], press?: readonly string[], words?: boolean }} Line Of two elements, or of their words. */

/** @type {readonly Size[]} */
const screens = [
  [1440, 900],
  [1024, 768],
];
/** @type {readonly Size[]} */
const telephone = [[390, 844]];

/** @type {readonly Line[]} */
const lines = [
  ...['curves&v=1', 'disturbance&v=1', 'disturbance&v=1&lang=ko'].map(
    (link) => /** @type {const} */ ({ link, edge: 'bottom', of: ['#drives', '#play'], sizes: screens }),
  ),
  { link: 'curves&v=1', edge: 'middle', of: ['.curves h2', '#curves-view'] },
  ...['luck&v=1', 'luck&v=1&luck=contest'].map(
    (link) => /** @type {const} */ ({ link, edge: 'middle', of: ['.luck-sight h2', '#luck-view'] }),
  ),
  { link: 'lab&v=1', edge: 'right', of: ['#settings-close', '#settings'], press: ['#settings-button'] },
  {
    link: 'lab&v=1',
    edge: 'right',
    of: ['#maker-close', '#maker'],
    press: ['#keep-button', '#keep-exercise'],
  },
  { link: 'lesson&step=drive', edge: 'left', of: ['.quiz legend', '.choices'], words: true },
  {
    link: 'lesson&step=cost',
    edge: 'top',
    of: ['.standing:nth-child(1) .standing-name', '.standing:nth-child(2) .standing-name'],
    sizes: telephone,
  },
  {
    link: 'curves&v=1&view=numbers&generation=2',
    edge: 'right',
    of: ['.curves-table caption', '.curves-scroll'],
    sizes: telephone,
  },
];

/** In the page: where this edge is of what is seen of these. @param {Edge} edge @param {readonly string[]} selectors @param {boolean} words */
function edgesOf(edge, selectors, words) {
  return selectors.map((selector) => {
    const seen = [...document.querySelectorAll(selector)].find((one) => one.checkVisibility());
    if (!seen) return null;
    const range = document.createRange();
    range.selectNodeContents(seen);
    const box = (words ? range : seen).getBoundingClientRect();
    return edge === 'middle' ? (box.top + box.bottom) / 2 : box[edge];
  });
}

pageTest('what belongs to one line stands in it', async (page) => {
  if (page.engine !== 'chromium') return;
  /** @type {string[]} */
  const found = [];
  for (const { link, edge, of, sizes = [screens[0]], press = [], words = false } of lines)
    for (const size of sizes) {
      await surround(page, size);
      await page.open(`#${link}`);
      for (const button of press) await page.click(button);
      const where = `${link}, ${size.join(' × ')}: ${edge} of ${of.join(' and ')}`;
      await page.until(
        `all is there: ${where}`,
        (...all) =>
          all.every((one) =>
            [...document.querySelectorAll(one)].some((element) => element.checkVisibility()),
          ),
        ...of,
      );
      await page.evaluate(() => pageFrames.settled());
      const [a, b] = await page.evaluate(edgesOf, edge, of, words);
      if (a === null || b === null || Math.abs(a - b) > 0.6) found.push(`${where}: ${a} and ${b}`);
    }
  assert.equal(found.join('\n'), '');
});

pageTest('the points of the paper’s numbers, and of ours, stand under each other', async (page) => {
  await page.open('#lesson&step=paper');
  const points = await page.until('all numbers are there', () => {
    const table = document.querySelector('#paper-table table');
    if (!table || table.textContent?.includes('…')) return null;
    return [3, 4].map((column) =>
      [...table.querySelectorAll(`td:nth-child(${column})`)].flatMap(({ firstChild }) => {
        const at = firstChild?.textContent?.indexOf('.') ?? -1;
        if (!firstChild || at < 0) return [];
        const range = document.createRange();
        range.setStart(firstChild, at);
        range.setEnd(firstChild, at + 1);
        return range.getBoundingClientRect().left;
      }),
    );
  });
  assert.deepEqual(
    points.map(({ length }) => length),
    [4, 6],
  );
  for (const column of points) assert.ok(Math.max(...column) - Math.min(...column) < 1, String(column));
});

pageTest('what there is to press of an exercise stands apart from what is said above it', async (page) => {
  await page.open('#lab&v=1&lock=gains,clock&hide=paper,settings&task=Park.');
  const [said, pressed] = await page.until('its work is there', () => {
    const all = ['exercise-locks', 'hand-in'].map((id) => document.getElementById(id));
    return all.every((one) => one) && all.map((one) => one?.getBoundingClientRect());
  });
  assert.ok(said && pressed && pressed.top - said.bottom >= 4, `${said?.bottom} and ${pressed?.top}`);
});
