// What an exercise hides is nowhere: in no corner of the document, read aloud, in no table, in nothing that is saved or sent.
import assert from 'node:assert/strict';
import { parts } from '../../../www/parts/parts.js';
import { lab } from '../../../www/words/index.js';
import { groupNames } from '../../../www/run/exercise.js';
import { presets } from '../../../www/run/state.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { experiment, paperGains, simulate } from '../harness/core.js';
import { ask, heardFrom, inHost, within } from '../harness/host.js';
import { saved } from '../harness/saved.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/run/exercise.js').Group} Group */

const pageNames = parts.map(({ name }) => name);

/**
 * Where each group has its controls: a link, without v, and the controls as selectors. It is written by hand, so that it does
 * not know what the page believes to be its controls.
 * @type {Record<Group, [link: string, selector: string][]>}
 */
const controls = {
  gains: [
    ['lab', '#slider-kx, #gain-kx, #slider-ky, #gain-ky, #slider-ktheta, #gain-ktheta, #gains-note'],
    ['curves&view=stability', '#slider-kx, #gain-ktheta'],
    ['park', '#park-kx, #park-ky, #park-ktheta'],
  ],
  drives: [
    ['lab', '#drives-evolved, #drives-hand, #drives-paper-ep, #drives-paper-arbitrary'],
    ['robustness', '#drives-evolved, #drives-hand'],
  ],
  paper: [
    ['lab', '#drives-paper-ep, #drives-paper-arbitrary, #page-lesson'],
    ['disturbance', '#drives-paper-ep, #drives-paper-arbitrary'],
  ],
  postures: [['lab&goal.x=3', '#goal-position, #goal-heading, #start-position, #restore-postures']],
  run: [
    ['lab', '#run, #one-generation, #one-back, #timeline, #until, #pace, #reset'],
    ['generation', '#generation-step button, #run'],
    ['training', '#training-evolve'],
    ['luck', '#luck-run'],
    ['luck&luck=contest', '#contest-run'],
    ['park', '#park-evolve'],
  ],
  seed: [
    ['lab', '#new-seed'],
    ['landscape', '#new-seed'],
  ],
  clock: [
    ['lab', '#play, #speed, #scrub, #robot-clock input'],
    ['curves', '#play, #robot-clock input'],
  ],
  settings: [
    ['lab', '#settings-button, #preset input'],
    ['disturbance', '#disturbance-controls input, #disturbance-controls select'],
    ['lab&lesson=cost', '#weights input'],
  ],
  parts: pageNames.map((name) => [name, pageNames.map((other) => `#page-${other}`).join(', ')]),
  lesson: [
    ['lab', '#page-lesson'],
    ['lab&lesson=drive', '#lesson-step, .step-on, .tries a'],
  ],
  share: [['lab', '#keep-button']],
};

/** What can be found of the document, of all of its shadow trees, and of what hangs on no style: the names of things, and what is said of them. */
function everything() {
  /** @type {Set<string>} */
  const found = new Set();
  const add = (/** @type {string | null | undefined} */ text) => {
    const tidy = text?.replace(/\s+/g, ' ').trim();
    if (tidy) found.add(tidy);
  };
  const look = (/** @type {Document | ShadowRoot} */ root) => {
    const walker = document.createTreeWalker(
      root,
      NodeFilter.SHOW_ELEMENT | NodeFilter.SHOW_TEXT | NodeFilter.SHOW_COMMENT,
    );
    for (let node = walker.nextNode(); node; node = walker.nextNode()) {
      if (!(node instanceof Element)) {
        if (!node.parentElement?.matches('script, style')) add(node.nodeValue);
        continue;
      }
      for (const { name, value } of node.attributes) {
        if (name === 'id') add(`#${value}`);
        else if (/^(aria-|title|alt|placeholder|value|label|data-)/.test(name)) add(value);
      }
      if (node instanceof HTMLInputElement || node instanceof HTMLTextAreaElement) add(node.value);
      if (node.shadowRoot) look(node.shadowRoot);
    }
  };
  look(document);
  add(document.title);
  return [...found];
}

/** Names of controls, and what is said of them. @param {string} selector */
function namesOf(selector) {
  /** @type {Set<string>} */
  const names = new Set();
  for (const element of document.querySelectorAll(selector)) {
    const label = element instanceof HTMLInputElement ? element.labels?.[0] : null;
    const said = [element.getAttribute('aria-label'), element.getAttribute('title'), label?.textContent];
    if (!(element instanceof HTMLInputElement)) said.push(element.textContent);
    for (const text of said) if (text?.trim()) names.add(text.replace(/\s+/g, ' ').trim());
    if (element.id) names.add(`#${element.id}`);
  }
  return [...names];
}

