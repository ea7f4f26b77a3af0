// Keys as other keyboards send them: clickers, keypads, other layouts, Caps Lock, a key that is held.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { readEvolution } from '../harness/reading.js';
import { shownOn } from '../parts/generation-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** A key as another keyboard sends it. @param {Page} page @param {KeyboardEventInit} init */
const send = (page, init) =>
  page.evaluate((init) => {
    document.body.dispatchEvent(new KeyboardEvent('keydown', { bubbles: true, cancelable: true, ...init }));
  }, init);

/** @param {Page} page */
const generationOn = async (page) => Number((await readEvolution(page)).generation);

pageTest('a presenter’s clicker goes from phase to phase where nothing else is meant', async (page) => {
  const phaseAfter = async (/** @type {string} */ key) => {
    await page.press(key);
    return (await shownOn(page)).phase;
  };
  await page.resize(1440, 900);
  await page.open('#generation&v=1&generation=1&phase=parents');
  await page.until('the phases are there', () => document.getElementById('generation-next'));
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'mutation');
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'drive');
  assert.equal(await phaseAfter(Key.PAGE_UP), 'mutation');
  // On a keypad, and from a keyboard that tells no place.
  for (const [key, code, phase] of [
    ['PageDown', 'Numpad3', 'drive'],
    ['PageUp', '', 'mutation'],
  ]) {
    await send(page, { key, code });
    assert.equal((await shownOn(page)).phase, phase, code);
  }
  await page.press('?');
  assert.match(await page.text('#keys-list'), /PageDown/);
  await page.press(Key.ESCAPE);
  // A slider has these keys too.
  await page.focus('#scrub');
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'mutation');
  // A button that was pressed has not.
  await page.click('#generation-phases-drive');
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'tournament');
  await page.click('#generation-back');
  assert.equal(await phaseAfter(Key.PAGE_UP), 'mutation');
  // What scrolls by itself has them while one is in it.
  await page.click('#settings-button');
  await page.focus('#settings-close');
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'drive');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.querySelector('.settings summary')).focus());
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'drive');
  // And a page that is longer than the window scrolls, up to its end.
  await page.open('#generation&v=1&generation=1&phase=mutation');
  await page.resize(500, 400);
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'mutation');
  await page.until('the page has scrolled', () => scrollY > 0);
  await page.evaluate(() => scrollTo(0, document.documentElement.scrollHeight));
  assert.equal(await phaseAfter(Key.PAGE_DOWN), 'drive');
  await page.evaluate(() => scrollTo(0, 0));
  assert.equal(await phaseAfter(Key.PAGE_UP), 'mutation');
});

pageTest('where a key writes no Latin letter, it is known by its place', async (page) => {
  for (const [i, key] of ['ㅜ', 'ื', 'Process'].entries()) {
    await send(page, { key, code: 'KeyN' });
    assert.equal(await generationOn(page), i + 1, key);
  }
  for (const key of ['Dead', 'ç', 'ı']) await send(page, { key, code: 'KeyN' });
  assert.equal(await generationOn(page), 3);
  // Undo too, by place as by letter.
  const first = await page.text('#seed');
  await page.click('#new-seed');
  const second = await page.text('#seed');
  for (const [key, code, seed] of [
    ['я', 'KeyZ', first],
    ['ㅛ', 'KeyY', second],
    ['z', 'KeyY', first],
  ]) {
    await send(page, { key, code, ctrlKey: true });
    assert.equal(await page.text('#seed'), seed, key);
  }
});

pageTest('Caps Lock changes no key, Shift is another, and held only what steps goes on', async (page) => {
  await send(page, { key: 'N', code: 'KeyN', modifierCapsLock: true });
  assert.equal(await generationOn(page), 1);
  for (const key of ['N', 'n']) await send(page, { key, code: 'KeyN', shiftKey: true });
  assert.equal(await generationOn(page), 1);
  await send(page, { key: 'n', code: 'KeyN', repeat: true });
  assert.equal(await generationOn(page), 2);
  await send(page, { key: 's', code: 'KeyS' });
  for (const key of ['s', 'r']) await send(page, { key, repeat: true });
  assert.deepEqual(
    await page.evaluate(() => [
      document.getElementById('settings')?.checkVisibility(),
      document.getElementById('run')?.innerText,
    ]),
    [true, 'Run'],
  );
});
