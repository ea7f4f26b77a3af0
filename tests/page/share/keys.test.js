import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment } from '../harness/core.js';
import { read, readEvolution } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const expected = (/** @type {number} */ generation) => ({
  generation: String(generation),
  seed: '1',
  ...evolve(experiment('velocity-limits'), generation).shown,
});

/** What is open, what runs, and where the focus is, once all that was pressed is drawn. @param {Page} page */
const stateOf = (page) =>
  page.evaluate(async () => {
    const element = (/** @type {string} */ id) => /** @type {HTMLElement} */ (document.getElementById(id));
    return {
      sheet: /** @type {HTMLDialogElement} */ (element('keys')).open,
      settings: element('settings').checkVisibility(),
      evolving: element('run').innerText === 'Pause',
      driving: element('play').classList.contains('playing'),
      focus: document.activeElement?.id ?? '',
    };
  });

/** Nothing moves, nothing is open, nothing has the focus. @param {Page} page */
async function rest(page) {
  if ((await stateOf(page)).driving) await page.press('p');
  const still = await stateOf(page);
  assert.deepEqual(still, { sheet: false, settings: false, evolving: false, driving: false, focus: '' });
  return still;
}

pageTest('"?" opens the sheet, Escape closes it, and the focus goes back to where it was', async (page) => {
  for (const id of ['one-generation', 'slider-ky', 'goal-position', 'preset-velocity-limits']) {
    await page.focus(`#${id}`);
    await page.press('?');
    const { sheet, focus } = await stateOf(page);
    assert.deepEqual([sheet, focus !== id], [true, true], id);
    await page.press(Key.ESCAPE);
    assert.deepEqual(await stateOf(page).then((state) => [state.sheet, state.focus]), [false, id]);
  }
  await page.click('#keys-button');
  assert.equal((await stateOf(page)).sheet, true);
  assert.deepEqual(await page.obstacles(), []);
  await page.click('#keys-close');
  assert.equal((await stateOf(page)).sheet, false);
});

pageTest('each single key does what the sheet says, and no key is missing there', async (page) => {
  await page.press('?');
  const lines = await page.evaluate(() =>
    [...document.querySelectorAll('#keys-list dt')].map((term) => [
      term.textContent,
      term.nextElementSibling?.textContent,
    ]),
  );
  const single = lines.filter(([key]) => /^[a-z]$/.test(key ?? ''));
  assert.deepEqual(single, [
    ['r', 'run evolution, or pause it'],
    ['n', '1 generation'],
    ['b', '1 generation back; with some presenters’ clickers the key for a black screen'],
    ['p', 'let the robots drive, or hold them'],
    ['s', 'settings'],
  ]);
  // While the sheet is open no key acts behind it.
  await page.press('n', 's');
  await page.press(Key.ESCAPE);
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  const still = await rest(page);
  assert.deepEqual(await readEvolution(page), expected(0));

  await page.press('n', 'n', 'n');
  assert.deepEqual(await readEvolution(page), expected(3));
  await page.press('b');
  assert.deepEqual(await readEvolution(page), expected(2));
  await page.press('n');
  // No drive ends by itself meanwhile.
  await page.setPace(0.001);
  if ((await stateOf(page)).driving) await page.press('p');
  await page.press('p');
  assert.equal((await stateOf(page)).driving, true);
  await page.press('p');
  const { time } = await read(page);
  assert.deepEqual(await stateOf(page), still);
  assert.equal((await read(page)).time, time);

  // Nor does evolution, at generation 100.
  await page.setPace(0.2);
  await page.press('r');
  assert.equal((await stateOf(page)).evolving, true);
  await page.until('evolution goes on', () => Number(document.getElementById('generation')?.innerText) > 3);
  await page.press('r');
  assert.equal((await stateOf(page)).evolving, false);
  const { generation } = await readEvolution(page);
  assert.deepEqual(await readEvolution(page), expected(Number(generation)));

  await page.press('s');
  assert.equal((await stateOf(page)).settings, true);
  await page.press('s');
  assert.equal((await stateOf(page)).settings, false);
  await page.press('s', Key.ESCAPE);
  assert.deepEqual(await stateOf(page).then(({ settings, focus }) => [settings, focus]), [
    false,
    'settings-button',
  ]);
});

pageTest('the box in the sheet turns the single keys off, not the sheet', async (page) => {
  await page.press('?');
  await page.focus('#keys-single');
  await page.press(' ');
  await page.press(Key.ESCAPE);
  await page.press('n', 's', 'r', 'b', 'p');
  const { settings, evolving } = await stateOf(page);
  assert.deepEqual([settings, evolving], [false, false]);
  assert.deepEqual(await readEvolution(page), expected(0));
  // Also in the other language.
  await page.click('#language');
  await page.until(
    'it speaks Korean',
    () => document.documentElement.lang === 'ko' && document.documentElement.dataset.ready,
  );
  await page.press('n', 's');
  assert.deepEqual(await readEvolution(page), expected(0));
  await page.press('?');
  assert.equal((await stateOf(page)).sheet, true);
  await page.focus('#keys-single');
  await page.press(' ');
  await page.press(Key.ESCAPE);
  await page.press('n');
  assert.deepEqual(await readEvolution(page), expected(1));
});