/** @param {string} link @param {string} more */
const withKeys = (link, more) => {
  const [page, ...keys] = link.split('&');
  return `#${[page, 'v=1', ...keys, more].filter((text) => text !== '').join('&')}`;
};

pageTest('the controls of a hidden group stand nowhere in the document', async (page) => {
  for (const group of groupNames)
    for (const [link, selector] of controls[group]) {
      await page.open(withKeys(link, ''));
      const names = await page.evaluate(namesOf, selector);
      assert.ok(names.length > 0, `${group}: ${selector} finds nothing in ${link}`);
      const elsewhere = await page.evaluate((wanted) => {
        for (const element of document.querySelectorAll(wanted))
          (element.closest('label') ?? element).remove();
      }, selector);
      assert.equal(elsewhere, null);
      // Another thing may have the same name.
      const others = await page.evaluate(everything);
      const own = names.filter((name) => name.startsWith('#') || !others.includes(name));
      await page.open(withKeys(link, `hide=${group}`));
      await page.click('#keys-button');
      const found = await page.evaluate(everything);
      assert.deepEqual(
        own.filter((name) => found.includes(name)),
        [],
        `${group}: ${link}`,
      );
      assert.deepEqual(await page.problems(), [], `${group}: ${link}`);
    }
});

engineTest('what is hidden comes back with a link that shows it, and works', async (page) => {
  await page.open(`#lab&v=1&seed=7&hide=${groupNames.join(',')}`);
  assert.equal(
    await page.evaluate(
      () => document.querySelectorAll('#gains, #drives, #evolving, #pages a, #keep-button').length,
    ),
    0,
  );
  // Through a part that is loaded while all of it is away.
  for (const link of ['curves&v=1&hide=gains,parts', 'luck&v=1&hide=gains,run', 'lab&v=1&seed=7']) {
    await page.evaluate((hash) => {
      location.hash = hash;
    }, link);
    await page.until('it is there', (name) => document.body.dataset.open === name, link.split('&')[0]);
  }
  await page.until('the lab is whole', () => document.getElementById('gains')?.checkVisibility());
  assert.equal(await page.evaluate(() => document.getElementById('luck')?.checkVisibility()), false);
  await page.click('#one-generation');
  await page.until('it evolves', () => document.getElementById('generation')?.textContent === '1');
  await page.click('#page-curves');
  await page.until('the part is there', () => document.getElementById('curves-section')?.checkVisibility());
  const seen = await page.evaluate(() =>
    ['gains', 'drives', 'evolving', 'cost'].filter((id) => document.getElementById(id)?.checkVisibility()),
  );
  assert.deepEqual(seen, ['drives']);
  assert.match(
    await page.evaluate(() => document.getElementById('page-luck')?.getAttribute('href') ?? ''),
    /^#luck&v=1&seed=7/,
  );
  assert.deepEqual(await page.problems(), []);
});

pageTest('a control that its view frees while it is locked stays locked', async (page) => {
  await page.open('#park&v=1&lock=run');
  const evolve = () =>
    page.evaluate(() => /** @type {HTMLButtonElement} */ (document.getElementById('park-evolve')).disabled);
  assert.equal(await evolve(), true);
  await page.evaluate(() => {
    const kx = /** @type {HTMLInputElement} */ (document.getElementById('park-kx'));
    kx.value = '5';
    kx.dispatchEvent(new Event('input', { bubbles: true }));
  });
  await page.until('the slider has moved', () =>
    document.querySelector('output[for="park-kx"]')?.textContent?.startsWith('5'),
  );
  assert.equal(await evolve(), true);
  await page.evaluate(() => {
    location.hash = 'park&v=1';
  });
  await page.until(
    'it is free',
    () => !(/** @type {HTMLButtonElement} */ (document.getElementById('park-evolve')).disabled),
  );
});

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
  const names = lab.drivers
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

pageTest('hidden gains of the paper stand in no view, no table, no file and no code', async (page) => {
  await page.open('#lab&v=1&drives=paper-ep');
  assert.ok(tellsPaper(await shownOn(page)));
  for (const name of pageNames) {
    await page.open(`#${name}&v=1&seed=7&generation=2&hide=paper`);
    assert.equal(tellsPaper(await shownOn(page)), null, name);
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
    await page.until('Share is there', () => document.getElementById('keep-save'));
    assert.equal(tellsPaper(await shownOn(page)), null, `${name}: Share`);
    for (const button of ['#keep-save', '#keep-generations', '#keep-drive'])
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
    await press(page, '#keep-code');
    await page.until('the code is there', () => document.querySelector('#code textarea, #code pre'));
    assert.equal(tellsPaper(await shownOn(page)), null, `${name}: code`);
    await press(page, '#code-close');
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
