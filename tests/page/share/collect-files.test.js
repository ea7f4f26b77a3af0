// Files of hand-ins: one, a list, a table, in whatever a spreadsheet or a platform saves them.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { readAll } from '../../../www/share/collect/files.js';
import { remarksOf } from '../../../www/share/collect/table.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { cells, checked, openSheet } from './hand-in-sheet.js';
import { exercise, handedIn, site } from './hand-ins.js';

/** What Korean spreadsheets write. @type {Readonly<Record<string, string>>} */
const cp949 = { 김: 'b1e8', 성명: 'bcbab8ed', 학번: 'c7d0b9f8' };

test('a file that holds several is read as what is pasted, and each of them has its own name', async () => {
  const [a, b] = await Promise.all([handedIn('s1', [3.3, 0, 4.5]), handedIn('s2', [3, 0.1, 6])]);
  const bare = a.link.split('&handin=')[0];
  const reader = createReader(links.pages);
  const read = async (/** @type {string} */ text, path = 'links.txt') =>
    (await reader.readFile(path, text)).map(({ name, link }) => [name, link]);
  const both = [a.link, b.link];
  const named = [
    ['Kim', a.link],
    ['Lee', b.link],
  ];
  const table = [
    ['Name', 'Text'],
    ['Kim', a.text],
    ['Lee', b.text],
  ];
  for (const [text, rows] of /** @type {[string, unknown][]} */ ([
    [`Kim, ${site}#${a.link}\nLee, ${site}#${b.link}\n`, named],
    [`Kim, ${site}#${a.link}\r\nLee, ${site}#${bare}`, [named[0], ['Lee', bare]]],
    [
      `Kim, ${site}#${bare}\nLee, ${site}#${bare}`,
      [
        ['Kim', bare],
        ['Lee', bare],
      ],
    ],
    [`<p>Kim <a href="${site}#${a.link}">mine</a></p><p>Lee ${site}#${b.link}</p>`, named],
    [Papa.unparse(table, { delimiter: '\t' }), named],
    [Papa.unparse(table), named],
    [`${a.text}\n\n${b.text}`, both.map((link) => ['', link])],
    [`#${a.link}\n#${bare}`, [['links', a.link]]],
  ])) {
    assert.deepEqual(await read(text), rows);
    // What a platform names is one student's.
    for (const [name] of await read(text, 'Ann Bo_1_assignsubmission_file/mine.txt'))
      assert.equal(name, 'Ann Bo');
  }
  for (const text of [a.text, a.link, `${a.text}\n${site}#${a.link}`, `<p>${a.link}</p>\n<p>${a.link}</p>`])
    assert.deepEqual(await read(text), [['links', a.link]]);
  assert.deepEqual(
    await read(
      Papa.unparse([
        ['Email', 'Text'],
        ['k@x.org', a.text],
        ['l@x.org', b.text],
      ]),
      'all.csv',
    ),
    both.map((link) => ['', link]),
  );
  // Of one student, whose name the file has.
  const again = await handedIn('s1', [3.2, 0, 4.4]);
  for (const [text, rows] of /** @type {[string, string[]][]} */ ([
    [`${a.text}\n\n${again.text}`, [a.link, again.link]],
    [`${site}#${exercise}\n${site}#${a.link}`, [exercise, a.link]],
    [`Name, Kim\n${site}#${a.link}`, [a.link]],
  ]))
    assert.deepEqual(
      await read(text, 'kim.txt'),
      rows.map((link) => ['kim', link]),
    );
  // Each may be so long, not all together.
  assert.equal((await read(Array.from({ length: 600 }, () => a.text).join('\n\n'))).length, 600);
});

/** @param {Record<string, string>} files Their texts. */
const readClass = (files) =>
  readAll(
    Object.entries(files).map(([name, text]) => new File([text], name)),
    createReader(links.pages),
  );

test('what lies in a student’s file speaks for nobody else, also as a table; a table alone is a lecturer’s', async () => {
  const [a, b] = await Promise.all([handedIn('s1', [3.3, 0, 4.5]), handedIn('s2', [3, 0.1, 6])]);
  const table = Papa.unparse([
    ['Full name', 'Identifier', 'Grade', 'Text'],
    ['Lee Bob', 'Participant 102', '0', `${site}#${a.link}`],
  ]);
  const read = async (/** @type {Record<string, string>} */ files) =>
    (await readClass(files)).map(({ name, ident, link }) => [name, Object.keys(ident), link]);
  const eves = ['evepark', ['ID'], a.link];
  assert.deepEqual(await read({ 'leebob_102_202_hand.txt': b.text, 'evepark_103_203_mine.csv': table }), [
    ['leebob', ['ID'], b.link],
    eves,
  ]);
  const bobs = ['Lee Bob', ['Identifier'], a.link];
  assert.deepEqual(await read({ 'section_101_2026_all.csv': table, 'section_102_2026_all.csv': table }), [
    bobs,
    bobs,
  ]);
  assert.deepEqual(await read({ 'Eve Park_103_assignsubmission_file_mine.csv': table }), [
    ['Eve Park', ['Identifier'], a.link],
  ]);
  for (const name of ['class_2026_11_all.csv', 'class.csv'])
    assert.deepEqual(await read({ [name]: table }), [bobs]);
});

