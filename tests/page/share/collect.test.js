// Checking hand-ins: whatever a learning platform gives is read, every drive is computed again, and nothing is believed.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { ownersOfFiles } from '../../../www/share/collect/owners.js';
import { csvOf, ordered, remarksOf } from '../../../www/share/collect/table.js';
import { experiment, simulate } from '../harness/core.js';
import { test } from '../harness/once.js';
import { engine, exercise, handedIn, opened, receipt, site } from './hand-ins.js';

const reader = createReader(links.pages);
const checker = createChecker(engine, links);
const never = () => ({ signal: new AbortController().signal, onProgress: () => {} });

/** @param {string} text @param {string} [by] */
const checkAll = async (text, by = exercise) =>
  checker.check(await reader.read(text), by ? checker.exerciseIn(by) : null, never());

const good = /** @type {const} */ ([3.3, 0, 4.5]);
const cost = simulate(experiment('velocity-limits'), [...good]).cost.total;

test('a receipt is found in its text, as a link, in HTML, in a table, in a folder, and broken into lines', async () => {
  const { text, link } = await handedIn('s1', good);
  const address = `${site}#${link}`;
  const html = `<p>Dear Sir,<br>here it is: <a href="${address.replaceAll('&', '&amp;')}">my <b>work</b></a>.</p>`;
  const table = (/** @type {string[][]} */ ...rows) => Papa.unparse(rows);
  /** @type {Record<string, string>} */
  const forms = {
    text,
    address,
    'the fragment alone': link,
    'two lines of mail': `> ${text.replaceAll('\n', '\n> ')}`,
    'broken lines': text.replace(address, `${address.slice(0, 70)}\n${address.slice(70)}`),
    'moodle’s grading worksheet': table(
      ['Identifier', 'Full name', 'Email address', 'Status', 'Grade', 'Online text'],
      ['Participant 7', 'Kim Lee', 'kim@example.org', 'Submitted', '', html],
    ),
    'twice escaped': table(['Name', 'Text'], ['Kim Lee', html.replaceAll('&', '&amp;')]),
    semicolons: Papa.unparse(
      [
        ['Name', 'Text'],
        ['Kim Lee', text],
      ],
      { delimiter: ';' },
    ),
    html,
  };
  for (const [form, given] of Object.entries(forms)) {
    const { rows } = await checkAll(given);
    assert.equal(rows.length, 1, form);
    assert.deepEqual(
      [rows[0].checked?.worth, rows[0].checked?.cost, rows[0].problem],
      ['holds', cost, ''],
      form,
    );
    assert.equal(rows[0].checked?.judged?.isMet, true);
  }
  const [moodle] = await reader.read(forms['moodle’s grading worksheet']);
  assert.deepEqual(
    [moodle.name, moodle.ident],
    ['Kim Lee', { Identifier: 'Participant 7', 'Email address': 'kim@example.org' }],
  );
  for (const [path, name] of [
    ['all/Kim Lee_4711_assignsubmission_onlinetext/onlinetext.html', 'Kim Lee'],
    ['leekim_12345_67890_hand-in-s1.txt', 'leekim'],
    ['leekim_LATE_12345_67890_text.html', 'leekim'],
    ['leekim_12345_text.html', 'leekim'],
    ['leekim_LATE_12345_link.html', 'leekim'],
    ['student2_12348_999_hand-in.txt', 'student2'],
    ['student2_LATE_12348_999_hand-in.txt', 'student2'],
    ['학생2_12348_text.html', '학생2'],
    // A day is nobody's name.
    ['2026_11_26_hand-in.txt', '2026_11_26_hand-in'],
    ['hand-in-s1.txt', 'hand-in-s1'],
  ])
    assert.equal(ownersOfFiles([path])[0].name, name);
  const [worksheet] = await reader.read(
    table(
      ['Identifier', 'Full name', 'Status', 'Maximum Grade', 'Online text'],
      ['Participant 8', 'Lee', 'Submitted for grading', '10.00', '<p>I could not.</p>'],
    ),
  );
  assert.match(worksheet.text, /^I could not\./);
  const [file] = await reader.readFile('all/Kim Lee_4711_assignsubmission_onlinetext/onlinetext.html', html);
  assert.deepEqual([file.name, file.link?.includes('handin=')], ['Kim Lee', true]);
});

test('what stands behind a receipt in a text is none of it', async () => {
  const { link } = await handedIn('s1', good);
  for (const text of [
    `My work is ${link}.`,
    `(${site}#${link})`,
    `${link}, thanks`,
    `[my work](${link})`,
    `<a href='${site}#${link}'>work</a>`,
  ]) {
    const [entry] = await reader.read(text);
    assert.equal(entry.link?.slice(-20), link.slice(-20), text);
  }
});

