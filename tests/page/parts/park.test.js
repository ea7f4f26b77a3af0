// The first screen: what an address without a part opens, by hand and by evolution, each number from the core.
import assert from 'node:assert/strict';
import * as en from '../../../www/parts/park/after/words/en.js';
import * as ko from '../../../www/parts/park/after/words/ko.js';
import { isDone } from '../../../www/parts/park/breeding.js';
import { filmOf, isOver, later, parkedBy } from '../../../www/parts/park/film.js';
import { sight } from '../../../www/parts/park/sight.js';
import { pageTest } from '../harness/browsers.js';
import { test } from '../harness/once.js';
import { written } from '../harness/templates.js';
import { bred, counted, parked, slide, usual } from './parking.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/parts/park/task.js').Drive} Drive */

/** @param {boolean} arrived @param {number} finalTime @returns {Drive} */
const drive = (arrived, finalTime) => /** @type {any} */ ({ run: { arrived, finalTime } });

test('a film ends with the last that parks, and waits a while for those that do not', () => {
  assert.equal(filmOf([drive(true, 2), drive(true, 3)], [], 'hand').end, 3);
  assert.equal(filmOf([drive(true, 2), drive(false, 10)], [], 'hand').end, 4);
  assert.equal(filmOf([drive(true, 7), drive(false, 10)], [], 'hand').end, 7);
  const film = filmOf([drive(true, 2), drive(true, 3), drive(false, 10)], [], 'hand');
  const seen = [0, 1.9, 2, 3, 4].map((time) => parkedBy({ ...film, time }));
  assert.deepEqual(seen, [0, 0, 1, 2, 2]);
  assert.ok(isOver(later(film, 100)));
});

test('the count says whose robots drive', () => {
  const bred = [{ gains: [1, 2, 3], parked: 20, generation: 7, drives: 700 }];
  const model = /** @type {any} */ ({
    gains: [1, 1, 1],
    best: null,
    bred,
    ...{ evolving: false, seed: 1, message: '', moved: true, isFree: true, isOwn: false },
    ...{ parked: 3, over: false, count: 32, ends: [12, 12, 12], endsBefore: [12, 12, 12], population: 20 },
    tolerance: usual.tolerance,
  });
  const said = (/** @type {object} */ other) =>
    written(sight({ ...model, ...other }, /** @type {any} */ ({ lesson: '', lab: null }), null, null));
  for (const state of [{ evolving: true }, { evolving: false }, { over: true }]) {
    const text = said(state);
    assert.ok(text.includes('best robot of generation 7') && !text.includes('with your numbers'), text);
  }
  assert.ok(said({ isOwn: true }).includes('with your numbers'));
});

pageTest(
  'an address without a part opens the parking place, where evolution does what no hand does',
  async (page) => {
    await page.open('');
    assert.equal(await page.evaluate(() => document.body.dataset.open), 'park');
    assert.equal(await (await page.element('#park-evolve')).isEnabled(), false);
    const why = () =>
      page.evaluate(() => {
        const id = document.getElementById('park-evolve')?.getAttribute('aria-describedby');
        return document.getElementById(id ?? '')?.textContent ?? '';
      });
    assert.match(await why(), /^First move a slider/);
    await page.setPace(50);
    await slide(page, 'kx', 5);
    await slide(page, 'ky', 5);
    await slide(page, 'ktheta', 5);
    assert.equal(await counted(page), parked([5, 5, 5]));
    await page.click('#park-evolve');
    await page.until('evolution has come to its end', () => document.getElementById('park-lesson'));
    assert.equal(await counted(page), 32);
    const found = bred();
    const table = await page.text('.park-table');
    for (const gain of [...found.gains, 5]) assert.ok(table.includes(gain.toFixed(1)), `${gain} in ${table}`);
    assert.ok(table.includes('32 of 32') && table.includes('22 of 32'), table);
    const climb = (await page.text('.park-climb figcaption')).replaceAll(/\s/g, '');
    assert.ok(climb.includes(`generation${found.generation}:32parked·${found.evaluations}drives`), climb);
    const plot = await page.text('.park-climb');
    for (const label of ['32 parked', '0', 'yours 22'])
      assert.ok(plot.includes(label), `${label} in ${plot}`);
    assert.deepEqual(await page.problems(), []);
    // Where it leads is in sight on laptops and projectors, without scrolling.
    for (const [width, height] of /** @type {const} */ ([
      [1366, 768],
      [1280, 720],
      [1024, 768],
    ])) {
      await page.resize(width, height);
      const excess = () => page.evaluate(() => document.documentElement.scrollHeight - innerHeight);
      assert.equal(await excess(), 0, `${width} × ${height}`);
    }

    await page.click('#park-lesson');
    await page.until('the lesson is open', () => document.querySelector('#lesson:not([hidden]) h2'));
  },
);

