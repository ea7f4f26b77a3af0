// For whom an exercise is made, and what of it is in sight and told meanwhile.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { openMaker } from './making.js';

pageTest(
  'an exercise is made for whoever opens it, and a student’s own link says who works on it',
  async (page) => {
    const values = (/** @type {string[]} */ ...ids) =>
      page.evaluate(
        (names) =>
          names.map(
            (id) => /** @type {HTMLInputElement | null} */ (document.getElementById(id))?.value ?? '',
          ),
        ids,
      );
    await openMaker(page, '?who=s4711#lab&v=1&aim=J%3C8');
    for (const value of await values('maker-link', 'maker-frame')) {
      assert.match(value, /aim=J%3C8/);
      assert.doesNotMatch(value, /who=/);
    }
    await page.click('#maker-preview-size-400x300');
    const shown = await page.until(
      'the figure is there',
      () => /** @type {HTMLIFrameElement | null} */ (document.getElementById('maker-figure'))?.src,
    );
    assert.match(shown, /\?embed#[^?]*aim=J%3C8$/);
    await page.press(Key.ESCAPE);
    await page.click('#keep-button');
    await page.until('Share is there', () => document.getElementById('keep-link')?.checkVisibility());
    assert.match((await values('keep-link'))[0], /\/#lab&v=1&aim=J%3C8&who=s4711$/);
  },
);

pageTest('what hands an exercise out is in sight on a laptop, whatever its line takes', async (page) => {
  await page.resize(1366, 768);
  for (const [link, wanted, id] of [
    ['#park&v=1', '', 'maker-to-lab'],
    ['#lab&v=1', '&aim=J%3C7', 'maker-status'],
  ]) {
    await openMaker(page, link + wanted);
    await page.press(...'Park the robot.');
    await page.until('its foot', (name) => document.getElementById(name), id);
    const below = await page.evaluate((name) => {
      const foot = document.getElementById(name)?.closest('.maker-foot');
      return Number(foot?.getBoundingClientRect().bottom) - innerHeight;
    }, id);
    assert.ok(below <= 0, `${link}: ${below} px below the window`);
  }
});

pageTest('on a tablet held upright it is in sight with what is typed', async (page) => {
  await page.resize(820, 1100);
  await openMaker(page);
  const { task, foot } = await page.evaluate(() => {
    const boxOf = (/** @type {string} */ one) =>
      /** @type {Element} */ (document.querySelector(one)).getBoundingClientRect();
    const [task, copy] = ['#maker-task', '#maker-copy-frame'].map(boxOf);
    return { task: task.bottom, foot: { top: copy.top, bottom: copy.bottom } };
  });
  assert.ok(task < foot.top && foot.bottom <= 1100, JSON.stringify({ task, foot }));
});

pageTest('where many seeds could be tried within a budget of drives, it is told', async (page) => {
  const isTold = () => page.evaluate(() => document.getElementById('maker-seeds')?.innerText ?? '');
  await openMaker(page, '#lab&v=1&aim=J%3C7');
  assert.equal(await isTold(), '');
  await openMaker(page, '#lab&v=1&aim=J%3C7;drives%3C%3D300');
  assert.match(await isTold(), /while the seed or the settings are free/);
  await page.click('#maker-seed-locked');
  assert.match(await isTold(), /the settings/);
  await page.click('#maker-settings-locked');
  assert.equal(await isTold(), '');
  await page.click('#maker-seed-free');
  assert.match(await isTold(), /the seed/);
  await page.click('#maker-run-hidden');
  assert.equal(await isTold(), '');
});

pageTest('where a budget of drives is not counted, or spent before one begins, it is told', async (page) => {
  const isTold = (/** @type {string} */ id) =>
    page.evaluate((one) => document.getElementById(one)?.innerText ?? '', `maker-${id}`);
  await openMaker(page, '#lab&v=1&aim=J%3C7&hide=parts');
  assert.deepEqual([await isTold('uncounted'), await isTold('many')], ['', '']);
  await openMaker(page, '#lab&v=1&aim=J%3C7;drives%3C%3D10&lock=drives');
  assert.match(await isTold('uncounted'), /driven in: other parts, the lesson\. .* lock or hide/);
  assert.match(await isTold('many'), /has taken 20 drives already/);
  await page.click('#maker-parts-hidden');
  assert.match(await isTold('uncounted'), /driven in: the lesson\./);
  await page.click('#maker-paper-hidden');
  assert.equal(await isTold('uncounted'), '');
  await openMaker(page, '#lab&v=1&aim=J%3C7;drives%3C%3D20&lock=drives,lesson');
  assert.match(await isTold('uncounted'), /driven in: other parts\./);
  assert.equal(await isTold('many'), '');
  await openMaker(page, '#lab&v=1&aim=J%3C7;drives%3C%3D10&drives=hand&gains=3,0,4');
  assert.equal(await isTold('many'), '');
  await openMaker(page, '#lab&v=1&aim=J%3C7;drives%3C%3D10&drives=hand&gains=3,0,4&generation=5');
  assert.match(await isTold('many'), /has taken 120 drives already/);
});
