// In windows that are lower or higher than most, nothing lies on anything, and what is pressed is in sight.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { openContest, runContest } from '../parts/contest-page.js';
import { openMaker } from '../share/making.js';
import { excess } from './surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Where the elements are. @param {Page} page @param {string[]} selectors */
const boxes = (page, ...selectors) =>
  page.evaluate(
    (...all) =>
      all.map((selector) => {
        const { top, bottom, height } = /** @type {Element} */ (
          document.querySelector(selector)
        ).getBoundingClientRect();
        return { top, bottom, height };
      }),
    ...selectors,
  );

pageTest('in a low window the curves end above the gains', async (page) => {
  await page.open('#curves&v=1&generation=12');
  for (const [width, height] of /** @type {const} */ ([
    [1097, 530],
    [1024, 500],
    [1280, 500],
    [1920, 540],
    [1280, 585],
    [1280, 680],
  ])) {
    await page.resize(width, height);
    await excess(page);
    const [curves, gains] = await boxes(page, '#curves-picture', '.driver');
    assert.ok(
      curves.height >= 200 && curves.bottom <= gains.top,
      `${width} × ${height}: ${curves.bottom}, ${gains.top}`,
    );
  }
});

for (const [name, open, foot, last] of /** @type {const} */ ([
  ['exercise', openMaker, '.maker-foot', '.maker .settings-groups > :last-child'],
  ['settings', openSettings, '.settings-help', '#settings .settings-groups > :last-child'],
]))
  pageTest(`in a low window the panel ends with the window: ${name}`, async (page) => {
    await open(page);
    for (const [width, height] of /** @type {const} */ ([
      [1280, 585],
      [1097, 530],
      [1280, 660],
    ])) {
      await page.resize(width, height);
      for (const scrolled of [false, true]) {
        await page.evaluate(
          (by) => {
            scrollTo(0, by ? 9999 : 0);
            for (const list of document.querySelectorAll('.settings-groups')) list.scrollTop = 1e6;
          },
          /** @type {boolean} */ (scrolled),
        );
        await excess(page);
        const [end, row] = await boxes(page, foot, last);
        const where = `${width} × ${height}, scrolled: ${scrolled}`;
        assert.ok(end.bottom <= height && end.top > 100, `${where}: its foot ends at ${end.bottom}`);
        assert.ok(row.bottom <= end.top + 1, `${where}: the last row ends at ${row.bottom}, over ${end.top}`);
      }
    }
  });

/** @param {Page} page */
async function openSettings(page) {
  await page.open('#lab');
  await page.click('#settings-button');
  await page.until('they are open', () => document.querySelector('.settings-help')?.checkVisibility());
}

pageTest('the table of a contest scrolls with the page, or has a shade where it goes on', async (page) => {
  await openContest(page, '#luck&v=1&luck=contest&contestants=de,random&seeds=15&budget=1000');
  await runContest(page);
  await page.resize(1280, 585);
  await excess(page);
  const [within, shades] = await page.evaluate(() => {
    const table = /** @type {Element} */ (document.querySelector('.contest-scroll'));
    return [
      table.scrollHeight - table.clientHeight,
      getComputedStyle(table).backgroundImage.match(/linear-gradient/g)?.length,
    ];
  });
  assert.deepEqual([within, shades], [0, 4]);
  const [chart, table] = await boxes(page, '.contest-chart', '.contest-scroll');
  assert.ok(chart.height >= 120 && chart.bottom <= table.top, `${chart.bottom}, ${table.top}`);
});

pageTest('on a monitor turned on end the controls stay by what they drive', async (page) => {
  for (const [width, height] of /** @type {const} */ ([
    [1080, 1850],
    [1440, 2400],
  ]))
    for (const [link, above, below] of /** @type {const} */ ([
      ['lab', '#curve', '.evolving'],
      ['lesson&step=10', '#landscape-readout', '#run'],
      ['luck', '.luck .picture', '.luck-gains'],
    ])) {
      await page.open(`#${link}`);
      await page.resize(width, height);
      await page.until(`${link} is there`, (selector) => document.querySelector(selector), below);
      await excess(page);
      const [first, then] = await boxes(page, above, below);
      const where = `${link}, ${width} × ${height}`;
      assert.ok(first.height < 1000 && then.bottom < 1500, `${where}: ${first.height}, ${then.bottom}`);
      assert.ok(then.top - first.bottom < 120, `${where}: ${then.top - first.bottom} px between`);
    }
});

pageTest('who drives stands in one row, or two and two', async (page) => {
  await page.open('#lab');
  for (const [width, height] of /** @type {const} */ ([
    [1023, 1000],
    [985, 1000],
    [960, 1000],
    [800, 600],
    [500, 900],
    [470, 900],
    [1024, 768],
  ])) {
    await page.resize(width, height);
    await excess(page);
    const rows = await page.evaluate(() => {
      /** @type {Record<number, number>} */
      const rows = {};
      for (const label of document.querySelectorAll('#drives label')) {
        const top = Math.round(label.getBoundingClientRect().top);
        rows[top] = (rows[top] ?? 0) + 1;
      }
      return Object.values(rows);
    });
    assert.ok(['4', '2,2'].includes(String(rows)), `${width}: ${rows}`);
  }
});

pageTest('on half a screen the corner of the landscape’s table has one line', async (page) => {
  await page.resize(683, 680);
  await page.open('#landscape');
  await page.until('its table', () => document.querySelector('#landscape-table[aria-disabled="false"]'));
  await page.click('#landscape-table');
  await page.until('it is open', () => document.querySelector('.table-sheet[open] thead th'));
  const [corner, next] = await page.evaluate(() =>
    [...document.querySelectorAll('.table-sheet[open] thead th')].slice(0, 2).map((cell) => {
      const range = document.createRange();
      range.selectNodeContents(cell);
      return range.getBoundingClientRect().height;
    }),
  );
  assert.equal(corner, next);
});
