// What an exercise hides is nowhere: in no corner of the document, read aloud, in no table, in nothing that is saved or sent.
import assert from 'node:assert/strict';
import { parts } from '../../../www/parts/parts.js';
import { groupNames } from '../../../www/run/exercise.js';
import { pageTest } from '../harness/browsers.js';
import { samples } from '../parts/samples.js';
import { everything } from './everything.js';

/** @typedef {import('../../../www/run/exercise.js').Group} Group */

const pageNames = parts.map(({ name }) => name);

/**
 * Where each group has its controls besides those that stand in the open part: a link, without v, and the controls as selectors.
 * @type {Record<Group, [link: string, selector: string][]>}
 */
const controls = {
  gains: [['lab', '#slider-kx, #gain-kx, #slider-ky, #gain-ky, #slider-ktheta, #gain-ktheta, #gains-note']],
  drives: [['lab', '#drives-evolved, #drives-hand, #drives-paper-ep, #drives-paper-arbitrary']],
  paper: [['lab', '#drives-paper-ep, #drives-paper-arbitrary, #page-lesson']],
  postures: [['lab&goal.x=3', '#goal-position, #goal-heading, #start-position, #restore-postures']],
  run: [['lab', '#run, #one-generation, #one-back, #timeline, #until, #pace, #reset']],
  seed: [['lab', '#new-seed']],
  clock: [['lab', '#play, #speed, #scrub, #robot-clock input']],
  settings: [
    ['lab', '#settings-button, #preset input'],
    ['lab&lesson=cost', '#weights input'],
  ],
  parts: ['park', 'lab', 'curves'].map((name) => [
    name,
    pageNames.map((other) => `#page-${other}`).join(', '),
  ]),
  lesson: [
    ['lab', '#page-lesson'],
    ['lab&lesson=drive', '#lesson-step, .step-on, .tries a'],
  ],
  share: [['lab', '#keep-button']],
};

/** Also in the parts. @param {Group} group @returns {(readonly [link: string, selector: string])[]} */
const controlsOf = (group) => [
  ...controls[group],
  ...Object.entries(samples).flatMap(([name, { controls: own = {} }]) =>
    (own[group] ?? []).map(
      ([view, selector]) => /** @type {const} */ ([view ? `${name}&${view}` : name, selector]),
    ),
  ),
];

/** What is there only when evolution has come to its end: `parts/park-exercise.test.js` tries it. */
const elsewhere = ['.park-walk'];
/** What parts hide, as selectors: within each stands something of the table. */
const hiding = parts.flatMap(({ name, places = {} }) =>
  groupNames.flatMap((group) =>
    (places[group]?.hide ?? '')
      .split(', ')
      .filter((hide) => hide && !elsewhere.includes(hide))
      .map((hide) => ({ name, group, hide })),
  ),
);

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
  const all = groupNames.flatMap((group) =>
    controlsOf(group).map(([link, selector]) => ({ group, link, selector })),
  );
  /** @type {Map<string, string[]>} */
  const namesAt = new Map();
  let untried = hiding;
  for (const shown of new Set(all.map(({ link }) => link))) {
    await page.open(withKeys(shown, ''));
    for (const { group, link, selector } of all.filter(({ link }) => link === shown)) {
      const names = await page.evaluate(namesOf, selector);
      assert.ok(names.length > 0, `${group}: ${selector} finds nothing in ${link}`);
      const tried = await page.evaluate(
        (selector, some) =>
          some.filter((hide) => [...document.querySelectorAll(selector)].some((one) => one.closest(hide))),
        selector,
        untried.map(({ hide }) => hide),
      );
      untried = untried.filter((one) => one.group !== group || !tried.includes(one.hide));
      // Another thing may have the same name.
      const others = await page.evaluate(everything, selector);
      const own = names.filter((name) => name.startsWith('#') || !others.includes(name));
      namesAt.set(`${group}: ${link}`, own);
    }
  }
  assert.deepEqual(
    untried,
    [],
    'what a part hides is not tried: `controls` of its file in tests/page/parts/samples/',
  );
  for (const { group, link } of all) {
    await page.open(withKeys(link, `hide=${group}`));
    await page.click('#keys-button');
    const found = await page.evaluate(everything);
    const what = `${group}: ${link}`;
    assert.deepEqual(
      namesAt.get(what)?.filter((name) => found.includes(name)),
      [],
      what,
    );
    assert.deepEqual(await page.problems(), [], what);
  }
});

pageTest('what is hidden comes back with a link that shows it, and works', async (page) => {
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
    document.querySelector('#park-kx ~ .park-gain')?.textContent?.startsWith('5'),
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
