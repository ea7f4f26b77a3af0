// How much a first visit loads, compressed as hosts do: budgets.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import { gzipSync } from 'node:zlib';
import { pageTest } from '../harness/browsers.js';

/** The address alone opens the parking place. @type {readonly (readonly [fragment: string, bytes: number])[]} */
const budgets = [
  ['', 225_200],
  ['#lab', 224_200],
  ['#lab&v=1&lang=ko', 226_200],
];

pageTest('a first visit loads no more than it may', async (page) => {
  for (const [fragment, budget] of budgets) {
    await page.open(fragment);
    const paths = await page.evaluate(() =>
      [...performance.getEntriesByType('navigation'), ...performance.getEntriesByType('resource')].map(
        ({ name }) => new URL(name).pathname,
      ),
    );
    const { pathname } = new URL(page.site.address);
    const files = paths
      .filter((path) => path.startsWith(pathname))
      .map((path) => path.slice(pathname.length) || 'index.html');
    const sizes = await Promise.all(
      files.map(async (file) => {
        const content = await readFile(new URL(`../../../dist/${file}`, import.meta.url));
        return { file, size: gzipSync(content, { level: 9 }).length };
      }),
    );
    const sum = sizes.reduce((before, { size }) => before + size, 0);
    for (const kind of ['.html', '.css', '.js', '.wasm'])
      assert.ok(
        files.some((file) => file.endsWith(kind)),
        `no ${kind} was loaded`,
      );
    const all = sizes.map(({ file, size }) => `\n  ${size} ${file}`).join('');
    assert.ok(sum <= budget, `${fragment || 'the address alone'} loads ${sum} bytes:${all}`);
  }
});
