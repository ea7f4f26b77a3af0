import assert from 'node:assert/strict';
import { runFile } from '../../../www/share/run-file.js';
import { links } from '../../../www/lesson/links.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment } from '../harness/core.js';
import { openGroup, openSettings } from '../harness/panel.js';
import { readEvolution } from '../harness/reading.js';
import { saved } from '../harness/saved.js';
import { evolved } from './evolved.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');

/** Opens a file as if it had been chosen. @param {Page} page @param {string} name @param {string} text */
async function choose(page, name, text) {
  await page.evaluate(
    (fileName, content) => {
      const input = /** @type {HTMLInputElement} */ (document.getElementById('keep-file'));
      const transfer = new DataTransfer();
      transfer.items.add(new File([content], fileName));
      input.files = transfer.files;
      input.dispatchEvent(new Event('change'));
    },
    name,
    text,
  );
  await page.until(
    `${name} is dealt with`,
    (fileName) => document.getElementById('keep-status')?.textContent?.includes(fileName),
    name,
  );
  return page.text('#keep-status');
}

engineTest('a run is saved, and opened again as it was', async (page) => {
  await page.open('#lab&seed=5&generation=6');
  await page.focus('#one-back');
  await page.click('#one-back');
  const before = await readEvolution(page);
  assert.equal(before.generation, '5');
  await page.click('#keep-button');
  assert.match(
    await page.text('#keep-status'),
    new RegExp(evolve(experiment({ evolution: { seed: 5 } }), 6).hash),
  );
  const link = await page.evaluate(
    () => /** @type {HTMLInputElement} */ (document.getElementById('keep-link')).value,
  );
  assert.ok(link.endsWith('#lab&v=1&seed=5&generation=5'), link);
  const text = await saved(page, '#keep-save');
  const table = await saved(page, '#keep-generations');
  assert.equal(table.trim().split('\r\n').length, 2 + 1 + 7);
  assert.ok(table.includes(link));

  await page.open();
  await page.click('#keep-button');
  assert.match(
    await choose(page, 'mine.json', text),
    /“mine.json” is open: all 6 generations, and the drive, came out/,
  );
  await page.click('#keep-close');
  assert.deepEqual(await readEvolution(page), before);
  assert.equal(
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('timeline')).max),
    '6',
  );
  assert.deepEqual(await page.problems(), []);
});

pageTest(
  'a drive by hand is saved too: each has a file of its own, and a changed one is refused',
  async (page) => {
    const links = ['gains=3.0594,0.0001,4.1385&drives=hand', 'drives=paper-ep', 'drives=hand&gains=3,1,5'];
    /** @type {string[]} */
    const texts = [];
    /** @type {string[]} */
    const names = [];
    for (const link of links) {
      await page.open(`#lab&v=1&${link}`);
      await page.evaluate(() => {
        /** @this {HTMLAnchorElement} */
        HTMLAnchorElement.prototype.click = function () {
          document.title = this.download;
        };
      });
      await page.click('#keep-button');
      texts.push(await saved(page, '#keep-save'));
      names.push(await page.evaluate(() => document.title));
    }
    assert.equal(new Set(names).size, links.length, names.join());
    for (const name of names) assert.match(name, /^robot-seed-1-generation-0-drive-[0-9a-f]{8}\.json$/);
    const [{ drive }, by] = [texts[0], texts[2]].map((text) => JSON.parse(text));
    assert.deepEqual(drive.gains, [3.0594, 0.0001, 4.1385]);
    assert.match(
      await choose(page, 'hand.json', JSON.stringify({ ...by, drive })),
      /“hand.json” was not opened: it says that its robot drives with the gains .*, but it drives with \[3,1,5\]/,
    );
    assert.match(await choose(page, 'mine.json', texts[0]), /all 0 generations, and the drive, came out/);
  },
);

