// What somebody may hand in to harm the others: what would hold the page, and formulas.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { csvOf } from '../../../www/share/collect/table.js';
import { mark } from '../../../www/share/handin/mark.js';
import { test } from '../harness/once.js';
import { engine, handedIn, site } from './hand-ins.js';

const reader = createReader(links.pages);

test('what was made to hold the page is a row as others are', async () => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  // Whatever looks twice at such a text looks for minutes.
  const full = (/** @type {string} */ one) => one.repeat(190_000 / one.length);
  for (const [text, links] of /** @type {[string, (string | null)[]][]} */ ([
    [`lab&a=${full('handin=')}`, [null]],
    [`${mark}\n${full('handin=~')}\n${link}`, [link]],
    [`${mark}<p>${link} lab&v=1 <a ${full("href='x' ")}`, [link]],
    [`${full(', ')}x ${site}#${link}`, [link]],
    // Nor is it a thing of an engine's stack.
    [`${site}#lab&v=1&seed=${full('!')}a`, [null]],
    [`${site}#lab&v=1&seed=7${full('!')}`, ['lab&v=1&seed=7']],
    ...[' ', '\t', '\r', ' \t'].map((blank) => [
      `Name,Text\nKim,"${full('x"')}${full(blank)},\nLee,"${link}"`,
      [null, link],
    ]),
  ]))
    assert.deepEqual(
      (await reader.read(text)).map((entry) => entry.link),
      links,
    );
});

test('however much white space stands in a table, its rows and columns stay', async () => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const [tabs, blanks] = ['\t', ' '].map((one) => one.repeat(150));
  for (const end of ['\n', '\r\n', '\r']) {
    const rows = ['ID\tName\tText', `7\tKim\t${link}${tabs}`, tabs, `\t${blanks}\t${link}`, `\tLee\t${link}`];
    for (const between of [end, end.repeat(300)])
      assert.deepEqual(
        (await reader.read(rows.join(between))).map((entry) => [entry.name, entry.ident, entry.link]),
        [
          ['Kim', { ID: '7' }, link],
          ['', { ID: '' }, link],
          ['Lee', { ID: '' }, link],
        ],
      );
  }
});

test('no cell is a formula, also for who divides at semicolons, tabs or line ends; numbers stay, and links say the same', async () => {
  const harmful = /^[\s"]*(?:[=+@＝＋－＠]|-(?!\d+(?:\.\d+)?(?:e-\d+)?(?:,|$)))/;
  const texts = [
    'x;=1',
    'x; -1',
    'x\t@A1',
    'x\n-1+1',
    'x\r\n=1',
    'x;"=1"',
    '＝1',
    '＋1',
    'x;－1',
    '＠1',
    '\t=1',
    '-2.5+1',
  ];
  const kept = ['-2.5', 'a-b', '1+1', 'x;y', 'Jo-Ann <a@b.org>', 'x "=1"', '-1e-7'];
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const linked = link.split('&handin=')[0].replace('task=', 'task=;=1;-');
  const checked = /** @type {any} */ ({ gains: [-1, 0, 4.5], cost: 7, worth: 'holds', differs: [], own: 7 });
  const rows = [...texts, ...kept].map((cell) => ({
    entry: { name: cell, ident: { [`${cell} `]: cell }, text: '', link: linked, why: null, isReceipt: true },
    checked: { ...checked, who: cell, answers: cell },
    problem: /** @type {const} */ (''),
    same: [],
  }));
  const file = csvOf(rows, site).replace('\ufeff', '');
  for (const delimiter of [',', ';', '\t']) {
    // As a program that knows no quotes has them, and one that does.
    const cells = [Papa.parse(file, { delimiter }).data.flat(), file.split(new RegExp(`[\r\n${delimiter}]`))];
    for (const cell of cells.flat()) assert.doesNotMatch(String(cell).replace(/^"+/, ''), harmful);
  }
  const lines = /** @type {string[][]} */ (Papa.parse(file.trim()).data);
  assert.deepEqual(
    lines.slice(1 + texts.length).map(([name]) => name),
    kept,
  );
  assert.deepEqual(
    lines.slice(1).map((cells) => cells[lines[0].indexOf('kx')]),
    rows.map(() => '-1'),
  );
  const told = String(lines[1].at(-1)).split('#')[1];
  assert.deepEqual(links.openLink(told, engine), links.openLink(linked, engine));
});