test('what is cut, forged, of another exercise, of another version, too long, or no hand-in is a row that says so', async () => {
  const { text, link } = await handedIn('s1', good);
  const other = await handedIn('s2', good, `${exercise.replace('J%3C7.9', 'J%3C20')}&goal.x=1`);
  const { sealOf } = await import('../../../www/link/seal.js');
  /** What nobody made with the page, but with digits that fit. @param {...readonly [from: string, to: string]} changes */
  const forge = (...changes) => {
    const changed = (/** @type {string} */ text) =>
      changes.reduce((whole, [from, to]) => whole.replace(from, to), text);
    const [run, handin] = link.split('&handin=');
    const body = changed(decodeURIComponent(handin).split('~').slice(0, -1).join('~'));
    return `${changed(run)}&handin=${encodeURIComponent(`${body}~${sealOf(changed(run), body)}`)}`;
  };
  const byOther = /** @type {const} */ ([`~${engine.version()}~`, '~9.9.9~']);
  const otherJ = /** @type {const} */ ([String(cost), '7.1']);
  /** @type {[string, string, RegExp][]} */
  const rows = [
    ['cut', link.slice(0, -3), /cut or changed/],
    [
      'cut before',
      link.slice(0, link.indexOf('&lock')),
      /link without a receipt.*differs from the exercise in .*task/,
    ],
    ['cut within the gains', link.slice(0, link.indexOf('3.3,') + 6), /cannot be read: .*gains was left out/],
    ['gains changed', link.replace('3.3,', '3.4,'), /cut or changed/],
    ['J forged', forge(otherJ), /says J = 7\.1/],
    ['gains forged', forge(['3.3,', '3.4,']), /says J = 7\.71/],
    ['another exercise', other.link, /differs from the exercise in goal\.x, aim/],
    ['another version', `${link.replace('v=1', 'v=2')}`, /cannot be read: .*version 2/],
    ['another program', forge(byOther), /^$/],
    ['another program, and J', forge(byOther, otherJ), /^made by another version of the program$/],
    ['too heavy', `lab&v=1&generation=100000&population=2000&task=x`, /too long to compute/],
    ['prose', 'I could not do it, sorry.', /no hand-in in it: “I could not do it, sorry\.”/],
    ['markup', '<img src=x onerror="alert(1)"><script>alert(1)</script>', /no hand-in in it/],
    [
      'markup in a link',
      `lab&v=1&task=%3Cimg%20src=x%20onerror=alert(1)%3E&drives=hand&gains=3,0,4&who=%3Cb%3E`,
      /differs/,
    ],
  ];
  for (const [what, given, remark] of rows) {
    const { rows: checked } = await checkAll(given);
    assert.equal(checked.length, 1, what);
    assert.match(remarksOf(checked[0], checked).join('; '), remark, what);
  }
  // What was cut has no points, also where nothing is left of its digits; a link that never was a receipt is judged.
  const half = text.slice(0, text.indexOf('&handin='));
  for (const [given, worth, isJudged] of /** @type {const} */ ([
    [text.slice(0, -3), 'broken', false],
    [half, 'broken', false],
    [link.slice(0, link.indexOf('&handin=')), 'none', true],
  ])) {
    const [{ checked }] = (await checkAll(given)).rows;
    assert.deepEqual([checked?.worth, checked?.judged !== null], [worth, isJudged], given.slice(-20));
  }
  const long = await checkAll(`${text}${'x'.repeat(10_000_000)}`);
  assert.match(remarksOf(long.rows[0], long.rows).join(), /too long/);
  // Judged by the exercise as it was given, whatever the hand-in says of it.
  const [row] = (await checkAll(other.link)).rows;
  assert.equal(row.checked?.judged?.isMet, true);
  assert.equal(row.checked?.cost, cost);
  const own = simulate((await opened(other.link)).experiment, [...good]).cost.total;
  assert.equal(row.checked?.own, own);
  assert.ok(
    remarksOf(row, [row]).includes(`J = ${Number(own.toFixed(6))} in what was handed in`),
    remarksOf(row, [row]).join(),
  );
});

test('what alone was given and cannot be read says why, also where no exercise is known', async () => {
  const { link } = await handedIn('s1', good);
  const { rows } = await checkAll(link.replace('v=1', 'v=2'), '');
  assert.equal(rows.length, 1);
  assert.match(/** @type {{ said: string }} */ (rows[0].problem).said, /2/);
});

test('what nobody has told of drives is nowhere a number, and a budget of drives is not judged then', async () => {
  const budget = exercise.replace('J%3C7.9', 'J%3C7.9;drives%3C%3D100');
  const { link } = await handedIn('s1', good, budget);
  const bare = link.slice(0, link.indexOf('&handin='));
  for (const [text, by, drives, isMet] of /** @type {const} */ ([
    [link, budget, 0, true],
    [bare, budget, null, undefined],
    [bare, exercise, null, true],
    // Evolution can be asked how many it took.
    [`${budget}&generation=3`, budget, 80, false],
  ])) {
    const { rows } = await checkAll(text, by);
    const [{ checked }] = rows;
    assert.deepEqual([checked?.drives, checked?.judged?.isMet], [drives, isMet], text);
    const isJudged = isMet !== undefined;
    assert.equal(/nobody knows how many drives/.test(remarksOf(rows[0], rows).join()), !isJudged, text);
    const [head, row] = Papa.parse(csvOf(rows, site)).data.map((cells) => /** @type {string[]} */ (cells));
    assert.equal(row[head.indexOf('Drives')], drives === null ? '' : String(drives), text);
    assert.deepEqual(
      isJudged || [row[head.indexOf('Points')], row[head.indexOf('Aim')]],
      isJudged || ['', ''],
    );
  }
});

