// What an answer came to where J does not say it: in the receipt, in the table, in the file, and beside the run.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { csvOf, tableOf } from '../../../www/share/collect/table.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { cells, checked, openSheet, paste, stripSays } from './hand-in-sheet.js';
import { engine, exercise, handedIn, site } from './hand-ins.js';

const asking = (/** @type {string} */ aim) => exercise.replace(/&aim=.*/, `&aim=${aim}`);
const parks = asking('parks:28/32&points=0:0,32:20');

test('how much of the aim was reached stands beside whether it is met, but for J, which is there', async () => {
  const checker = createChecker(engine, links);
  for (const [from, said] of /** @type {const} */ ([
    [parks, /^[0-2]?\d of 32$/],
    [asking('unseen:0.999'), /^[\d.]+ %$/],
    [asking('parks:1/1'), /^1 of 1$/],
    [exercise, null],
  ])) {
    const { text } = await handedIn('s1', [3, 0.1, 6], from);
    const [, line] = /^Aim (.*)$/m.exec(text) ?? [];
    const control = new AbortController();
    const { rows } = await checker.check(await createReader(links.pages).read(text), null, {
      signal: control.signal,
      onProgress: () => {},
    });
    const on = { sort: () => {}, open: () => {}, pin: () => {} };
    const row = tableOf(rows, { column: 'number', isDown: false }, () => false, on).rowOf(0);
    const [head, file] = Papa.parse(csvOf(rows, site).trim()).data.map(
      (line) => /** @type {string[]} */ (line),
    );
    const reached = rows[0].checked?.reached ?? '';
    const met = file[head.indexOf('Aim')];
    assert.match(met, /^(?:not )?met$/);
    if (said === null) {
      assert.deepEqual([reached, row[5], head.at(-1)], ['', met, 'Link']);
      assert.match(line, /^not met, [\d.]+ of 10 points$/);
      continue;
    }
    assert.match(reached, said);
    assert.equal(row[5], `${met}, ${reached}`);
    assert.deepEqual([head.slice(-2), file.at(-1)], [['Link', 'Reached'], reached]);
    assert.ok(line === `${met}: ${reached}` || line.startsWith(`${met}: ${reached}, `), line);
  }
});

pageTest(
  'how much of the aim was reached stands beside a run, and the file has the exercise’s name',
  async (page) => {
    const { text, exercise: id } = await handedIn('s1', [3, 0.1, 6], parks);
    await openSheet(page, parks);
    await paste(page, text);
    // Who gave the exercise as a frame has only its line.
    await page.evaluate((line) => {
      /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value = line;
    }, `<iframe src="${site}?embed#${parks}" title="x" width="640" height="420"></iframe>`);
    await page.click('#collect-check');
    await checked(page, 1);
    const [[, , , , , met]] = await cells(page);
    assert.match(String(met), /^not met, \d+ of 32$/);
    const name = await page.evaluate(() => {
      let saved = '';
      const { click } = HTMLAnchorElement.prototype;
      HTMLAnchorElement.prototype.click = function () {
        saved = this.download;
      };
      document.getElementById('collect-csv')?.click();
      HTMLAnchorElement.prototype.click = click;
      return saved;
    });
    assert.equal(name, `hand-ins-${id}.csv`);
    await page.click('[data-open="0"]');
    await stripSays(page, new RegExp(`· aim ${met} · [\\d.]+ points`));
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('the way to a hand-in is in sight on a laptop, however much its row says', async (page) => {
  const [a, b] = await Promise.all([
    handedIn('a rather long name', [3, 0.1, 6], parks),
    handedIn('another long name', [3, 0.1, 6], parks),
  ]);
  await page.resize(1280, 720);
  await openSheet(page, parks);
  const rows = [a, b].map(({ text }, i) => [`Maximilian Mustermann ${i}`, text]);
  await paste(page, Papa.unparse([['Name', 'Text'], ...rows]));
  await page.click('#collect-check');
  await checked(page, 2);
  const isOver = await page.evaluate(() => {
    const scroll = /** @type {Element} */ (document.querySelector('#collect .table-scroll'));
    scroll.scrollTop = 1;
    const inside = scroll.getBoundingClientRect().left + scroll.clientWidth;
    return [...scroll.querySelectorAll('[data-open]')].map((button) => {
      const { left, right, top, bottom } = button.getBoundingClientRect();
      const there = document.elementFromPoint((left + right) / 2, (top + bottom) / 2);
      return right > inside || there !== button;
    });
  });
  assert.deepEqual(isOver, [false, false]);
});
