// What is read of a class: all columns of the platform, each file once, so many at once; and what its pictures are made of.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { binsOf, reach } from '../../../www/share/collect/bins.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader, mostEntries } from '../../../www/share/collect/entries.js';
import { joined, readAll } from '../../../www/share/collect/files.js';
import { csvOf } from '../../../www/share/collect/table.js';
import { test } from '../harness/once.js';
import { engine, exercise, handedIn, site } from './hand-ins.js';

/** @import { Kind } from '../../../www/share/collect/bins.js' */

const reader = createReader(links.pages);

/** As the page writes it. @param {string} address */
function written(address) {
  const [before, link] = address.split('#');
  const { parts, ...state } = links.openLink(link, engine).opened;
  return `${before}#${links.linkOf({ ...state, slices: parts, work: null }, engine.experiment)}`;
}

test('the columns of the platform are passed on in any language, but for what was written and what was graded', async () => {
  const { text, link } = await handedIn('s1', [3.3, 0, 4.5]);
  /** @type {[string[], string[]][]} */
  const heads = [
    [
      ['Identifiant', 'Nom complet', 'Adresse de courriel', 'Remise'],
      ['Identifiant', 'Adresse de courriel'],
    ],
    [
      ['ID', 'Vollständiger Name', 'E-Mail-Adresse', 'Texteingabe online'],
      ['ID', 'E-Mail-Adresse'],
    ],
    [
      ['식별자', '성명', '이메일 주소', '온라인 텍스트'],
      ['식별자', '이메일 주소'],
    ],
    [['Identifier', 'Full name', 'Grade', 'Anything'], ['Identifier']],
  ];
  const checker = createChecker(engine, links);
  const never = { signal: new AbortController().signal, onProgress: () => {} };
  for (const [head, passed] of heads)
    for (const written of [text, link]) {
      const table = Papa.unparse([
        head,
        ['P7', 'Kim Lee', 'kim@x.org', written],
        ['P8', 'Lee', 'lee@x.org', 'No.'],
      ]);
      const entries = await reader.read(table);
      assert.deepEqual(
        entries.map(({ name, ident }) => [name, Object.keys(ident)]),
        [
          ['Kim Lee', passed],
          ['Lee', passed],
        ],
      );
      assert.match(entries[1].text, /^No\./);
      const { rows } = await checker.check(entries, checker.exerciseIn(exercise), never);
      const [top] = Papa.parse(csvOf(rows, site).replace('\ufeff', '')).data;
      assert.deepEqual(/** @type {string[]} */ (top).slice(1, 1 + passed.length), passed);
    }
});

test('what stands around a link is neither of its student’s number nor of a name', async () => {
  const link = 'lab&v=1&seed=7&task=T.&vary=goal&who=S4711';
  const bare = `${site}#${link}`;
  /** @type {readonly (readonly [string, string])[]} */
  const rows = [
    [bare, ''],
    [`${bare}.`, ''],
    [`Kim, ${bare}, thanks!`, 'Kim'],
    [`Is it ${bare}?`, 'Is it'],
    [`"Lee, Bo": ${bare};`, 'Lee, Bo'],
    [`20231234 ${bare}`, '20231234'],
    [`<${bare}>`, ''],
    [`(${bare})`, ''],
    [`- ${bare}`, ''],
    [`2) ${bare}`, ''],
    [`1. Jo O’Neil – <${bare}>`, 'Jo O’Neil'],
    [`Kim: [my answer](${bare}).`, 'Kim'],
  ];
  for (const [text, name] of rows) {
    const [entry, ...more] = await reader.read(text);
    assert.deepEqual([entry.link, entry.name, more], [link, name, []], text);
  }
  // What a name ends with, as the page writes it, is of the link.
  for (const who of ['Jr.', 'Kim%20(B)', 'me!']) {
    const address = written(`${site}#lab&v=1&task=Why!&vary=goal&who=${who}`);
    const [{ link: found }] = await reader.read(`It is ${address}.`);
    assert.equal(`${site}#${found}`, address);
  }
});

