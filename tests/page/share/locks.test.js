// What an exercise locks cannot be done by a way round.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { read, waysOf } from '../harness/reading.js';

pageTest('a locked clock stands still, also for who moves over the curves', async (page) => {
  for (const view of ['time', 'stability'])
    for (const lock of ['lock', 'hide']) {
      await page.open(`#curves&v=1&view=${view}&${lock}=clock`);
      const clock = () =>
        page.evaluate(async () => {
          for (let frame = 0; frame < 2; frame += 1)
            await new Promise((resolve) => requestAnimationFrame(resolve));
          // The bar may be hidden: where the robot is, is said in words.
          return document.getElementById('plane-text')?.textContent;
        });
      const picture = view === 'time' ? '#curves-picture' : '#stability-picture';
      await page.until('the robot has arrived', () => {
        const [, now, end] =
          /([\d.]+) of ([\d.]+) s/.exec(document.getElementById('plane-text')?.textContent ?? '') ?? [];
        return now !== undefined && now === end;
      });
      const before = await clock();
      await page.drag(picture, [
        { x: 60, y: 60 },
        { x: 90, y: 60 },
      ]);
      assert.equal(await clock(), before, `${view}, ${lock}`);
    }
});

pageTest(
  'who may not open another part sees whole generations, not their phases in Generation',
  async (page) => {
    await page.open('#lab&v=1&lock=parts&task=Stay');
    await page.evaluate(() => {
      const pace = /** @type {HTMLSelectElement} */ (document.getElementById('pace'));
      pace.value = '0';
      pace.dispatchEvent(new Event('change'));
    });
    await page.click('#run');
    await page.until('evolution goes on', () => document.getElementById('generation')?.textContent !== '0');
    assert.deepEqual(
      await page.evaluate(() => [
        document.body.dataset.open,
        /** @type {HTMLSelectElement} */ (document.getElementById('pace')).value,
      ]),
      ['lab', '1'],
    );
  },
);

pageTest('start, goal and seed that are locked are locked in the settings too', async (page) => {
  await page.open('#lab&v=1&seed=7&lock=postures,seed&task=Stay');
  const before = await read(page);
  await page.click('#settings-button');
  await page.until('the settings are there', () => document.getElementById('setting-goal-x'));
  await page.evaluate(() => {
    for (const group of document.querySelectorAll('details')) group.open = true;
  });
  assert.deepEqual(
    await waysOf(
      page,
      '#setting-goal-x',
      '#setting-starts-0-x',
      '#setting-evolution-seed',
      '#settings-preset',
    ),
    Array(4).fill('locked'),
  );
  assert.deepEqual(await waysOf(page, '#setting-evolution-population'), ['free']);
  await page.evaluate(() => {
    const goal = /** @type {HTMLInputElement} */ (document.getElementById('setting-goal-x'));
    goal.value = '0.3';
    goal.dispatchEvent(new Event('change', { bubbles: true }));
  });
  assert.deepEqual(await read(page), before);
});

pageTest('the table of Training holds to what is locked', async (page) => {
  await page.open('#training&v=1&lock=gains,drives&task=Stay');
  const rows = ['paper-ep', 'paper-arbitrary'];
  const chosen = () => page.evaluate(() => document.querySelector('#training-table tr.chosen')?.id ?? 'none');
  const before = [await chosen(), (await read(page)).driver];
  for (const row of rows) await page.click(`#training-${row} .training-unseen`);
  assert.deepEqual([await chosen(), (await read(page)).driver], before);
  assert.deepEqual(
    await waysOf(page, ...rows.map((row) => `#training-${row} .training-name`)),
    rows.map(() => 'locked'),
  );
});
