// The checks as a person meets them: the sheet that runs them and says what came out.
import assert from 'node:assert/strict';
import { cp, mkdtemp, readdir, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath } from 'node:url';
import { groupNames } from '../../../www/core/checks/check.js';
import { resultsOf } from '../../../www/core/checks/checks.js';
import { browserOf } from '../../../www/share/checks/browser.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';
import { checked } from '../harness/reading.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/core/checks/check.js').Golden} Golden */

const goldenText = await readFile(new URL('../../golden.json', import.meta.url), 'utf8');
/** @type {Golden} */
const golden = JSON.parse(goldenText);
const site = fileURLToPath(new URL('../../../dist/', import.meta.url));

test('a browser is named in short', () => {
  const mozilla = 'Mozilla/5.0 (X11; Linux x86_64)';
  for (const [text, name] of [
    [`${mozilla} AppleWebKit/537.36 (KHTML, like Gecko) Chrome/156.0.0.0 Safari/537.36`, 'Chrome 156'],
    [
      `${mozilla} AppleWebKit/537.36 (KHTML, like Gecko) Chrome/156.0.0.0 Safari/537.36 Edg/156.0.1.2`,
      'Edge 156',
    ],
    ['Mozilla/5.0 (X11; Linux x86_64; rv:153.0) Gecko/20100101 Firefox/153.0', 'Firefox 153'],
    [`${mozilla} AppleWebKit/605.1.15 (KHTML, like Gecko) Version/18.5 Safari/605.1.15`, 'Safari 18'],
    ['Something else', 'Something else'],
  ])
    assert.equal(browserOf(text), name);
});

/** What a person sees of the checks. @param {Page} page */
const seen = (page) =>
  page.evaluate(() => {
    const text = (/** @type {string} */ id) =>
      /** @type {HTMLElement} */ (document.getElementById(id)).innerText;
    const probe = document.createElement('span');
    probe.style.color = 'var(--error)';
    document.body.append(probe);
    const error = getComputedStyle(probe).color;
    probe.remove();
    return {
      summary: text('checks-summary'),
      about: text('checks-about'),
      headings: document.querySelectorAll('#checks-list h3').length,
      rows: [...document.querySelectorAll('#checks-list li')].map((row) => {
        const found = /** @type {HTMLElement} */ (row.querySelector('.checks-found'));
        const box = row.getBoundingClientRect();
        const list = /** @type {HTMLElement} */ (row.closest('#checks-list')).getBoundingClientRect();
        return {
          text: /** @type {HTMLElement} */ (row).innerText.replaceAll(/\s+/g, ' ').trim(),
          found: found.innerText,
          isRed: getComputedStyle(found).color === error,
          isInSight: box.top >= list.top - 1 && box.bottom <= list.bottom + 1,
        };
      }),
    };
  });

/** @param {Awaited<ReturnType<typeof seen>>} sheet */
function assertAllPassed({ summary, about, rows, headings }) {
  const results = groupNames.flatMap((group) => resultsOf(core, group, golden, () => {}));
  // And the one of a worker.
  assert.equal(rows.length, results.length + 1);
  assert.match(summary, new RegExp(`^All ${rows.length} checks passed, in \\d+\\.\\d\\d s\\.$`));
  assert.match(about, /^ep-locomotion \d+\.\d+\.\d+ · (Chrome|Firefox|Safari) \d+$/);
  assert.equal(headings, groupNames.length);
  for (const { text, isRed } of rows) {
    assert.match(text, /^✓ passed .+: expected .+, found .+$/);
    assert.ok(!isRed, text);
  }
  const hashes = rows.map(({ found }) => found).filter((found) => /^[0-9a-f]{16}$/.test(found));
  const known = golden.evolutions.map(({ hash }) => hash);
  assert.deepEqual(hashes.slice(0, known.length), known);
  assert.equal(hashes.at(-1), core.evolve(core.experiment('velocity-limits'), 20).hash);
}

/** Moves the focus on by Tab until it is there. @param {Page} page @param {string} id */
async function tabTo(page, id) {
  for (let i = 0; i < 12; i++) {
    if ((await page.evaluate(() => document.activeElement?.id)) === id) return;
    await page.press(Key.TAB);
  }
  assert.fail(`Tab does not reach #${id}`);
}

