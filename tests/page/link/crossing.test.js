// A change of language loads the page again: what was found stays.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { bred } from '../parts/parking.js';
import { saidElsewhere } from '../../../www/lesson/words/ko.js';
import { openGroup, openSettings } from '../harness/panel.js';
import { ko } from '../harness/words.js';
import { holdWorkers } from '../harness/workers.js';
import { follow } from '../whole/surround.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {'en' | 'ko'} language */
const inLanguage = (page, language) =>
  page.until(
    'the page is in the other language',
    (one) => document.documentElement.lang === one && document.documentElement.dataset.ready === 'true',
    language,
  );

/** Presses the link to the other language, and waits for the page. @param {Page} page @param {'en' | 'ko'} language */
async function toLanguage(page, language) {
  await page.click('#language');
  await inLanguage(page, language);
}

/** @param {Page} page */
const toKorean = (page) => toLanguage(page, 'ko');

/** The numbers in an element, which stand in another order in another language. @param {Page} page @param {string} selector */
const numbersIn = async (page, selector) => {
  // Text by text: engines differ in what they write between two of them.
  const text = await page.evaluate((one) => {
    const walker = document.createTreeWalker(document.querySelector(one) ?? document.body, 4);
    const texts = [];
    while (walker.nextNode()) texts.push(walker.currentNode.nodeValue);
    return texts.join(' ');
  }, selector);
  return (text.replaceAll('−', '-').match(/-?\d+(?:\.\d+)?/g) ?? []).sort();
};

/** @param {Page} page @param {string} id @param {string} value */
const set = (page, id, value) =>
  page.evaluate(
    (control, to) => {
      const input = /** @type {HTMLInputElement} */ (document.getElementById(control));
      input.value = to;
      for (const type of ['input', 'change']) input.dispatchEvent(new Event(type, { bubbles: true }));
    },
    id,
    value,
  );

pageTest('what was found is there in the other language too', async (page) => {
  /** @type {readonly [part: string, find: () => Promise<unknown>, found: string][]} */
  const finds = [
    ['park', () => set(page, 'park-ky', '3').then(() => page.click('#park-evolve')), '.park-table tbody'],
    [
      'luck',
      async () => {
        await set(page, 'luck-count', '20');
        await set(page, 'luck-generations', '50');
        await page.click('#luck-run');
      },
      '#luck-readout',
    ],
    [
      'training',
      async () => {
        await set(page, 'training-generations', '50');
        await page.click('#training-evolve');
      },
      ':is(#training-one, #training-circle, #training-grid).chosen',
    ],
  ];
  for (const [part, find, found] of finds) {
    await page.open(`#${part}&v=1&generation=12`);
    await page.setPace(8);
    await page.until('it is open', (name) => document.body.dataset.open === name, part);
    await find();
    await page.until(
      `${part}: it is found`,
      (selector) => document.querySelector(selector)?.textContent?.trim(),
      found,
    );
    const before = await numbersIn(page, found);
    assert.ok(before.length > 0, part);
    await toKorean(page);
    await page.until(
      `${part}: it is there`,
      (selector) => document.querySelector(selector)?.textContent?.trim(),
      found,
    );
    assert.deepEqual(await numbersIn(page, found), before, part);
    // Once: who loads the page again begins again.
    assert.equal(await page.evaluate(() => history.state), null);
  }
});

pageTest('what is being computed in a part is computed in the other language', async (page) => {
  /** Leaves the page while it is under way. @param {string} button @param {string} runs @param {'en' | 'ko'} language @param {string} found what comes of it, perhaps before the next look @param {number} [heard] parts that the workers do before */
  const cross = async (button, runs, language, found, heard = 0) => {
    await holdWorkers(page, heard);
    await page.click(button);
    await page.until(`${button}: it begins`, (one) => document.querySelector(one), runs);
    await toLanguage(page, language);
    await page.until(`${button}: it runs`, (...seen) => document.querySelector(seen.join()), runs, found);
  };
  await page.open('#luck&v=1');
  await set(page, 'luck-count', '500');
  await cross('#luck-run', '#luck-progress:not(.visually-hidden)', 'ko', '#luck-seed:not([hidden])');
  await page.open('#luck&v=1&luck=contest&seeds=101&budget=20000');
  await cross('#contest-run', '#contest-only:disabled', 'ko', '#contest-table', 2);

  const trains = '#training-progress:not(.visually-hidden)';
  const isFound = '#training-circle.chosen';
  await page.open('#training&v=1');
  await set(page, 'training-generations', '100');
  await cross('#training-evolve', trains, 'ko', isFound);
  await page.until('it is found', (one) => document.querySelector(one), isFound);
  await cross('#training-seeds', trains, 'en', '.training-dot');
});

pageTest('evolution that runs goes on in the other language', async (page) => {
  await page.open('#lab&v=1');
  await page.click('#pace option:nth-child(2)');
  await page.click('#run');
  await toKorean(page);
  await page.until(
    'it runs',
    (pause) => document.getElementById('run')?.textContent?.trim() === pause,
    ko.lab.pauseEvolution,
  );
});

pageTest(
  'evolution that runs on Park goes on in the other language, to what it would have come to',
  async (page) => {
    await page.open('#park');
    await set(page, 'park-ky', '3');
    // So that it has not come to its end before it is left.
    await page.setPace(0.4);
    await page.click('#park-evolve');
    await page.until('generation 2 has come', () =>
      /generation ([2-9]|1\d)/.test(document.querySelector('.park-climb figcaption')?.textContent ?? ''),
    );
    await toKorean(page);
    await page.setPace(8);
    await page.until('it has come to its end', () => document.getElementById('park-between'));
    const { generation } = bred();
    const climb = await page.text('.park-climb figcaption');
    assert.ok(climb.startsWith(`${generation}세대의 최우수: 32대 주차`), climb);
  },
  { moves: true },
);

