import assert from 'node:assert/strict';
import { engineTest } from '../harness/browsers.js';
import { readEvolution } from '../harness/reading.js';
import { saved } from '../harness/saved.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Drops a file on the page, and tells of each event whether the page took it: else the browser would leave the page for the file. @param {Page} page @param {string} text */
const drop = (page, text) =>
  page.evaluate((content) => {
    const transfer = new DataTransfer();
    transfer.items.add(new File([content], 'dropped.json'));
    return ['dragover', 'drop'].map((type) => {
      const event = new DragEvent(type, { dataTransfer: transfer, bubbles: true, cancelable: true });
      document.getElementById('plane-robots')?.dispatchEvent(event);
      return event.defaultPrevented;
    });
  }, text);

engineTest('a run that is dropped on the page is opened, but where Share is locked', async (page) => {
  await page.open('#lab&seed=5&generation=3');
  const before = await readEvolution(page);
  await page.click('#keep-button');
  const text = await saved(page, '#keep-save');

  await page.open('#lab&lock=share');
  // It does not go out before the next look.
  await page.evaluate(() => {
    setInterval(() => document.getElementById('exercise-locks')?.getAnimations()[0]?.pause(), 50);
  });
  assert.deepEqual(await drop(page, text), [true, true]);
  await page.until(
    'the line that says so lights up',
    () => document.getElementById('exercise-locks')?.getAnimations().length,
  );
  await page.click('#one-generation');
  await page.until('evolution went on', () => document.getElementById('generation')?.textContent === '1');
  assert.equal(await page.evaluate(() => document.querySelector('dialog[open]')), null);

  await page.open('#lab&drives=hand&gains=7.25,1,5');
  assert.deepEqual(await drop(page, text), [true, true]);
  await page.until('it is dealt with', () =>
    document.getElementById('keep-status')?.textContent?.includes('“dropped.json”'),
  );
  assert.match(await page.text('#keep-status'), /“dropped.json” is open: all 3 generations/);
  await page.click('#keep-close');
  assert.deepEqual(await readEvolution(page), before);
  // What was there is not lost, however soon one goes back.
  await page.open('#lab&drives=hand&gains=7.25,1,5');
  await drop(page, text);
  await page.until('it is dealt with, and left at once', () => {
    if (!document.getElementById('keep-status')?.textContent?.includes('“dropped.json”')) return false;
    history.back();
    return true;
  });
  await page.until('the gains by hand are there again', () => {
    const field = /** @type {HTMLInputElement | null} */ (document.getElementById('gain-kx'));
    return location.hash.includes('gains=7.25') && field?.value.startsWith('7.25');
  });
  assert.deepEqual(await page.problems(), []);
});
