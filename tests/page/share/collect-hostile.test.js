// What somebody may hand in to harm the others: what would hold the page.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { createReader } from '../../../www/share/collect/entries.js';
import { mark } from '../../../www/share/handin/mark.js';
import { test } from '../harness/once.js';
import { handedIn, site } from './hand-ins.js';

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