test('what a teacher wrote is nobody’s hand-in, in any language, wherever it stands', async () => {
  const mine = await handedIn('s1', [3.3, 0, 4.5]);
  const solution = await handedIn('teacher', [3.2, 0, 4.4]);
  const heads = [
    ['Full name', 'Online text', 'Feedback comments'],
    ['성명', '온라인 텍스트', '피드백 댓글'],
    ['Nom complet', 'Texte en ligne', 'Commentaires de feedback'],
    ['Vollständiger Name', 'Texteingabe online', 'Feedback als Kommentar'],
    ['Name', 'オンラインテキスト', 'フィードバックコメント'],
    // A word that nobody knows, beside what students wrote.
    ['Full name', 'Online text', 'Remarks of mine'],
  ];
  for (const head of heads)
    for (const order of [
      [0, 1, 2],
      [2, 1, 0],
    ])
      for (const said of [solution.text, `${site}#${solution.link}`]) {
        const rows = [head, ['Kim', mine.text, said], ['Lee', '', said], ['Bo', 'No.', '']];
        const entries = await reader.read(Papa.unparse(rows.map((row) => order.map((i) => row[i]))));
        assert.deepEqual(
          entries.map(({ name, ident, link }) => [name, Object.keys(ident), link]),
          [
            ['Kim', [], mine.link],
            ['Lee', [], null],
            ['Bo', [], null],
          ],
          head.join(),
        );
        assert.match(entries[2].text, /^No\./);
      }
  // Where no column is known for it, it is wherever links are.
  const [other] = await reader.read(
    Papa.unparse([
      ['Name', 'Text', 'Link'],
      ['Kim', 'See there.', mine.link],
    ]),
  );
  assert.equal(other.link, mine.link);
});

test('of who handed nothing in, a grading table of Moodle says nothing that they would have written', async () => {
  const { text, link } = await handedIn('s1', [3.3, 0, 4.5]);
  // With their cells where nothing is handed in, and whether they are the student's.
  /** @type {readonly (readonly [english: string, korean: readonly string[], cell: string, isTheirs: boolean])[]} */
  const columns = [
    ['Identifier', ['식별자'], '참가자 12345', true],
    ['Full name', ['전체 이름', '사용자 성명', '성명'], '김하나', false],
    ['ID number', ['id 번호', 'ID 번호', '학번'], '20231234', true],
    ['Username', ['사용자 아이디'], 'hana', true],
    ['Email address', ['이메일 주소', '이메일', '전자우편 주소'], 'hana@x.org', true],
    ['Status', ['상태'], '제출이 없습니다.', false],
    ['Grade', ['성적'], '', false],
    ['Maximum grade', ['최대 성적'], '100.00', false],
    ['Grade can be changed', ['Grade can be changed'], '예', false],
    ['Last modified (submission)', ['마지막 수정됨(제출)'], '-', false],
    ['Online text', ['온라인 텍스트'], '', false],
    ['Last modified (grade)', ['마지막 수정됨(성적)'], '-', false],
    ['Feedback comments', ['피드백 코멘트'], '', false],
  ];
  const heads = [0, 1, 2].map((i) => columns.map(([, korean]) => korean[i % korean.length]));
  for (const head of [columns.map(([english]) => english), ...heads]) {
    const cells = columns.map(([, , cell]) => cell);
    const written = columns.map(([english, , cell]) => (english === 'Online text' ? text : cell));
    const entries = await reader.read(Papa.unparse([head, cells, written]));
    const own = Object.fromEntries(columns.flatMap(([, , cell, is], i) => (is ? [[head[i], cell]] : [])));
    assert.deepEqual(
      entries.map((entry) => [entry.name, entry.ident, entry.link]),
      [
        ['김하나', own, null],
        ['김하나', own, link],
      ],
    );
    assert.equal(entries[0].text, '', head.join());
  }
});

