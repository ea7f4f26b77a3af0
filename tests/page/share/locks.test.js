// What an exercise locks cannot be done by a way round.
import assert from 'node:assert/strict';
import { linkOfStep, stepNamed } from '../../../www/lesson/path.js';
import { groupNames } from '../../../www/run/exercise.js';
import { pageTest } from '../harness/browsers.js';
import { read, waysOf } from '../harness/reading.js';
import { views } from '../whole/views.js';

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

/** A step of the lesson with more keys. @param {string} name @param {string} more */
const stepWith = (name, more) => `#${linkOfStep(stepNamed(name).number)}&${more}&task=Stay`;

pageTest('what drives from the lesson’s own views is locked with what it does', async (page) => {
  const entrants = ['ep', 'arbitrary', 'gentle', 'hand'];
  const names = entrants.map((name) => `.standing-name[data-entrant="${name}"]`);
  const driving = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.standing-name')].map((name) => name.getAttribute('aria-pressed')),
    );
  const [free, locked] = ['free', 'locked'];
  for (const [more, expected] of /** @type {const} */ ([
    ['lock=clock', [free, free, free, free]],
    ['lock=gains', [free, free, locked, locked]],
    ['hide=gains', [free, free, locked, locked]],
    ['lock=paper', [locked, locked, free, free]],
    ['lock=drives', [locked, locked, locked, locked]],
    ['hide=drives', [locked, locked, locked, locked]],
  ])) {
    await page.open(stepWith('cost', more));
    await page.until('the drives stand there', () => document.querySelector('.standing-name'));
    assert.deepEqual(await waysOf(page, ...names), expected, more);
    // A press does what it looks like.
    const before = await driving();
    await page.click(names[0]);
    if (expected[0] === free)
      await page.until(
        'it drives',
        (name) => document.querySelector(`${name}[aria-pressed="true"]`),
        names[0],
      );
    else assert.deepEqual(await driving(), before, more);
    assert.deepEqual(await waysOf(page, ...names), expected, `${more}, once it is drawn anew`);
  }
  const again = '#near-goal button';
  for (const [more, expected] of [
    ['lock=seed', free],
    ['lock=clock', locked],
    ['hide=clock', 'hidden'],
  ]) {
    await page.open(stepWith('disturbance', more));
    await page.until('the goal is there', () => document.querySelector('#near-goal svg'));
    assert.deepEqual(await waysOf(page, again), [expected], more);
  }
});

pageTest('what stays of a hidden group is locked', async (page) => {
  await page.open('#landscape&v=1&hide=gains&task=Stay');
  await page.until('the map is there', () => document.getElementById('landscape-map'));
  assert.deepEqual(await waysOf(page, '#gains', '#landscape-map'), ['hidden', 'locked']);
});

pageTest(
  'a lock holds where a view frees its control as the locks change, and ends as the view has it',
  async (page) => {
    const follow = (/** @type {string} */ link) =>
      page.evaluate((hash) => {
        location.hash = hash;
      }, link);
    await page.open('#park&v=1&lock=run&task=Stay');
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['locked']);
    // Whose sliders are locked may press it at once.
    await follow('park&v=1&lock=gains,run&task=Stay');
    await page.until('the sliders are locked', () => document.querySelector('#park-gains[data-locked]'));
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['locked']);
    await follow('park&v=1&lock=gains&task=Stay');
    await page.until('it is free', () => !document.querySelector('#park-evolve[data-locked]'));
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['free']);

    await page.open('#lab&v=1&lock=share&task=Stay');
    assert.deepEqual(await waysOf(page, '#keep-button'), ['locked']);
    await page.evaluate(() => {
      const button = /** @type {HTMLButtonElement} */ (document.getElementById('keep-button'));
      for (const isDisabled of [false, true, false]) button.disabled = isDisabled;
    });
    assert.deepEqual(await waysOf(page, '#keep-button'), ['locked']);
    await follow('lab&v=1&task=Stay');
    await page.until('it is free', () => !document.querySelector('#keep-button[data-locked]'));
    assert.deepEqual(await waysOf(page, '#keep-button'), ['free']);
  },
);