/** @param {Page} page */
async function assertCopied(page) {
  const { summary, rows } = await seen(page);
  const copied = await page.evaluate(async () => {
    /** @type {string[]} */
    const texts = [];
    const writeText = async (/** @type {string} */ text) => void texts.push(text);
    Object.defineProperty(navigator, 'clipboard', { value: { writeText }, configurable: true });
    document.getElementById('checks-copy')?.click();
    await new Promise((resolve) => setTimeout(resolve));
    return texts.join();
  });
  assert.ok(copied.startsWith(`${summary}\nep-locomotion`), copied.slice(0, 200));
  const lines = copied.split('\n').filter((line) => line.startsWith('passed: '));
  assert.deepEqual(
    lines.map((line) => line.replace('passed: ', '✓ passed ').replaceAll('\u00a0', ' ')),
    rows.map(({ text }) => text),
  );
  assert.equal(await page.text('#checks-copied'), 'The text is copied.');

  await page.evaluate(() => {
    Object.defineProperty(navigator, 'clipboard', { value: undefined });
  });
  await page.click('#checks-copy');
  await page.until('the text is selected', () => {
    const { activeElement: text } = document;
    return text instanceof HTMLTextAreaElement && text.value.slice(text.selectionStart, text.selectionEnd);
  });
  assert.deepEqual(await page.obstacles(), []);
}

engineTest(
  'the keyboard alone starts the checks from the sheet of keys, all of them pass, and are copied as text; where no page may copy, the text is selected',
  async (page) => {
    await page.click('#one-generation');
    await page.focus('#keys-button');
    await page.press(Key.ENTER);
    await tabTo(page, 'keys-checks');
    await page.press(Key.ENTER);
    await checked(page);
    assertAllPassed(await seen(page));
    await tabTo(page, 'checks-list');
    await page.press(Key.END);
    await page.until('the last check is in sight', () => {
      const list = /** @type {HTMLElement} */ (document.getElementById('checks-list'));
      return list.scrollTop + list.clientHeight > list.scrollHeight - 2;
    });
    await assertCopied(page);
    await page.press(Key.ESCAPE);
    await page.until('the sheet is closed', () => document.querySelector('dialog[open]') === null);
    assert.equal(await page.evaluate(() => document.activeElement?.id), 'keys-button');
    assert.equal(await page.text('#generation'), '1');
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('a sheet that is closed and opened again while it checks comes to its end', async (page) => {
  await page.evaluate(() => {
    for (const id of ['keys-button', 'keys-checks', 'checks-close', 'keys-button', 'keys-checks'])
      document.getElementById(id)?.click();
  });
  await checked(page);
  assertAllPassed(await seen(page));
});

pageTest('where no worker starts, the sheet says that the checks could not be finished', async (page) => {
  await page.evaluate(() => {
    Object.defineProperty(window, 'Worker', {
      value: class {
        constructor() {
          throw new Error('forbidden');
        }
      },
    });
  });
  await page.click('#keys-button');
  await page.click('#keys-checks');
  await checked(page);
  const { summary, rows } = await seen(page);
  // Firefox throws the error out of a realm of its own.
  assert.match(
    summary,
    /^The checks could not be finished: No worker can be started: (Error: )?forbidden\. The server /,
  );
  assert.deepEqual(rows, []);
});

/** The built page with another list of known values. @param {(page: Page) => Promise<void>} body @param {Page} page @param {string} from @param {string} to */
async function withOtherKnownValue(page, from, to, body) {
  const folder = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
  try {
    await cp(site, folder, { recursive: true });
    let count = 0;
    for (const name of await readdir(join(folder, 'assets'))) {
      if (!name.endsWith('.js')) continue;
      const file = join(folder, 'assets', name);
      const parts = (await readFile(file, 'utf8')).split(from);
      count += parts.length - 1;
      await writeFile(file, parts.join(to));
    }
    assert.equal(count, 1, 'the page has one list of known values');
    const served = await serve(folder);
    try {
      await page.visit(served.address);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      await body(page);
    } finally {
      await served.close();
    }
  } finally {
    await rm(folder, { recursive: true });
  }
}

pageTest('a known value that does not come out is red, and said in words', async (page) => {
  const { hash } = golden.evolutions[5];
  const other = hash.replace(/^./, '0');
  await withOtherKnownValue(page, hash, other, async () => {
    await page.click('#keys-button');
    await page.click('#keys-checks');
    await checked(page);
    const { summary, rows } = await seen(page);
    assert.match(summary, new RegExp(`^1 of ${rows.length} checks failed, in .*cannot be trusted`));
    const [failed, ...more] = rows.filter(({ text }) => !text.startsWith('✓ passed'));
    assert.deepEqual(more, []);
    assert.match(failed.text, /^✗ failed With .* 200 generations with seed 3 /);
    assert.ok(failed.text.endsWith(`fingerprint: expected ${other}, found ${hash}`), failed.text);
    assert.ok(failed.isRed && failed.isInSight);
    assert.deepEqual(await page.obstacles(), []);
  });
});