engineTest('no key acts while one types in a field or chooses from a list', async (page) => {
  await page.focus('#gain-kx');
  await page.press('n', 'r', 's', 'b', 'p', '?');
  await page.focus('#speed');
  await page.press('n', 's', '?');
  await page.press('s');
  const { sheet, settings, evolving } = await stateOf(page);
  assert.deepEqual([sheet, settings, evolving], [false, false, false]);
  const { generation, gains } = await readEvolution(page);
  assert.deepEqual([generation, gains[0]], ['0', 'nrsbp?']);
  // With Ctrl, Alt or Meta they are the browser's.
  await page.focus('#one-generation');
  await page.evaluate(() => {
    for (const held of ['ctrlKey', 'altKey', 'metaKey'])
      document.activeElement?.dispatchEvent(
        new KeyboardEvent('keydown', { key: 'n', bubbles: true, [held]: true }),
      );
  });
  assert.equal((await readEvolution(page)).generation, '0');
});

pageTest('a key presses only what is in sight', async (page) => {
  await page.click('#page-luck');
  await page.until('the part is open', () => document.body.dataset.open === 'luck');
  await page.press('n', 'r');
  assert.equal((await stateOf(page)).evolving, false);
  await page.click('#page-lab');
  await page.until('the lab is open', () => document.body.dataset.open === 'lab');
  assert.deepEqual(await readEvolution(page), expected(0));
});

pageTest('where evolution goes on away from its bar, “r” and a button in the head pause it', async (page) => {
  const canPause = () =>
    page.evaluate(() => document.getElementById('pause-evolution')?.checkVisibility() === true);
  const listed = async () => {
    await page.press('?');
    const keys = await page.evaluate(() =>
      [...document.querySelectorAll('#keys-list dt')].map(({ textContent }) => textContent),
    );
    await page.press(Key.ESCAPE);
    return keys.includes('r');
  };
  await page.open();
  await page.setPace(0.01);
  for (const part of ['curves', 'robustness', 'training', 'disturbance', 'luck', 'park']) {
    await page.press('r');
    assert.deepEqual([await canPause(), await listed()], [false, true], 'the bar of evolution is there');
    await page.click(`#page-${part}`);
    await page.until('the part is open', (name) => document.body.dataset.open === name, part);
    assert.deepEqual([await canPause(), await listed()], [true, true], part);
    if (part === 'curves') await page.click('#pause-evolution');
    else await page.press('r');
    assert.deepEqual([await canPause(), await listed()], [false, false], part);
    await page.press('r');
    await page.click('#page-lab');
    await page.until('the lab is open', () => document.body.dataset.open === 'lab');
    assert.equal((await stateOf(page)).evolving, false, part);
  }
});

pageTest('what has the focus in Share is never under what is said at its foot', async (page) => {
  /** @type {string[]} */
  const covered = [];
  for (const [width, height] of [
    [1440, 900],
    [640, 360],
  ]) {
    await page.resize(width, height);
    await page.open();
    await page.click('#keep-button');
    await page.until('the fingerprint is told', () => document.getElementById('keep-status')?.textContent);
    await page.focus('#keep-exercise');
    for (let i = 0; i < 12; i += 1) {
      await page.press(Key.TAB);
      const under = await page.evaluate(() => {
        const focused = document.activeElement;
        if (!focused?.closest('dialog')) return '';
        const { left, top, width, height } = focused.getBoundingClientRect();
        const isSeen = [0.1, 0.9].every((part) =>
          focused.contains(document.elementFromPoint(left + width / 2, top + part * height)),
        );
        return isSeen ? '' : focused.id || focused.ariaLabel;
      });
      if (under) covered.push(`${under} at ${width} × ${height}`);
    }
  }
  assert.deepEqual(covered, []);
});

pageTest('“back” leaves a sheet with the part that it is of', async (page) => {
  await page.open();
  const isOpen = () => page.evaluate(() => document.querySelector('dialog[open]') !== null);
  for (const [part, button] of [
    ['landscape', '#keep-button'],
    ['generation', '#generation-table'],
  ]) {
    await page.click(`#page-${part}`);
    await page.until('its link is written', (name) => location.hash.startsWith(`#${name}`), part);
    await page.click(button);
    assert.equal(await isOpen(), true, button);
    await page.evaluate(() => history.back());
    await page.until('the lab is there again', () => location.hash.startsWith('#lab'));
    await page.until('the sheet is closed', () => document.querySelector('dialog[open]') === null);
  }
});
