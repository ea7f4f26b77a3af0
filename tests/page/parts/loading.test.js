// A part is loaded when it is opened. Where that fails it is said, everything else goes on, and one can try again.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** The files of scripts that the page has asked for, without their hashes. @param {Page} page @returns {Promise<string[]>} */
const asked = (page) =>
  page.evaluate(() =>
    performance
      .getEntriesByType('resource')
      .map(({ name }) => /assets\/(\w+)-[^/]*\.js$/.exec(name)?.[1])
      .filter((name) => name !== undefined),
  );

/** What stands in the place of the open part. @param {Page} page */
const inPlace = (page) =>
  page.evaluate(() => {
    return {
      failed: /** @type {HTMLElement | null} */ (document.querySelector('.part-failed'))?.innerText ?? '',
      isThere: document.getElementById('luck-run')?.checkVisibility() ?? false,
    };
  });

pageTest('a part is loaded when it is opened, in the language of the page alone', async (page) => {
  await page.open('#lab&lang=ko');
  const first = await asked(page);
  assert.ok(first.includes('ko'));
  assert.ok(!first.includes('en'), 'the other language is loaded');
  await page.click('#page-luck');
  await page.until('Luck is there', () => document.getElementById('luck-run')?.checkVisibility());
  const more = (await asked(page)).slice(first.length);
  assert.ok(more.length >= 2 && more.length <= 4, `for Luck ${more.join(', ')} were loaded`);
  assert.ok(!more.includes('en'));
  assert.deepEqual(await page.problems(), []);
});

pageTest('a part that cannot be loaded says so, and all else goes on until it can', async (page) => {
  /** What is not sent. @type {(name: string, content: Buffer) => boolean} */
  let refuses = (name, content) => /page-.*\.js$/.test(name) && content.includes('luck-finding');
  const site = await serve(undefined, {
    send: (name, content) => (refuses(name, content) ? null : content),
  });
  const isSaid = () =>
    page.until('it is said', () => {
      const box = /** @type {HTMLElement | null} */ (document.querySelector('.part-failed'));
      return box?.checkVisibility() && box.innerText;
    });
  try {
    await page.visit(`${site.address}#lab&v=1&seed=7&lang=ko`);
    await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
    await page.click('#page-luck');
    assert.match(await isSaid(), /불러오지 못했습니다.*다시 시도/s);
    assert.equal((await inPlace(page)).isThere, false);

    // Without a network nothing is lost by trying again.
    refuses = () => true;
    await page.click('.part-failed button');
    await isSaid();
    await page.click('#page-lab');
    await page.click('#one-generation');
    await page.until('the lab goes on', () =>
      /1/.test(document.getElementById('generation')?.textContent ?? ''),
    );

    refuses = () => false;
    await page.click('#page-luck');
    await page.click('.part-failed button');
    await page.until('Luck is there', () => document.getElementById('luck-run')?.checkVisibility());
    assert.deepEqual(await inPlace(page), { failed: '', isThere: true });
    assert.match(await page.evaluate(() => location.hash), /seed=7/);
  } finally {
    await page.leave();
    await site.close();
  }
});

pageTest(
  'the lesson is loaded when a step is opened; where it cannot be, its place says so',
  async (page) => {
    await page.open('#lab');
    const first = await asked(page);
    await page.click('#page-lesson');
    await page.until('the step is there', () => document.getElementById('lesson-title')?.checkVisibility());
    assert.ok((await asked(page)).length > first.length, 'the lesson was there before');
    const site = await serve(undefined, {
      send: (name, content) =>
        /page-.*\.js$/.test(name) && content.includes('lesson-title') ? null : content,
    });
    try {
      await page.visit(`${site.address}#lesson&step=3`);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      await page.until('it is said', () => document.querySelector('#lesson .part-failed')?.checkVisibility());
      await page.click('#page-lab');
      await page.until('the lab goes on', () => document.getElementById('one-generation')?.checkVisibility());
      assert.equal(await page.evaluate(() => 'lesson' in document.body.dataset), false);
    } finally {
      await page.leave();
      await site.close();
    }
  },
);