test('a class is checked at once: twins are named, variants drawn, evolved gains found again', async () => {
  const texts = await Promise.all([
    handedIn('s1', [3.3, 0, 4.5]),
    handedIn('s2', [3.2, 0.1, 5.2]),
    handedIn('s3', [3.3, 0, 4.5]),
  ]);
  const { rows, given } = await checkAll(texts.map(({ text }) => text).join('\n\n'), '');
  assert.equal(given?.id, texts[0].exercise);
  assert.deepEqual(
    rows.map(({ same }) => same),
    [[0, 2], [1], [0, 2]],
  );
  assert.doesNotMatch(remarksOf(rows[1], rows).join(), /same/);
  assert.match(remarksOf(rows[0], rows).join(), /same answer as 3 s3/);
  assert.deepEqual(ordered(rows, { column: 'cost', isDown: true }), [1, 0, 2]);
  // Of many three are named, and what one answer has is made once.
  const { rows: equal } = await checkAll(Array.from({ length: 5 }, () => texts[0].text).join('\n\n'));
  assert.equal(new Set(equal.map(({ same }) => same)).size, 1);
  for (const [row, twins] of [
    [0, '2 s1, 3 s1, 4 s1'],
    [3, '1 s1, 2 s1, 3 s1'],
    [4, '1 s1, 2 s1, 3 s1'],
  ])
    assert.deepEqual(remarksOf(equal[Number(row)], equal), [`same answer as ${twins} and 1 more`]);
  const vary = `${exercise}&vary=goal,seed`;
  const mine = await handedIn('s1', good, vary);
  const copied = mine.link.replace('who=s1', 'who=s2');
  const varied = await checkAll([mine.link, copied].join('\n'), vary);
  assert.deepEqual(
    varied.rows.map(({ checked }) => checked?.worth),
    ['holds', 'broken'],
  );
  assert.deepEqual(varied.rows[0].checked?.differs, []);
  // Nothing is drawn for nobody.
  const [nobodys] = (await checkAll(`${vary}&drives=hand&gains=${good}`, vary)).rows;
  assert.equal(nobodys.checked?.judged, null);
  assert.match(remarksOf(nobodys, [nobodys]).join(), /not judged: it has no name/);

  const free = exercise.replace('seed,', '');
  const evolved = await receipt(`${free}&seed=9&generation=30&who=s4`);
  const [found] = (await checkAll(evolved.link, free)).rows;
  assert.deepEqual(
    [
      found.checked?.worth,
      found.checked?.gains,
      found.checked?.drives,
      found.checked?.isTold,
      found.checked?.differs,
    ],
    ['holds', evolved.gains, 620, false, []],
  );
});

test('the table for the gradebook has the platform’s own columns, all digits, and no formula', async () => {
  const { text } = await handedIn('s1', good);
  const given = Papa.unparse([
    ['Full name', 'Email address', 'Online text'],
    ['=HYPERLINK("http://x")', 'kim@example.org', text],
    ['-1+1', '@SUM(1)', 'nothing'],
  ]);
  const { rows } = await checkAll(given);
  const [head, first, second] = Papa.parse(csvOf(rows, site).replace('\ufeff', '')).data.map(
    (row) => /** @type {string[]} */ (row),
  );
  assert.deepEqual(head.slice(0, 5), ['Name', 'Email address', 'Points', 'Aim', 'J']);
  assert.deepEqual(first.slice(1, 5), ['kim@example.org', '10', 'met', String(cost)]);
  assert.deepEqual([first[0][0], second[0][0], second[1][0]], ["'", "'", "'"]);
  assert.ok(first[first.length - 1].startsWith(`${site}#lab&`));
});

test('five hundred hand-ins are checked with progress, and a cancel ends it', async () => {
  const { link } = await handedIn('s1', good);
  const plain = link.split('&handin=')[0];
  const text = Array.from({ length: 500 }, (_, i) =>
    plain.replace('3.3,0,4.5', `${3 + i / 1000},0,4.5`),
  ).join('\n');
  const entries = await reader.read(text);
  assert.equal(entries.length, 500);
  /** @type {number[]} */
  const shares = [];
  const { rows } = await checker.check(entries, null, {
    ...never(),
    onProgress: (share) => shares.push(share),
  });
  assert.ok(rows.every(({ checked }) => checked?.worth === 'none'));
  assert.ok(
    shares.length > 100 &&
      shares.every((share, i) => i === 0 || share >= shares[i - 1]) &&
      shares[shares.length - 1] === 1,
  );
  const control = new AbortController();
  control.abort();
  await assert.rejects(
    checker.check(entries, null, { signal: control.signal, onProgress: () => {} }),
    /abort/i,
  );
});
