// The paper's gains, where an exercise hides them, are nowhere: in no table, in nothing that is saved or sent.
import assert from 'node:assert/strict';
import { listed } from '../../../www/kit/segmented.js';
import { parts } from '../../../www/parts/parts.js';
import { lab } from '../../../www/words/index.js';
import { presets } from '../../../www/run/state.js';
import { pageTest } from '../harness/browsers.js';
import { experiment, paperGains, simulate } from '../harness/core.js';
import { ask, heardFrom, inHost, within } from '../harness/host.js';
import { saved } from '../harness/saved.js';
import { everything } from './everything.js';
import { openMaker } from './making.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const pageNames = parts.map(({ name }) => name);

/** What tells the paper's gains or what they cost: with as many digits as the page or a file may write, and in words. */
function ofPaper() {
  /** @type {Set<string>} */
  const numbers = new Set();
  const methods = /** @type {const} */ (['ep', 'arbitrary']);
  for (const preset of presets)
    for (const method of methods) {
      const gains = paperGains(preset, method);
      const { cost } = simulate(experiment(preset), gains);
      for (const value of method === 'ep' ? [...gains, cost.total] : [cost.total])
        for (const digits of [4, 5, 6, 7]) numbers.add(String(Number(value.toPrecision(digits))));
    }
  const names = listed(lab.drivers)
    .filter(({ value }) => value.startsWith('paper-'))
    .flatMap(({ text, hint }) => [text, hint]);
  // A time may be as short.
  const any = [...numbers]
    .filter((number) => /\d.*\d.*\d.*\d/.test(number))
    .map((number) => number.replace('.', '\\.'))
    .join('|');
  return new RegExp(`.{0,30}(?<![\\d.])(?:${any})(?!\\d)|${names.join('|')}`);
}
const pattern = ofPaper();
/** Where a text tells them, if it does. @param {string} text */
const tellsPaper = (text) => pattern.exec(text)?.[0] ?? null;

/** @param {Page} page */
const shownOn = async (page) => (await page.evaluate(everything)).join('\n');

/** Whatever lies over it, as a browser's own list of what was saved. @param {Page} page @param {string} selector */
const press = (page, selector) =>
  page.evaluate((wanted) => /** @type {HTMLElement} */ (document.querySelector(wanted)).click(), selector);

pageTest(
  'nor do they stand in the one file, which has the lesson to read in it until the robots drive',
  async (page) => {
    const file = new URL('../../../dist/ep-locomotion.html', import.meta.url).href;
    for (const [link, isTold] of /** @type {const} */ ([
      ['lab&v=1&drives=paper-ep', true],
      ['lab&v=1&seed=7&hide=paper', false],
    ])) {
      await page.leave();
      await page.visit(`${file}#${link}`);
      await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
      assert.equal(tellsPaper(await shownOn(page)) !== null, isTold, link);
    }
  },
);