test('only evolution that has come to its end is measured against the own numbers', () => {
  const found = (/** @type {number} */ parked, /** @type {number} */ generation) =>
    /** @type {any} */ ({ gains: [1, 2, 3], parked, generation, drives: 20 });
  const grown = (/** @type {number} */ length, /** @type {number} */ parked) =>
    Array.from({ length }, (_, generation) => found(parked, generation));
  for (const [words, stopped, luck] of /** @type {const} */ ([
    [en, /^You stopped evolution at generation 2: 5 of 32\.$/, /you had 22.*luck/],
    [ko, /^2세대에서 진화를 멈추었습니다\./, /22대.*운/],
  ])) {
    const said = (/** @type {any[]} */ bred, /** @type {number | null} */ mine) =>
      words.ending(
        { best: mine === null ? null : { gains: [1, 1, 1], parked: mine }, count: 32 },
        bred.at(-1),
        isDone(bred, 32),
      );
    assert.match(said(grown(3, 5), 22), stopped);
    assert.match(said(grown(3, 5), 1), stopped);
    assert.match(said(grown(101, 5), 22), luck);
    assert.match(said(grown(3, 32), 32), new RegExp(luck.source.replaceAll('22', '32')));
    // Who could try nothing is not compared.
    for (const bred of [grown(3, 0), grown(101, 0), grown(3, 32)])
      assert.doesNotMatch(said(bred, null), /you had|직접 찾은/);
  }
});

pageTest('evolution is stopped by a press, and by a hand on a slider', async (page) => {
  await page.open('#park');
  await slide(page, 'ky', 3);
  for (const hand of [false, true]) {
    await page.until('evolution can begin', () => document.querySelector('#park-evolve:not(:disabled)'));
    // Within the page, for it soon comes to its end.
    await page.evaluate(async (slides) => {
      const evolve = /** @type {HTMLElement} */ (document.getElementById('park-evolve'));
      const slider = /** @type {HTMLInputElement} */ (document.getElementById('park-ky'));
      const climb = () => document.querySelector('.park-climb figcaption')?.textContent ?? '';
      evolve.click();
      while (!/generation [1-9]/.test(climb())) await new Promise(requestAnimationFrame);
      if (!slides) return evolve.click();
      slider.value = '4';
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    }, hand);
    await page.until('it rests', () => document.getElementById('park-lesson'));
    const climb = await page.text('.park-climb figcaption');
    const generation = Number(/generation (\d+)/.exec(climb)?.[1]);
    assert.ok(generation < bred().generation, climb);
    assert.ok(
      (await page.text('.park-say')).startsWith(`You stopped evolution at generation ${generation}:`),
    );
  }
});

pageTest('where the sliders are locked, evolution can begin at once', async (page) => {
  await page.open('#park&v=1&lock=gains');
  await page.until('evolution can begin', () => document.querySelector('#park-evolve:not(:disabled)'));
});

pageTest(
  'the sliders are in the address: who loads the page again has them, and beyond their ends is refused',
  async (page) => {
    await page.open('#park');
    await slide(page, 'kx', 7);
    await page.until('it is written', () => /park=7,/.test(location.hash));
    await page.driver.navigate().refresh();
    const isThere = () =>
      page.until('it is there', () => {
        const slider = /** @type {HTMLInputElement | null} */ (document.getElementById('park-kx'));
        return slider?.value === '7';
      });
    await isThere();
    await page.open('#park&v=1&park=7,0.1,9999');
    assert.match(await page.text('#message'), /park.*from 0 to 1\D?000/);
  },
);