test('of one student’s file the last receipts are read, so that there is room for the others, and a row says so', async () => {
  const [a, b] = await Promise.all([handedIn('s1', [3.3, 0, 4.5]), handedIn('s2', [3, 0.1, 6])]);
  const many = `${`${a.text}\n\n`.repeat(1000)}${b.text}\n${'Bye.\n'.repeat(30)}`;
  const entries = await readClass({ 'aapark_103_203_hand.txt': many, 'leebob_102_202_hand.txt': a.text });
  const [first, ...others] = entries.map(({ name, link, why }) => [name, link, why]);
  assert.deepEqual(first, ['aapark', null, 'more']);
  assert.deepEqual(others.slice(-3), [
    ['aapark', a.link, null],
    ['aapark', b.link, null],
    ['leebob', a.link, null],
  ]);
  assert.equal(entries.length, 1 + 20 + 1);
  const row = {
    entry: entries[0],
    checked: null,
    problem: /** @type {const} */ ('more'),
    same: [],
    ones: [],
  };
  assert.deepEqual(remarksOf(row, [row]), [
    'of this file only its receipts were checked, at most the last 20',
  ]);
});

test('what a platform keeps behind a receipt is not handed in, if it is of the same student', async () => {
  const [a, b] = await Promise.all([handedIn('s1', [3.3, 0, 4.5]), handedIn('s2', [3, 0.1, 6])]);
  const [later, other] = [a, b].map(({ link }) => link.split('&handin=')[0].replace('4.5', '4.6'));
  const reader = createReader(links.pages);
  // A package writes a stamp behind each.
  for (const [given, left] of [
    [
      [a.link, later, b.link],
      [a.link, b.link],
    ],
    [
      [a.link, other],
      [a.link, other],
    ],
    [
      [later, a.link],
      [later, a.link],
    ],
  ])
    for (const stamp of ['', ' 0123abcd'])
      assert.deepEqual(
        (await reader.read(given.map((link) => `#${link}${stamp}`).join('\n'))).map(({ link }) => link),
        left,
      );
});

test('a table has its names and columns in whatever a spreadsheet saves it', async () => {
  const { text, link } = await handedIn('s1', [3.3, 0, 4.5]);
  const tableOf = (/** @type {string} */ name, delimiter = ',') =>
    Papa.unparse(
      [
        ['성명', 'Online text', '학번'],
        [name, text, '7'],
      ],
      { delimiter },
    );
  const utf16 = Buffer.from(`\ufeff${tableOf('김', '\t')}`, 'utf16le');
  /** As Korean Excel has it. @param {string} name */
  const korean = (name) =>
    Buffer.concat(
      tableOf(name)
        .split(/(김|성명|학번)/)
        .map((part) => Buffer.from(cp949[part] ?? part, cp949[part] ? 'hex' : 'utf8')),
    );
  const western = Buffer.from(`Name,Online text,Group\r\nÁgnes Müller,"${text}",Übung é`, 'latin1');
  for (const [path, bytes, name, ident] of /** @type {[string, Buffer, string, object][]} */ ([
    ['all.csv', Buffer.from(tableOf('김')), '김', { 학번: '7' }],
    ['all.csv', Buffer.from(`\ufeff${tableOf('김')}`), '김', { 학번: '7' }],
    ['all.csv', korean('김'), '김', { 학번: '7' }],
    ['all.txt', utf16, '김', { 학번: '7' }],
    ['all.txt', Buffer.from(utf16).swap16(), '김', { 학번: '7' }],
    ['all.csv', western, 'Ágnes Müller', { Group: 'Übung é' }],
  ]))
    assert.deepEqual(
      (await readAll([new File([new Uint8Array(bytes)], path)], createReader(links.pages))).map(
        ({ text: _, ...entry }) => entry,
      ),
      [{ name, ident, link, why: null, isReceipt: true, isOnes: true }],
      `${path} ${name}`,
    );
});

pageTest(
  'syllables that only Korean spreadsheets know are read, and western names stay western',
  async (page) => {
    const { link } = await handedIn('s1', [3.3, 0, 4.5]);
    const hexOf = (/** @type {Buffer} */ bytes) => bytes.toString('hex');
    const korean = `${hexOf(Buffer.from('Name,Text\n'))}8c63${hexOf(Buffer.from(`,${link}`))}`;
    const western = hexOf(Buffer.from(`Name,Text\nÁgnes Müller,${link}`, 'latin1'));
    await openSheet(page);
    await page.evaluate(
      (...all) => {
        const dataTransfer = new DataTransfer();
        for (const [i, hex] of all.entries()) {
          const bytes = (hex.match(/../g) ?? []).map((byte) => Number.parseInt(byte, 16));
          dataTransfer.items.add(new File([new Uint8Array(bytes)], `${i}.csv`));
        }
        document
          .getElementById('collect')
          ?.dispatchEvent(new DragEvent('drop', { dataTransfer, bubbles: true, cancelable: true }));
      },
      korean,
      western,
    );
    await checked(page, 2);
    assert.deepEqual(
      (await cells(page)).map(([, , name]) => name),
      ['똠', 'Ágnes Müller'],
    );
  },
);

test('hand-ins of nobody knows whom have not the name of their file', async () => {
  const text = [1, 2].map((seed) => `${site}#lab&v=1&seed=${seed}`).join('\n');
  const entries = await createReader(links.pages).readFile('export.txt', text);
  assert.deepEqual(
    entries.map(({ name }) => name),
    ['', ''],
  );
});