pageTest('a long run is opened at the generation that was shown when it was saved', async (page) => {
  const many = { ...velocityLimits, evolution: { ...velocityLimits.evolution, population: 300 } };
  const { engine, state } = evolved(many, 150);
  const text = runFile({ ...state, generation: 60 }, engine, links);
  await page.click('#keep-button');
  assert.match(await choose(page, 'long.json', text), /“long.json” is open: all 150 generations/);
  const link = await page.evaluate(
    () => /** @type {HTMLInputElement} */ (document.getElementById('keep-link')).value,
  );
  assert.match(link, /generation=60(&|$)/, 'on the way there too');
  await page.click('#keep-close');
  await page.until('evolution rests', () => document.getElementById('run')?.textContent === 'Run');
  await page.until('the link', () => /generation=60(&|$)/.test(location.hash));
  assert.deepEqual(await readEvolution(page), {
    generation: '60',
    seed: '1',
    ...evolve(many, 60).shown,
  });
  // The whole run is there, the link is that of what is shown, and how to go on is still as it was chosen.
  const { last, pace, until } = await page.evaluate(() => {
    const value = (/** @type {string} */ id) =>
      /** @type {HTMLSelectElement} */ (document.getElementById(id)).value;
    const timeline = /** @type {HTMLInputElement} */ (document.getElementById('timeline'));
    return { last: timeline.max, pace: value('pace'), until: value('until') };
  });
  assert.deepEqual([last, pace, until], ['150', '8', 'every']);
  await page.click('#keep-button');
  assert.match(await page.text('#keep-status'), new RegExp(engine.hash()));
});

pageTest('a file that is no run changes nothing and says why', async (page) => {
  await page.click('#one-generation');
  const before = await readEvolution(page);
  await page.click('#keep-button');
  assert.match(await choose(page, 'photo.json', '{"a": 1}'), /“photo.json” was not opened: it is no run/);
  assert.match(
    await choose(page, 'hand-in.txt', 'ep-locomotion hand-in\nhttp://host/#lab&v=1&handin=1~8'),
    /“hand-in.txt” was not opened: it is a hand-in: “Check hand-ins” reads it/,
  );
  await page.click('#keep-close');
  assert.deepEqual(await readEvolution(page), before);
  assert.deepEqual(await page.obstacles(), []);
});

pageTest(
  'a file that is read when the sheet is closed, or another is chosen, changes nothing',
  async (page) => {
    await page.click('#keep-button');
    await page.evaluate(() => {
      const read = Blob.prototype.text;
      /** @type {(() => void)[]} */
      const late = [];
      Object.assign(window, { late });
      /** @this {Blob} */
      Blob.prototype.text = function () {
        const isLate = this instanceof File && this.name.startsWith('late');
        return isLate ? new Promise((resolve) => late.push(() => resolve('{"a": 1}'))) : read.call(this);
      };
    });
    const give = (/** @type {string} */ name) =>
      page.evaluate((fileName) => {
        const input = /** @type {HTMLInputElement} */ (document.getElementById('keep-file'));
        const transfer = new DataTransfer();
        transfer.items.add(new File(['{}'], fileName));
        input.files = transfer.files;
        input.dispatchEvent(new Event('change'));
      }, name);
    /** Now all that is late can be read. What is seen then. */
    const comes = () =>
      page.evaluate(async () => {
        const { late } = /** @type {{ late: (() => void)[] }} */ (/** @type {unknown} */ (window));
        const count = late.length;
        for (const arrive of late.splice(0)) arrive();
        await new Promise((resolve) => requestAnimationFrame(resolve));
        const { open } = /** @type {HTMLDialogElement} */ (document.getElementById('keep'));
        return { count, open, status: document.getElementById('keep-status')?.textContent ?? '' };
      });

    await give('late 1.json');
    await page.until('it says that it reads', () =>
      /^The file is read/.test(document.getElementById('keep-status')?.textContent ?? ''),
    );
    await choose(page, 'photo.json', '{"a": 1}');
    const other = await comes();
    assert.deepEqual([other.count, other.open], [1, true]);
    assert.match(other.status, /^“photo.json” was not opened/);

    await give('late 2.json');
    await page.click('#keep-close');
    await page.click('#one-generation');
    const closed = await comes();
    assert.deepEqual([closed.count, closed.open], [1, false]);
    await page.click('#keep-button');
    assert.match(await page.text('#keep-status'), /^Fingerprint of generations 0 to 1:/);
  },
);

pageTest('Share has the link of what was set, once that has been computed', async (page) => {
  // Open for the second time, it is there at once.
  await page.click('#keep-button');
  await page.click('#keep-close');
  await openSettings(page);
  await openGroup(page, 'evolution');
  await page.evaluate(() => {
    const field = /** @type {HTMLInputElement} */ (document.getElementById('setting-evolution-population'));
    field.value = '2000';
    field.dispatchEvent(new Event('change'));
    document.getElementById('keep-button')?.click();
  });
  await page.until('the link has it', () =>
    /population=2000/.test(/** @type {HTMLInputElement} */ (document.getElementById('keep-link')).value),
  );
  const { hash } = evolve({
    ...velocityLimits,
    evolution: { ...velocityLimits.evolution, population: 2000 },
  });
  assert.match(await page.text('#keep-status'), new RegExp(hash));
});
