// The sheet on which hand-ins are checked, as a lecturer works it.
import assert from 'node:assert/strict';
import Papa from 'papaparse';
import { links } from '../../../www/lesson/links.js';
import { createChecker } from '../../../www/share/collect/check.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { readAll } from '../../../www/share/collect/files.js';
import { ownersOfFiles } from '../../../www/share/collect/owners.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';
import { cells, checked, openSheet, paste, stripSays } from './hand-in-sheet.js';
import { engine, handedIn } from './hand-ins.js';

test('an anonymous submission keeps its number, and so do those who share a name', async () => {
  const { text } = await handedIn('s1', [3.3, 0, 4.5]);
  const files = [
    ['Participant_12345_assignsubmission_file', 'mine.txt'],
    ['Participant_12346_assignsubmission_file', 'mine.txt'],
    ['Teilnehmer_8_assignsubmission_onlinetext', 'onlinetext.html'],
    ['Teilnehmer_9_assignsubmission_onlinetext', 'onlinetext.html'],
    ['Kim Lee_4711_assignsubmission_file', 'mine.txt'],
    ['Kim Lee_4711_assignsubmission_onlinetext', 'onlinetext.html'],
    ['Ann Bo_1_assignsubmission_file', 'mine.txt'],
    ['Ann Bo_2_assignsubmission_file', 'large.txt'],
  ].map(([folder, name]) =>
    Object.defineProperty(
      new File([name === 'large.txt' ? 'x'.repeat(2_500_000) : text], name),
      'webkitRelativePath',
      {
        value: `all/${folder}/${name}`,
      },
    ),
  );
  assert.deepEqual(
    (await readAll(files, createReader(links.pages))).map(({ name }) => name),
    [
      'Participant 12345',
      'Participant 12346',
      'Teilnehmer 8',
      'Teilnehmer 9',
      'Kim Lee',
      'Kim Lee',
      'Ann Bo 1',
      'Ann Bo 2',
    ],
  );
  // Also where there is one alone.
  const [{ name }] = ownersOfFiles(['all/Participant_12345_assignsubmission_file/mine.txt']);
  assert.equal(name, 'Participant 12345');
});

test('a cancel ends each hand-in that workers have by then', async () => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const entries = await createReader(links.pages).read(Array(500).fill(link).join('\n'));
  const control = new AbortController();
  const { signal } = control;
  const stopped = new Promise((_, reject) => signal.addEventListener('abort', () => reject(signal.reason)));
  const costs = () => {
    // While others are not yet asked for.
    setTimeout(() => control.abort());
    return stopped;
  };
  const checker = createChecker({ ...engine, surveys: { ...engine.surveys, costs } }, links);
  // What nobody has caught fails the test.
  await assert.rejects(checker.check(entries, null, { signal, onProgress: () => {} }), /abort/i);
});

pageTest('a class is checked, sorted, opened, pinned and saved for the gradebook', async (page) => {
  const [a, b, c] = await Promise.all([
    handedIn('s1', [3.3, 0, 4.5]),
    handedIn('s2', [3, 0.1, 6]),
    handedIn('s3', [3.3, 0, 4.5]),
  ]);
  const markup = '<img src=x onerror="document.title=\'broken\'"><b>Hello</b>';
  const table = Papa.unparse([
    ['Full name', 'Email address', 'Online text'],
    ['Ann', 'ann@x.org', a.text],
    ['Bob', 'bob@x.org', `<p>${b.text.replaceAll('&', '&amp;').replaceAll('\n', '<br>')}</p>`],
    ['<b>Cid</b>', 'cid@x.org', c.text],
    ['Dan', 'dan@x.org', markup],
    ['Eve', 'eve@x.org', a.text.slice(0, -5)],
  ]);
  await openSheet(page);
  await paste(page, table);
  await page.click('#collect-check');
  await checked(page, 5);
  assert.match(
    await page.text('#collect-status'),
    /^5 hand-ins in .*: 2 meet the aim, 1 cannot be read, 3 more/,
  );
  const rows = await cells(page);
  assert.deepEqual(
    rows.map(([, , name]) => name),
    ['Ann', 'Bob', '<b>Cid</b>', 'Dan', 'Eve'],
  );
  assert.match(String(rows[0][8]), /same answer as 3 <b>Cid<\/b>, 5 Eve/);
  assert.match(String(rows[3][8]), /no hand-in in it: “Hello”/);
  assert.match(String(rows[4][8]), /cut or changed/);
  assert.deepEqual([rows[0][5], rows[1][5], rows[3][5]], ['met', 'not met', '']);
  assert.deepEqual(rows[4].slice(5, 7), ['cut', '']);
  assert.equal(
    await page.evaluate(
      () => document.querySelectorAll('#collect-sheet img, #collect img, #collect b').length,
    ),
    0,
  );
  if (page.engine === 'chromium') assert.deepEqual(await page.obstacles('#collect'), []);

  await page.click('[data-sort="cost"]');
  await page.click('[data-sort="cost"]');
  const [, first] = await cells(page);
  assert.equal(first[2], 'Bob');

  const csv = Papa.parse((await saved(page, '#collect-csv')).replace('\ufeff', '')).data.map(
    (row) => /** @type {string[]} */ (row),
  );
  assert.deepEqual(
    [0, 1, 2, 5].map((row) => csv[row].slice(0, 4)),
    [
      ['Name', 'Email address', 'Points', 'Aim'],
      ['Ann', 'ann@x.org', '10', 'met'],
      ['Bob', 'bob@x.org', String(b.judged?.points), 'not met'],
      ['Eve', 'eve@x.org', '', 'cut'],
    ],
  );

  await page.click('[aria-label="Pin the run of Bob"]');
  await page.click('[aria-label="Open the run of Ann"]');
  await page.until('the run is open', () => !document.querySelector('dialog[open]'));
  assert.match(await page.text('#legend'), /Bob/);
  assert.equal(
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('gain-kx')).value),
    '3.300',
  );
  assert.equal(await page.evaluate(() => document.getElementById('exercise')?.hidden), true);
  await stripSays(page, /^Ann · J = 7\.71.* · aim met · 10 points/);
  // In the order of the table, and without those that cannot be opened.
  assert.match(await page.text('#collect-strip'), /2 of 4/);
  await page.click('#strip-after');
  await stripSays(page, /^<b>Cid<\/b> · .*3 of 4/);
  await page.click('#strip-before');
  await stripSays(page, /^Ann/);
  await page.click('#strip-before');
  await stripSays(page, /^Bob · J = .* · aim not met/);
  await page.click('#strip-back');
  await page.until('the table is there', () =>
    document.activeElement?.matches('dialog[open] [aria-label="Open the run of Bob"]'),
  );
  assert.equal((await cells(page)).length, 5);
  // Checked once more they are other rows, and whose run is on the page is not said by another's number.
  await page.click('#collect-check');
  await checked(page, 5);
  assert.ok(await page.evaluate(() => document.getElementById('collect-strip')?.hidden));
  await page.click('#collect-close');
  await page.evaluate(() => history.back());
  await page.until(
    'the exercise is back',
    () => !document.getElementById('exercise')?.hidden && document.getElementById('collect-strip')?.hidden,
  );
  assert.deepEqual(await page.problems(), []);
});