/** Of each part, the controls that change nothing that an exercise could lock. */
const freeInPart = {
  curves: [
    'curves-numbers',
    'curves-view-compare',
    'curves-view-numbers',
    'curves-view-stability',
    'curves-view-time',
    'stability-log',
    'stability-table',
  ],
  disturbance: [],
  generation: [
    'generation-phases-drive',
    'generation-phases-mutation',
    'generation-phases-parents',
    'generation-phases-ranking',
    'generation-phases-survivors',
    'generation-phases-tournament',
    'generation-picture',
    'generation-table',
  ],
  lab: [],
  landscape: ['landscape-follows', 'landscape-table', 'landscape-third', 'landscape-x', 'landscape-y'],
  luck: [
    'contest-budget',
    'contest-seeds',
    'contestant-2',
    'contestant-3',
    'contestant-4',
    'luck-count',
    'luck-generations',
    'luck-view-contest',
    'luck-view-seeds',
  ],
  park: ['park-again'],
  robustness: [
    'robustness-half',
    'robustness-headings-all',
    'robustness-headings-one',
    'robustness-quantity-cost',
    'robustness-quantity-share',
    'robustness-quantity-time',
    'robustness-rose',
    'robustness-table',
  ],
  training: ['training-generations'],
};

/** Works every control that looks free, once, also those that come with it. Links are tried elsewhere. @param {string} part */
async function workAll(part) {
  const frame = () => new Promise((resolve) => requestAnimationFrame(resolve));
  const selector = 'button, input, select, summary, [tabindex="0"]';
  /** @type {Set<Element>} */
  const worked = new Set();
  const fresh = () =>
    [...document.querySelectorAll(selector)].filter(
      (element) =>
        !worked.has(element) &&
        element.checkVisibility() &&
        !element.matches(':disabled, [aria-disabled="true"]') &&
        !element.closest('[inert]'),
    );
  /** @param {Element} element */
  const work = (element) => {
    const tell = (/** @type {string} */ type) => element.dispatchEvent(new Event(type, { bubbles: true }));
    if (element instanceof HTMLSelectElement) {
      element.selectedIndex = (element.selectedIndex + 1) % element.options.length;
      tell('change');
    } else if (element instanceof HTMLInputElement && element.type === 'range') {
      element.value = String((Number(element.min) + Number(element.max)) / 2);
      tell('input');
      tell('change');
    } else if (element instanceof HTMLInputElement && /text|number/.test(element.type)) {
      element.value = '3';
      tell('input');
      tell('change');
    } else if (element instanceof HTMLElement) {
      for (const key of ['ArrowRight', 'Enter'])
        element.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
      element.click();
    }
    for (const dialog of document.querySelectorAll('dialog')) dialog.close();
  };
  const reason = /** @type {HTMLElement} */ (document.getElementById('exercise-locks'));
  const nameOf = (/** @type {Element} */ { id, textContent }) => id || textContent?.trim();
  /** @type {string[]} */
  const found = [];
  /** @type {string[]} */
  const own = [];
  for (let some = fresh(); some.length > 0 && worked.size < 500; some = fresh()) {
    for (const element of some) {
      worked.add(element);
      if (element.id && element.closest(`section.${part}`)) own.push(element.id);
      if (element.isConnected) work(element);
    }
    for (let i = 0; i < 3; i += 1) await frame();
    if (reason.getAnimations().length > 0) found.push(some.map(nameOf).join(', '));
    for (const animation of reason.getAnimations()) animation.cancel();
  }
  return { found, own };
}

pageTest('where all is locked no control looks free that is not', async (page) => {
  /** @type {string[]} */
  const flaws = [];
  /** @type {Record<string, Set<string>>} */
  const free = {};
  for (const view of views) {
    await page.open(`#${view}&lock=${groupNames.join(',')}&task=Stay`);
    const part = view.split('&')[0];
    const { found, own } = await page.evaluate(workAll, part);
    flaws.push(...found.map((some) => `${view}: one of ${some} is not free`));
    free[part] = new Set([...(free[part] ?? []), ...own]);
  }
  assert.deepEqual(flaws, []);
  const sorted = Object.entries(free).map(([part, names]) => [part, [...names].sort()]);
  assert.deepEqual(Object.fromEntries(sorted), freeInPart, 'else a part locks it in its places');
});
