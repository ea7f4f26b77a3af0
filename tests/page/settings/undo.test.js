// What was done is undone and done again, step by step.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { chord, openSettings, setting, summary, type } from '../harness/panel.js';
import { middleOf, read } from '../harness/reading.js';

pageTest('undo and redo step through drags, presets, seeds and settings', async (page) => {
  await openSettings(page);
  const moments = [await read(page)];
  const { x, y } = await middleOf(page, 'goal-position', 'goal-position');
  await page.drag('#goal-position', [
    { x, y },
    { x: x - 30, y: y + 20 },
    { x: x - 60, y: y + 40 },
  ]);
  moments.push(await read(page));
  await page.click('#preset-acceleration-limits');
  moments.push(await read(page));
  await type(page, 'weights-penalty', '10');
  await type(page, 'limits-speed', '1');
  moments.push(await read(page));
  /** @param {Awaited<ReturnType<typeof read>>} moment */
  const told = ({ cost, gains, preset, goal, seed }) => ({ cost, gains, preset, goal, seed });
  const assertAt = async (/** @type {number} */ i) =>
    assert.deepEqual(told(await read(page)), told(moments[i]));

  // The undo of a text field is left to the text field.
  await page.focus('#setting-limits-speed');
  await page.press('7');
  await chord(page, Key.CONTROL, 'z');
  await assertAt(3);
  await chord(page, Key.CONTROL, 'a');
  await page.press('1', Key.ENTER);
  await chord(page, Key.CONTROL, 'z');
  assert.equal((await setting(page, 'limits-speed')).value, '2');
  await page.focus('#settings-button');
  await chord(page, Key.CONTROL, 'z');
  await assertAt(2);
  await chord(page, Key.CONTROL, 'z');
  await assertAt(1);
  await page.click('#settings-undo');
  await assertAt(0);
  assert.equal((await summary(page)).canUndo, false);
  await page.click('#settings-redo');
  await assertAt(1);
  await page.focus('#settings-button');
  await chord(page, Key.CONTROL + Key.SHIFT, 'z');
  await assertAt(2);
  await chord(page, Key.CONTROL, 'y');
  await chord(page, Key.CONTROL, 'y');
  await assertAt(3);
  assert.equal((await summary(page)).canRedo, false);

  // Something new ends what could be done again.
  await page.click('#settings-undo');
  await page.click('#new-seed');
  assert.equal((await summary(page)).canRedo, false);
  await page.click('#settings-undo');
  await page.click('#settings-undo');
  await assertAt(2);
});

pageTest(
  'on Park, where nothing of the lab is in sight, none of it is undone or done again',
  async (page) => {
    const seed = () => page.evaluate(() => new URLSearchParams(location.hash).get('seed'));
    const seedIs = (/** @type {string | null} */ wanted) =>
      page.until(`seed ${wanted}`, (one) => new URLSearchParams(location.hash).get('seed') === one, wanted);
    const at = async (/** @type {string} */ part) => {
      await page.click(`#page-${part}`);
      await page.until('it is open', (name) => document.body.dataset.open === name, part);
    };
    await page.open('#lab&v=1&seed=7');
    await page.click('#new-seed');
    await page.until('another seed', () => !/seed=7(&|$)/.test(location.hash));
    const drawn = await seed();
    await at('park');
    await chord(page, Key.CONTROL, 'z');
    await at('lab');
    await seedIs(drawn);
    await chord(page, Key.CONTROL, 'z');
    await seedIs('7');
    await at('park');
    await chord(page, Key.CONTROL, 'y');
    await at('lab');
    await seedIs('7');
  },
);

pageTest('an arrow key that is held is one step of undo, each press another', async (page) => {
  const { goal } = await read(page);
  await page.focus('#goal-position');
  const { ARROW_UP: up } = Key;
  await page.driver.actions().keyDown(up).keyDown(up).keyDown(up).keyUp(up).perform();
  // The driver of WebKit presses a held key once, the others three times.
  const held = (await read(page)).goal;
  assert.equal(held.y, goal.y + (page.engine === 'webkit' ? 0.1 : 0.3));
  await page.press(Key.ARROW_RIGHT);
  await chord(page, Key.CONTROL, 'z');
  assert.deepEqual((await read(page)).goal, held);
  await chord(page, Key.CONTROL, 'z');
  assert.deepEqual((await read(page)).goal, goal);
});

pageTest(
  'gains from the landscape take the place of those by hand, which one step of undo brings back',
  async (page) => {
    await page.open('#landscape&generation=3&drives=hand&gains=3,1,5');
    const { gains } = await read(page);
    await page.focus('#landscape-map');
    await page.press(Key.ARROW_RIGHT, Key.ENTER);
    await page.click('#page-lab');
    await page.until('others drive', () =>
      document.getElementById('gains-note')?.textContent?.includes('Ctrl+Z'),
    );
    assert.notDeepEqual((await read(page)).gains, gains);
    await chord(page, Key.CONTROL, 'z');
    const back = await read(page);
    assert.deepEqual([back.gains, back.driver, back.generation], [gains, 'hand', '3']);
    assert.doesNotMatch(await page.text('#gains-note'), /Ctrl/);
  },
);