test('no name turns around what stands beside it, and no cell falls apart, wherever tables are divided', async () => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  const given = [
    ['Full name', 'constructor', 'Online text'],
    ['Lee\u202eeel\u0007 12', 'a;-2+3', text],
  ];
  const [entry] = await reader.read(Papa.unparse(given));
  assert.equal(entry.name, 'Leeeel 12');
  const row = { entry, checked: null, problem: /** @type {const} */ ('none'), same: [], ones: [] };
  const other = { ...row, entry: { ...entry, ident: {} } };
  const file = csvOf([row, other], site);
  assert.match(file, /,"a;'-2\+3",/);
  assert.deepEqual(
    Papa.parse(file.trim()).data.map((cells) => /** @type {string[]} */ (cells)[1]),
    ['constructor', "a;'-2+3", ''],
  );
});

test('a column of the platform is no formula, and there are not too many', async () => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  const many = Array.from({ length: 60 }, (_, i) => `Field ${i}`);
  const [entry] = await reader.read(
    Papa.unparse([
      ['Name', '=1+1', 'Hand-in', ...many],
      ['Kim', '=2+2', text, ...many],
    ]),
  );
  assert.equal(Object.keys(entry.ident).length, 20);
  const row = { entry, checked: null, problem: /** @type {const} */ ('none'), same: [], ones: [] };
  const [head, first] = Papa.parse(csvOf([row], site).replace('\ufeff', '')).data;
  assert.deepEqual(
    [/** @type {string[]} */ (head)[1], /** @type {string[]} */ (first)[1]],
    ["'=1+1", "'=2+2"],
  );
});

test('so many are read, and the others are counted: of lines, of a table, of files', async () => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const all = mostEntries + 3;
  const lines = Array.from({ length: all }, () => link);
  const table = Papa.unparse([['Name', 'Text'], ...lines.map((one) => ['Kim', one])]);
  const files = lines.map((one, i) => new File([one], `${i}.txt`));
  for (const entries of [
    await reader.read(lines.join('\n')),
    await reader.read(table),
    await readAll(files, reader),
  ]) {
    assert.equal(entries.length, all);
    assert.deepEqual(
      [entries[mostEntries - 1].link === null, entries[mostEntries].link === null],
      [false, true],
    );
  }
});

test('a file that is chosen twice is there once, and another of its name is another', async () => {
  const file = (/** @type {string} */ text, lastModified = 1) =>
    new File([text], 'mine.txt', { lastModified });
  const first = await joined([], [file('one'), file('two')]);
  assert.equal(first.length, 2);
  assert.equal((await joined(first, [file('one'), file('two')])).length, 2);
  assert.equal((await joined(first, [file('six'), file('one', 2), file('longer')])).length, 5);
});

test('an aim is a border between two bars, nobody is left out, and who is far off is not among the others', () => {
  const pointOf = (/** @type {number} */ cost) => ({
    cost,
    gains: [0, 0, 0],
    kind: /** @type {Kind} */ (cost < 7.9 ? 'met' : 'not'),
  });
  for (const count of [1, 2, 3, 30, 500])
    for (const aim of [7.9, null, 20, 1]) {
      const costs = Array.from({ length: count }, (_, i) => 7.5 + ((i * 37) % 100) / 100);
      const far = count > 20 ? [50, 1e6] : [];
      const { bins, beyond, first, step } = binsOf([...costs, ...far].map(pointOf), aim);
      const sum = [...bins, beyond].reduce((all, { met, not, unjudged }) => all + met + not + unjudged, 0);
      assert.equal(sum, count + far.length);
      assert.deepEqual(beyond, { met: 0, not: far.length, unjudged: 0 });
      assert.ok(bins.length <= 26);
      if (aim === null) continue;
      const border = (aim - first) / step;
      assert.ok(Math.abs(border - Math.round(border)) < 1e-9, `${aim}`);
      if (aim === 7.9)
        for (const [i, bin] of bins.entries()) assert.equal(i < Math.round(border) ? bin.not : bin.met, 0);
    }
  assert.deepEqual(reach([1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 900]), [1, 11]);
  assert.deepEqual(reach([3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 3, 9]), [3, 9]);
});