pageTest(
  'a link with other numbers begins with them; one with the same keeps what was found',
  async (page) => {
    await page.open('#park');
    await page.setPace(50);
    await slide(page, 'ky', 3);
    await page.click('#park-evolve');
    await page.until('it has come to its end', () => document.getElementById('park-lesson'));
    await page.click('#page-lab');
    await page.until('the lab is open', () => document.body.dataset.open === 'lab');
    await page.evaluate(() => history.back());
    await page.until('Park is open', () => document.body.dataset.open === 'park');
    assert.equal(await counted(page), 32);
    assert.ok((await page.text('.park-table')).includes('32 of 32'));

    await page.evaluate(() => {
      location.hash = 'park&v=1&park=1,2,3';
    });
    await page.until('the sliders stand so', () => {
      const ky = /** @type {HTMLInputElement} */ (document.getElementById('park-ky'));
      return ky.value === '2' && !document.getElementById('park-lesson');
    });
    assert.equal(await counted(page), parked([1, 2, 3]));
    assert.equal(await page.text('.park-count .muted'), 'with your numbers');
    const left = () => page.evaluate(() => document.querySelectorAll('.park-mark, .park-table').length);
    assert.equal(await left(), 0);
    assert.match(await page.text('.park-say'), /^32 robots, one parking place/);
  },
);

/** What Share offers, once its sheet is there. @param {Page} page */
async function shared(page) {
  await page.click('#keep-button');
  return page.until('Share is there', () => {
    const sheet = document.getElementById('keep');
    return (
      sheet?.querySelector('#keep-link') && {
        said: sheet.textContent ?? '',
        link: /** @type {HTMLInputElement} */ (sheet.querySelector('#keep-link')).value.split('#')[1],
        lab: sheet.querySelector('#keep-lab')?.getAttribute('href') ?? null,
        ofLab: sheet.querySelectorAll('#keep-code, #keep-save, #keep-generations, #keep-drive').length,
      }
    );
  });
}

pageTest(
  'Share says what of Park is in its link, and leads to what was found here in the lab',
  async (page) => {
    await page.open('#park');
    const { said, ...before } = await shared(page);
    assert.deepEqual(before, { link: 'park', lab: null, ofLab: 0 });
    assert.ok(said.includes('What evolution found is not in it') && !said.includes('Fingerprint'), said);
    await page.click('#keep-close');
    await slide(page, 'ky', 3);
    const byHand = await shared(page);
    assert.match(byHand.link, /^park&v=1&park=[\d.]+,3,[\d.]+$/);
    assert.match(byHand.lab ?? '', /^#lab&.*drives=hand&gains=[\d.]+,3,[\d.]+/);
    await page.click('#keep-close');
    await page.setPace(50);
    await page.click('#park-evolve');
    await page.until('it has come to its end', () => document.getElementById('park-lab'));
    const evolved = await shared(page);
    assert.equal(
      evolved.lab,
      await page.evaluate(() => document.getElementById('park-lab')?.getAttribute('href')),
    );
    assert.equal(evolved.ofLab, 0);
    await page.click('#keep-lab');
    await page.until('the lab is open', () => document.body.dataset.open === 'lab');
    // With the same best robot.
    const { generation, gains, cost } = bred();
    await page.until(
      'the generation is there',
      (number) => document.getElementById('generation')?.textContent === number,
      String(generation),
    );
    const ky = await page.evaluate(
      () => /** @type {HTMLInputElement} */ (document.getElementById('gain-ky')).value,
    );
    assert.equal(Number(ky), Number(gains[1].toFixed(3)));
    // From the first start alone others may be better.
    assert.equal(await page.text('#cost-note'), `mean over all 32 starts: ${cost.toFixed(3)}`);
    assert.equal((await shared(page)).ofLab, 4);
  },
);

pageTest(
  'on a small telephone the robots and the three sliders are in sight at once, in both languages',
  async (page) => {
    for (const language of ['en', 'ko']) {
      await page.evaluate((lang) => {
        const src = new URL(location.href);
        src.hash = `park&lang=${lang}`;
        document.querySelector('iframe')?.remove();
        const frame = document.createElement('iframe');
        // In a frame, because not every window can be so narrow, and without the bar for scrolling, which a telephone has not.
        Object.assign(frame, { src, width: '360', height: '640', frameBorder: '0', scrolling: 'no' });
        document.body.append(frame);
      }, language);
      const ends = await page.until('the narrow page is ready', () => {
        const inside = document.querySelector('iframe')?.contentDocument;
        if (inside?.documentElement?.dataset.ready !== 'true') return;
        const shown = [...inside.querySelectorAll('.park-plane, .park-count, .park .gain')];
        return shown.map((element) => Math.round(element.getBoundingClientRect().bottom));
      });
      assert.equal(ends.length, 5);
      assert.ok(Math.max(...ends) <= 640, `${language}: ${ends}`);
    }
  },
);
