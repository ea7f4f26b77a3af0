// What somebody may hand in to harm the others: what would hold the page, formulas, an
// exercise of one's own, and what nobody sees.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { readAll } from '../../../www/share/collect/files.js';
import { csvOf, remarksOf } from '../../../www/share/collect/table.js';
import { mark } from '../../../www/share/handin/mark.js';
import { test } from '../harness/once.js';
import { engine, exercise, handedIn, site } from './hand-ins.js';

const reader = createReader(links.pages);
const checker = createChecker(engine, links);

/** @param {Record<string, string>} files Their texts. */
async function check(files) {
  const all = Object.entries(files).map(([name, text]) => new File([text], name));
  const never = { signal: new AbortController().signal, onProgress: () => {} };
  return checker.check(await readAll(all, reader), null, never);
}

test('what was made to hold the page is a row as others are', async () => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  // Whatever looks twice at such a text looks for minutes.
  const full = (/** @type {string} */ one) => one.repeat(190_000 / one.length);
  for (const [text, links] of /** @type {[string, (string | null)[]][]} */ ([
    [`lab&a=${full('handin=')}`, [null]],
    [`${mark}\n${full('handin=~')}\n${link}`, [link]],
    [`${mark}<p>${link} lab&v=1 <a ${full("href='x' ")}`, [link]],
    [`${full(', ')}x ${site}#${link}`, [link]],
    // Of these numbers no letter has one.
    [`&#9999999;&#xffffff;&#0; ${link}`, [link]],
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
    entry: {
      name: cell,
      ident: { [`${cell} `]: cell },
      text: '',
      link: linked,
      why: null,
      isReceipt: true,
      isOnes: false,
    },
    checked: { ...checked, who: cell, answers: cell },
    problem: /** @type {const} */ (''),
    same: [],
    ones: [],
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

test('by whose exercise a class is judged: each counts once, what was cut does not, and the same digits are not the same exercise', async () => {
  const easy = exercise.replace('J%3C7.9', 'J%3C90').replace('points=9:0,7.75:10', 'points=91:0,90:10');
  const [kim, lee] = await Promise.all([handedIn('kim', [3.3, 0, 4.5]), handedIn('lee', [3, 0.1, 6])]);
  const eves = await Promise.all([1, 2, 3].map((i) => handedIn(`eve ${i}`, [i, 0, 1], easy)));
  const cut = eves.map(({ text }) => text.slice(0, -3));
  const twin = await handedIn('eve', [1, 0, 1], easy.replace('less.', 'less.%20Good%20luck%20hMxiyca'));
  assert.equal(twin.exercise, kim.exercise);
  const others = { 'kim_3_4_hand.txt': kim.text, 'lee_5_6_hand.txt': lee.text };
  const { given: own } = await check(others);
  /** @type {[string, string[]][]} */
  const harms = [
    ['several of one', eves.map(({ text }) => text)],
    ['cut', cut],
    ['the same digits', [twin.text]],
  ];
  for (const [harm, texts] of harms) {
    const { given, rows } = await check({ 'aeve_1_2_hand.txt': texts.join('\n\n'), ...others });
    assert.equal(given?.link, own?.link, harm);
    assert.deepEqual(
      rows.slice(-2).map((row) => [row.checked?.judged?.isMet, row.checked?.differs]),
      [
        [true, []],
        [false, []],
      ],
    );
  }
  // What only stands before each is nobody's name.
  const listed = [kim, lee, eves[0]].map(({ link }) => `Answer: ${site}#${link}`);
  assert.equal((await check({ 'list.txt': listed.join('\n') })).given?.link, own?.link);
  // There each counts once by what it says itself.
  const again = await Promise.all([1, 2, 3].map((i) => handedIn('eve', [i, 0, 1], easy)));
  const thrice = [kim, lee, ...again].map(({ link }) => `${site}#${link}`);
  assert.equal((await check({ 'list.txt': thrice.join('\n') })).given?.link, own?.link);
  // What else stands in a row is no name either.
  const table = ['Section,Link', ...[kim, lee, eves[0]].map(({ link }) => `A,"${site}#${link}"`)];
  assert.equal((await check({ 'list.csv': table.join('\n') })).given?.link, own?.link);
  const many = Object.fromEntries(cut.map((text, i) => [`${'abc'[i]}eve_${i}_7_x.txt`, text]));
  assert.equal((await check({ ...many, ...others })).given?.link, own?.link);
  // Where all are cut it is theirs.
  assert.match((await check(many)).given?.link ?? '', /J%3C90/);
});

test('a name in which nobody sees all is remarked, and one of which nobody sees anything is none', async () => {
  const vary = `${exercise}&vary=goal`;
  const files = await Promise.all(
    ['s4711', 's47\u206311', '\u3164\u200b'].map((who) => handedIn(who, [3.3, 0, 4.5], vary)),
  );
  const { rows } = await check(Object.fromEntries(files.map(({ text }, i) => [`${i}.txt`, text])));
  const remarks = rows.map((row) => remarksOf(row, rows).join('; '));
  assert.deepEqual(
    remarks.map((text) => [/holds characters that nobody sees/.test(text), /has no name/.test(text)]),
    [
      [false, false],
      [true, false],
      [false, true],
    ],
  );
});

test('what a refusal quotes does not turn the rest of it around', () => {
  for (const link of [
    'lab&x%E2%80%AEfoo=1',
    'lab&seed=%E2%80%AE7',
    'p%E2%80%AEark',
    'lab&lesson=%E2%80%AEx',
  ]) {
    const { problems } = links.openLink(link, engine);
    assert.equal(problems.length, 1);
    assert.doesNotMatch(problems[0], /\u202e/, link);
  }
});
