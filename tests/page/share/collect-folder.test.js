// A folder of a class: by which numbers its students are known, who hands in twice, and what is no text; and by which exercise.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { readAll } from '../../../www/share/collect/files.js';
import { csvName, csvOf, remarksOf } from '../../../www/share/collect/table.js';
import { engineTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';
import { checked, openCollect, paste } from './hand-in-sheet.js';
import { engine, exercise, handedIn, site } from './hand-ins.js';

const reader = createReader(links.pages);

/** @param {readonly (readonly [path: string, content: BlobPart])[]} files */
async function checkFolder(files) {
  const all = files.map(([path, content]) => {
    const file = new File([content], path.slice(path.lastIndexOf('/') + 1));
    return Object.defineProperty(file, 'webkitRelativePath', { value: path });
  });
  const { signal } = new AbortController();
  const entries = await readAll(all, reader);
  return createChecker(engine, links).check(entries, null, { signal, onProgress: () => {} });
}

test('the number by which a platform knows a student is a column, as its own tables have it', async () => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  const { rows } = await checkFolder([
    ['all/Ann_101_assignsubmission_file/one.txt', text],
    ['all/Ann_101_assignsubmission_file/large.txt', 'x'.repeat(2_500_000)],
    ['all/Bob_102_assignsubmission_file/two.txt', `${text}\n\n${text}`],
    ['leebo_LATE_4711_67890_hand-in.txt', text],
    ['mine.txt', text],
  ]);
  const [head, ...lines] = Papa.parse(csvOf(rows, site).replace('\ufeff', '').trim()).data.map((line) =>
    /** @type {string[]} */ (line).slice(0, 3),
  );
  assert.deepEqual(head, ['Name', 'Identifier', 'ID']);
  assert.deepEqual(lines, [
    ['Ann', 'Participant 101', ''],
    ['Ann', 'Participant 101', ''],
    ['Bob', 'Participant 102', ''],
    ['Bob', 'Participant 102', ''],
    ['leebo', '', '4711'],
    ['mine', '', ''],
  ]);
});

test('who hands in twice has a remark, with the numbers of the other rows', async () => {
  const [one, two] = await Promise.all([handedIn('s1', [3.3, 0, 4.5]), handedIn('s2', [3, 0.1, 6])]);
  const { rows } = await checkFolder([
    ['all/Ann_101_assignsubmission_file/one.txt', one.text],
    ['all/Ann_101_assignsubmission_file/two.txt', two.text],
    ['all/Ann_101_assignsubmission_file/report.txt', 'What I did.'],
    ['all/Ann_102_assignsubmission_file/one.txt', (await handedIn('s3', [3.1, 0, 4.5])).text],
  ]);
  assert.deepEqual(
    rows.map((row) => remarksOf(row, rows).filter((remark) => /same student/.test(remark))),
    [['the same student also has 2'], ['the same student also has 1'], [], []],
  );
  const many = await checkFolder([
    ['all/Ann_101_assignsubmission_file/all.txt', `${one.text}\n\n`.repeat(6)],
  ]);
  assert.ok(remarksOf(many.rows[5], many.rows).includes('the same student also has 1, 2, 3 and 2 more'));
});

test('a document, a zip or a picture is not quoted, but its row says what to do', async () => {
  const png = new Uint8Array([0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a, 0xff, 0xfe]);
  const { rows } = await checkFolder([
    ['a.docx', 'PK\x03\x04\x14\x00\x06[Content_Types].xml'],
    ['b.zip', `PK\x03\x04${'x'.repeat(300_000)}`],
    ['c.pdf', '%PDF-1.7\n%x'],
    ['d.png', png],
    ['e.jpg', new Uint8Array([0xff, 0xd8, 0xff, 0xe0, 0x00, 0x10, 0x4a, 0x46, 0x49, 0x46, 0x00])],
    ['f.hwp', new Uint8Array([0xd0, 0xcf, 0x11, 0xe0, 0xa1, 0xb1, 0x1a, 0xe1])],
    ['all/Ann_101_assignsubmission_file/e.png', png],
  ]);
  for (const row of rows) assert.match(remarksOf(row, rows).join(), /^no text but a document[^“]*receipt$/);
});

test('the exercise is found in the line of a frame and before what ends a sentence; the file is named by it', async () => {
  const checker = createChecker(engine, links);
  const drawn = `${exercise}&vary=goal,seed`;
  const frame = `<iframe src="${site}?embed#${drawn.replaceAll('&', '&amp;')}" title="x" width="640"></iframe>`;
  const { id } = checker.exerciseIn(drawn);
  for (const asked of [`${site}#${drawn}`, drawn, frame, `${site}#${drawn}.`, `(${site}#${drawn})`])
    assert.equal(checker.exerciseIn(reader.exerciseIn(asked)).id, id, asked);
  // As a program has decoded them, or as one types them.
  for (const link of [
    'lab&v=1&task=Park in 2 s.&aim=J<8',
    'lab&v=1&aim=J<8;drives<=9',
    'lab&v=1&task=Say "x"',
    'lab&v=1&task=로봇을 주차하십시오.',
  ])
    assert.equal(reader.exerciseIn(link), link);
  assert.equal(csvName(checker.exerciseIn(drawn)), `hand-ins-${id}.csv`);
  assert.equal(csvName(null), 'hand-ins.csv');
});

test('of a German worksheet what was graded is not passed on, nor quoted where nobody handed in', async () => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  const graded = ['Bewertung', 'Bestwertung', 'Bewertung kann geändert werden', 'Zuletzt geändert (Abgabe)'];
  const head = ['ID', 'ID-Nummer', 'Vollständiger Name', 'E-Mail-Adresse', ...graded, 'Texteingabe online'];
  const rowOf = (/** @type {string} */ written) => [
    'Teilnehmer/in7',
    '2026',
    'Ann',
    'ann@x.org',
    '',
    '100,00',
    'Ja',
    '-',
    written,
  ];
  const entries = await reader.read(Papa.unparse([head, rowOf(text), rowOf('')]));
  for (const { name, ident } of entries)
    assert.deepEqual([name, Object.keys(ident)], ['Ann', ['ID', 'ID-Nummer', 'E-Mail-Adresse']]);
  assert.equal(entries[1].text, '');
});

engineTest('from the one file on a disk the links in the gradebook’s file have no path', async (page) => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  await page.visit(`${new URL('../../../dist/ep-locomotion.html', import.meta.url).href}#${exercise}`);
  await page.until('the page is ready', () => document.documentElement.dataset.ready);
  await openCollect(page);
  await paste(page, text);
  await page.click('#collect-check');
  await checked(page, 1);
  const [, row] = Papa.parse((await saved(page, '#collect-csv')).trim()).data;
  assert.match(String(/** @type {string[]} */ (row).at(-1)), /^ep-locomotion\.html#lab&/);
});