pageTest('hand-ins come as files, are shown page by page, and a cancel ends the checking', async (page) => {
  const { link } = await handedIn('s1', [3.3, 0, 4.5]);
  const plain = link.split('&handin=')[0];
  const own = [0, 1, 2, 3].map((i) => plain.replace('3.3,0,4.5', `${3 + i / 10},0,4.5`)).join('\n');
  const many = `${own}\n${'I could not.\n'.repeat(126)}`;
  await openSheet(page);
  await page.evaluate((text) => {
    const files = new DataTransfer();
    files.items.add(new File([text], 'Kim Lee_4711_assignsubmission_onlinetext.html'));
    files.items.add(new File(['x'.repeat(2_500_000)], 'large.txt'));
    document
      .getElementById('collect')
      ?.dispatchEvent(new DragEvent('drop', { dataTransfer: files, bubbles: true, cancelable: true }));
  }, link);
  await checked(page, 2);
  const [one, large] = await cells(page);
  assert.deepEqual([one[2], one[5]], ['Kim Lee', 'met']);
  assert.match(String(large[8]), /too long/);
  // What cannot be read is told, and what is there stays.
  await page.evaluate(() => {
    const reader = {
      readEntries: (/** @type {any} */ _, /** @type {(e: Error) => void} */ no) => no(new Error('no')),
    };
    const folder = { isDirectory: true, isFile: false, createReader: () => reader };
    const dataTransfer = { getData: () => '', items: [{ webkitGetAsEntry: () => folder }], files: [] };
    const drop = Object.assign(new Event('drop', { bubbles: true, cancelable: true }), { dataTransfer });
    document.getElementById('collect')?.dispatchEvent(drop);
  });
  await page.until('that it cannot be read', () =>
    /could not be checked: no/.test(document.getElementById('collect')?.innerText ?? ''),
  );
  assert.equal((await cells(page)).length, 2);
  // A file that is chosen joins those that were dropped.
  await page.evaluate((text) => {
    const input = /** @type {HTMLInputElement} */ (document.getElementById('collect-file'));
    const files = new DataTransfer();
    files.items.add(new File([text], 'Ann Bo_4712_assignsubmission_file.txt'));
    input.files = files.files;
    input.dispatchEvent(new Event('change'));
  }, link);
  await checked(page, 3);
  assert.ok((await cells(page)).some((row) => row[2] === 'Ann Bo' && row[5] === 'met'));

  await paste(page, many);
  await page.click('#collect-check');
  await checked(page, 133);
  await page.click('#collect-after');
  assert.equal((await cells(page)).length, 33);
  // Within one turn of the page, so that there is something to cancel.
  await page.evaluate(() => {
    document.getElementById('collect-check')?.click();
    document.getElementById('collect-cancel')?.click();
  });
  assert.equal(await page.text('#collect-status'), 'Cancelled.');
  await paste(page, link);
  await page.evaluate(() => {
    /** @type {HTMLInputElement} */ (document.getElementById('collect-exercise')).value = 'lab&v=1&aim=J>3';
  });
  await page.click('#collect-check');
  assert.match(await page.text('#collect-status'), /link of the exercise cannot be read: .*aim was left out/);
});