pageTest('hidden gains of the paper stand in no view, no table, no file and no code', async (page) => {
  await page.open('#lab&v=1&drives=paper-ep');
  assert.ok(tellsPaper(await shownOn(page)));
  for (const name of pageNames) {
    await page.open(`#${name}&v=1&seed=7&generation=2&runs=20&length=50&evolve=50&hide=paper`);
    assert.equal(tellsPaper(await shownOn(page)), null, name);
    // The page's own checks tell them.
    await press(page, '#keys-button');
    assert.equal(
      await page.evaluate(() => document.querySelectorAll('#keys-checks, #keep-checks').length),
      0,
    );
    await press(page, '#keys-close');
    for (const id of ['luck-run', 'training-evolve']) {
      if (await page.evaluate((button) => !document.getElementById(button)?.checkVisibility(), id)) continue;
      await press(page, `#${id}`);
      await page.until(
        'it has run',
        (button) => {
          const { textContent } = /** @type {HTMLElement} */ (document.getElementById(button));
          return !/Cancel|Stop/.test(textContent ?? '');
        },
        id,
      );
      assert.equal(tellsPaper(await shownOn(page)), null, `${name} after ${id}`);
    }
    await press(page, '#keep-button');
    await page.until('Share is there', () => document.getElementById('keep-open'));
    assert.equal(tellsPaper(await shownOn(page)), null, `${name}: Share`);
    // Park keeps nothing of the lab's run.
    const isLabs = name !== 'park';
    for (const button of isLabs ? ['#keep-save', '#keep-generations', '#keep-drive'] : [])
      assert.equal(tellsPaper(await saved(page, button)), null, `${name}: ${button}`);
    const pictures = await page.evaluate(() => document.querySelectorAll('#keep-pictures li').length);
    for (let i = 1; i <= pictures; i += 1) {
      // Lengths and places are no words.
      const svg = (await saved(page, `#keep-pictures li:nth-child(${i}) button:last-child`)).replace(
        /<[^>]*>/g,
        '\n',
      );
      assert.equal(tellsPaper(svg), null, `${name}: picture ${i}`);
    }
    await press(page, isLabs ? '#keep-code' : '#keep-close');
    if (isLabs) {
      await page.until('the code is there', () => document.querySelector('#code textarea, #code pre'));
      assert.equal(tellsPaper(await shownOn(page)), null, `${name}: code`);
      await press(page, '#code-close');
    }
    for (const id of ['fitness-table', `${name}-table`]) {
      if (await page.evaluate((button) => !document.querySelector(`button#${button}`)?.checkVisibility(), id))
        continue;
      // There is none before there is a picture.
      await page.until(
        `${id} of ${name} is there`,
        (button) => {
          const isOpen = document.querySelector('#table[open]') !== null;
          if (!isOpen) document.getElementById(button)?.click();
          return isOpen;
        },
        id,
      );
      // Of a hundred seeds one comes to any J of four digits; their file has all digits.
      if (id !== 'luck-table') assert.equal(tellsPaper(await shownOn(page)), null, `${name}: ${id}`);
      if (await page.evaluate(() => document.getElementById('table-csv')?.checkVisibility()))
        assert.equal(tellsPaper(await saved(page, '#table-csv')), null, `${name}: CSV of ${id}`);
      await press(page, '#table-close');
    }
    assert.deepEqual(await page.problems(), [], name);
  }
});

pageTest('a figure that hides the paper’s gains sends none, and opens no lesson', async (page) => {
  const link = 'lab&amp;v=1&amp;seed=7&amp;hide=paper&amp;lesson=paper';
  await inHost(
    page,
    `<iframe src="${page.site.address}?embed#${link}" width="800" height="600"></iframe>`,
    async () => {
      await within(page, 0, async () => {
        assert.match(await page.text('#message'), /lesson was left out/);
        assert.equal(tellsPaper(await shownOn(page)), null);
      });
      await ask(page, 0, { type: 'step', generations: 2 });
      await ask(page, 0, { type: 'set', gains: [3, 0, 4] });
      await ask(page, 0, { type: 'read' });
      assert.equal(tellsPaper(JSON.stringify(await heardFrom(page, 0))), null);
    },
  );
});

pageTest('an exercise that is made to hide the paper’s gains has none in its link', async (page) => {
  const gains = paperGains('velocity-limits', 'ep').join(',');
  await openMaker(page, `#lab&v=1&drives=paper-ep&gains=${gains}&pin1=theirs~${gains}&pin2=mine~1,2,3`);
  await page.click('#maker-paper-hidden');
  const link = await page.until('it is hidden', () => {
    const { value } = /** @type {HTMLInputElement} */ (document.getElementById('maker-link'));
    return value.includes('hide=') && value.split('#')[1];
  });
  assert.match(link, /^lab&v=1&pin2=mine~1,2,3&hide=paper$/);
});
