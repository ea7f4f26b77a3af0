// The panel of settings: by keyboard, and in its place.
import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { assertBegun, chord, openGroup, openSettings, setting, summary, type } from '../harness/panel.js';
import { read } from '../harness/reading.js';
import { holdWorkers } from '../harness/workers.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */

const velocityLimits = experiment('velocity-limits');

engineTest('the panel is opened, used and closed with the keyboard alone', async (page) => {
  const isOpen = () =>
    page.evaluate(async () => {
      return document.getElementById('settings')?.checkVisibility() === true;
    });
  const focused = () => page.evaluate(() => document.activeElement?.id);
  const pathHas = async (/** @type {string} */ wanted) => {
    for (let i = 0; i < 12 && (await focused()) !== wanted; i += 1) await page.press(Key.TAB);
    assert.equal(await focused(), wanted);
  };
  assert.equal(await isOpen(), false);
  await page.focus('#settings-button');
  await page.press(Key.ENTER);
  assert.equal(await isOpen(), true);
  assert.equal(await focused(), 'settings-button');
  await pathHas('setting-limits-speed');
  await page.press('1', Key.TAB);
  await assertBegun(page, { ...velocityLimits, limits: { ...velocityLimits.limits, speed: 1 } });
  await pathHas('setting-limits-speed-slider');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  assert.equal((await setting(page, 'limits-speed')).value, '1.1');
  await assertBegun(page, { ...velocityLimits, limits: { ...velocityLimits.limits, speed: 1.1 } });
  await page.press(Key.ESCAPE);
  assert.equal(await isOpen(), false);
  assert.equal(await focused(), 'settings-button');
  assert.equal(await page.text('#settings-button'), 'Settings · 1');
  await page.press(' ');
  assert.equal(await isOpen(), true);
});

for (const [width, height] of /** @type {const} */ ([
  [1440, 900],
  [1024, 768],
]))
  engineTest(`the open panel makes the page no taller at ${width} × ${height}`, async (page) => {
    await page.resize(width, height);
    const tall = () => page.evaluate(() => document.documentElement.scrollHeight);
    const closed = await tall();
    await openSettings(page);
    for (const group of ['task', 'arrival', 'evolution']) await openGroup(page, group);
    await summary(page);
    assert.equal(await tall(), closed);
  });

pageTest(
  'while an experiment is computed the panel shows what was set, and once it is stopped what is there',
  async (page) => {
    const starts = Array.from({ length: 150 }, (_, i) => `${i % 9},${i % 8},0`).join(';');
    await page.open(`#lab&v=1&population=2&start=${starts}`);
    await holdWorkers(page);
    await openSettings(page);
    await openGroup(page, 'evolution');
    const before = await summary(page);
    await type(page, 'evolution-population', '2000');
    await type(page, 'weights-penalty', '10');
    await page.click('#preset-acceleration-limits');
    const set = await page.until('it says what it computes, and is stopped', () => {
      const place = document.getElementById('computing');
      if (!place || place.hidden) return null;
      const held = (/** @type {string} */ id) =>
        /** @type {HTMLInputElement} */ (document.getElementById(id)).value;
      const { checked } = /** @type {HTMLInputElement} */ (
        document.getElementById('preset-acceleration-limits')
      );
      place.querySelector('button')?.click();
      return [held('setting-evolution-population'), held('setting-weights-penalty'), checked];
    });
    assert.deepEqual(set, ['2000', '10', true]);
    await page.until('it has stopped, and says so', () =>
      /^Stopped: what was here before stays/.test(document.getElementById('message')?.textContent ?? ''),
    );
    assert.equal((await setting(page, 'evolution-population')).value, '2');
    assert.equal((await setting(page, 'weights-penalty')).value, String(velocityLimits.weights.penalty));
    assert.deepEqual(await summary(page), before);
    assert.equal((await read(page)).preset, 'velocity-limits');
  },
);

pageTest(
  'the panel is gone beside Park, of which it sets nothing, and stands beside the next part',
  async (page) => {
    const isThere = () =>
      page.evaluate(() => document.getElementById('settings')?.checkVisibility() === true);
    await openSettings(page);
    assert.equal(await isThere(), true);
    await page.click('#page-park');
    await page.until('Park is there', () => document.getElementById('park-count')?.checkVisibility());
    assert.equal(await isThere(), false);
    // There is nothing there that Escape could close.
    await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
    await page.press(Key.ESCAPE);
    await page.click('#page-curves');
    await page.until('it is there again', () => document.getElementById('settings')?.checkVisibility());
  },
);

pageTest('Escape closes the panel, and takes nothing that was only typed', async (page) => {
  await page.click('#one-generation');
  await openSettings(page);
  await page.focus('#setting-weights-penalty');
  await page.press('7', Key.ESCAPE);
  await page.until('it is closed', () => !document.getElementById('settings')?.checkVisibility());
  assert.equal(await page.text('#generation'), '1');
  await openSettings(page);
  const { value } = await setting(page, 'weights-penalty');
  assert.equal(value, String(velocityLimits.weights.penalty));
});

pageTest('nothing is undone behind a sheet that is open', async (page) => {
  await page.click('#new-seed');
  const seed = await page.text('#seed');
  await page.click('#keys-button');
  await chord(page, Key.CONTROL, 'z');
  await page.press(Key.ESCAPE);
  await page.until('it is closed', () => document.querySelector('dialog[open]') === null);
  assert.equal(await page.text('#seed'), seed);
});