pageTest('a link that is still being evolved is evolved to its end in the other language', async (page) => {
  await page.open('#lab&v=1');
  // So that it has not come to its end before it is left.
  await holdWorkers(page);
  await follow(page, 'lab&v=1&population=300&horizon=60&generation=12');
  await toKorean(page);
  await page.until(
    'the generation of the link',
    () => Number(document.getElementById('generation')?.textContent) === 12,
  );
});

pageTest(
  'a link that still begins, and a setting that does, are those that the other language opens',
  async (page) => {
    /** @param {string} population */
    const has = (population) =>
      page.until(
        `a population of ${population}`,
        (one) =>
          location.hash.includes(`population=${one}`) && !document.querySelector('#computing:not([hidden])'),
        population,
      );
    await page.open('#lab&v=1&generation=3');
    await holdWorkers(page);
    await page.evaluate(() => {
      location.hash = 'lab&v=1&population=1500&seed=7';
    });
    await page.until('it begins', () => document.querySelector('#computing:not([hidden])'));
    await toKorean(page);
    await has('1500');
    assert.match(await page.evaluate(() => location.hash), /(?=.*seed=7).*lang=ko/);
    assert.equal(await page.text('#generation'), '0');
    await openSettings(page);
    await openGroup(page, 'evolution');
    await holdWorkers(page);
    await set(page, 'setting-evolution-population', '1400');
    await page.until('it begins', () => document.querySelector('#computing:not([hidden])'));
    await toLanguage(page, 'en');
    await has('1400');
  },
);

/** @param {Page} page */
async function openMaker(page) {
  await page.click('#keep-button');
  await page.until('Share is there', () => document.getElementById('keep-exercise'));
  await page.click('#keep-exercise');
  await page.until('the maker is open', () => document.getElementById('maker-task')?.checkVisibility());
}

pageTest('how fast evolution goes, until when, and a task in the making go along', async (page) => {
  await page.open('#lab');
  await set(page, 'pace', '1');
  await set(page, 'speed', '4');
  await set(page, 'until', 'generation');
  await set(page, 'until-value', '30');
  await openMaker(page);
  await set(page, 'maker-task', 'Park.');
  await toKorean(page);
  const values = await page.evaluate(() =>
    ['pace', 'speed', 'until', 'until-value'].map((id) =>
      Reflect.get(document.getElementById(id) ?? {}, 'value'),
    ),
  );
  assert.deepEqual(values, ['1', '4', 'generation', '30']);
  await openMaker(page);
  assert.equal(
    await page.evaluate(() => Reflect.get(document.getElementById('maker-task') ?? {}, 'value')),
    'Park.',
  );
});

pageTest('generations after the one that is shown are there in the other language too', async (page) => {
  await page.open('#lab&v=1&generation=12');
  await page.focus('#timeline');
  await page.press(Key.HOME);
  await page.until('it is back', () => document.getElementById('generation')?.textContent === '0');
  await toKorean(page);
  await page.until('all are there, and the first is shown', () => {
    const timeline = /** @type {HTMLInputElement} */ (document.getElementById('timeline'));
    return timeline.max === '12' && document.getElementById('generation')?.textContent === '0';
  });
});

pageTest('what is done while the page is being left goes along, and takes nothing away', async (page) => {
  await page.open('#lab&v=1&generation=12');
  await page.focus('#timeline');
  await page.press(Key.HOME);
  await page.until('it is back', () => document.getElementById('generation')?.textContent === '0');
  await page.until('it is at rest', () => !document.querySelector('#play.playing'));
  await page.evaluate(() => {
    const timeline = /** @type {HTMLInputElement} */ (document.getElementById('timeline'));
    addEventListener('popstate', () => {
      // The next frame, and what is written some time after it, come before the browser has loaded the page again.
      const draw = window.requestAnimationFrame;
      window.requestAnimationFrame = (frame) => {
        window.requestAnimationFrame = draw;
        queueMicrotask(() => frame(performance.now()));
        return 0;
      };
      window.setTimeout = /** @type {any} */ ((/** @type {() => void} */ act) => queueMicrotask(act));
      timeline.value = '1';
      for (const type of ['input', 'change']) timeline.dispatchEvent(new Event(type, { bubbles: true }));
    });
  });
  await toKorean(page);
  await page.until('all are there, and the one that was asked for last is shown', () => {
    const there = /** @type {HTMLInputElement} */ (document.getElementById('timeline'));
    return there.max === '12' && document.getElementById('generation')?.textContent === '1';
  });
});

pageTest(
  'an answer is there in the other language, and with its words in that of the answer',
  async (page) => {
    const said = () =>
      page.evaluate(() => ({
        why: document.querySelector('#quiz-bolder .quiz-why strong')?.parentElement?.innerText,
        right: document.querySelectorAll('#quiz-bolder .choice.right').length,
      }));
    const answered = () =>
      page.until('the answer', () => document.querySelector('#quiz-bolder .quiz-why strong') !== null);
    await page.open('#lesson&step=1');
    await page.setPace(20);
    await page.click('#quiz-bolder .choice:first-child');
    await answered();
    const before = await said();
    await toLanguage(page, 'ko');
    await answered();
    const there = await said();
    assert.ok(String(there.why).includes(saidElsewhere), there.why);
    assert.equal(there.right, 1);
    await toLanguage(page, 'en');
    await answered();
    assert.deepEqual(await said(), before);
  },
);
