// What a part has computed, and what keys lead to in its pictures, is said to who cannot see it.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { hears } from '../harness/heard.js';
import { serve } from '../harness/server.js';
import { parts } from '../../../www/parts/parts.js';
import { link, openContest, runContest } from './contest-page.js';
import { samples } from './samples.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Notes from now on what is said of its own accord. @param {Page} page */
const listen = (page) =>
  page.evaluate(() => {
    /** @type {string[]} */
    const heard = [];
    new MutationObserver((changes) => {
      for (const { target } of changes) {
        const element = target instanceof Element ? target : target.parentElement;
        const region = element?.closest('[aria-live="polite"], [role="status"], output');
        const text = region?.textContent?.trim();
        if (text && heard.at(-1) !== text) heard.push(text);
      }
    }).observe(document.body, { childList: true, characterData: true, subtree: true });
    Object.assign(window, { heard });
  });

/** @param {Page} page @returns {Promise<string[]>} */
const heard = (page) =>
  page.evaluate(() => /** @type {{ heard: string[] }} */ (/** @type {unknown} */ (window)).heard);

pageTest('what seeds, a contest and training come to is said once', async (page) => {
  await page.open('#luck');
  await page.click('#luck-count option[value="20"]');
  await page.click('#luck-generations option[value="50"]');
  await listen(page);
  await page.click('#luck-run');
  await page.until('the seeds have run', () => document.getElementById('luck-seed')?.hidden === false);
  const finding = await page.text('#luck-finding');
  assert.equal((await heard(page)).filter((text) => text === finding).length, 1);

  await openContest(page, link);
  await listen(page);
  await runContest(page);
  const verdict = await page.evaluate(
    () => document.querySelector('#contest-table .verdict')?.textContent?.trim() ?? '',
  );
  const ends = (await heard(page)).filter((text) => text.includes(verdict.split('.')[0]));
  assert.equal(ends.length, 1, `${ends}`);
  // Away from its line each says whom it is about.
  const undecided = ends[0].match(/(?:\S+ ){2}runs cannot tell these two apart/g) ?? [];
  assert.ok(undecided.length > 0 && undecided.every((text) => /^\S+: /.test(text)), ends[0]);

  await page.open('#training');
  await page.click('#training-generations option:first-child');
  await listen(page);
  await page.click('#training-evolve');
  await page.until(
    'it has evolved',
    () => document.querySelector('#training-evolve')?.textContent === 'Evolve again',
  );
  const lesson = await page.text('#training-finding');
  assert.equal((await heard(page)).filter((text) => text === lesson).length, 1);
});

pageTest('the pictures of training say from where a robot drives, and whether it arrives', async (page) => {
  await page.open('#training');
  await listen(page);
  await page.focus('#training-unseen');
  await page.press(Key.ARROW_RIGHT);
  const start = (await page.text('#start-text')).replace('Start ', '');
  await page.until(
    'it is said',
    (place) =>
      /** @type {{ heard: string[] }} */ (/** @type {unknown} */ (window)).heard.some((text) =>
        new RegExp(`^From ${place}: the robot (arrives|has not)`).test(text),
      ),
    start,
  );
});

/** What a part says in words of what drives, behind which choice. @type {[link: string, id: string, name: string][]} */
const readouts = parts.flatMap(({ name }) => {
  const { readout } = samples[name];
  return readout ? [[readout[0] ? `${name}&${readout[0]}` : name, readout[1], name]] : [];
});

pageTest(
  'what evolution makes of a readout is said when it pauses, not generation by generation',
  async (page) => {
    for (const [link, id, name] of readouts) {
      // What is behind a choice stays chosen.
      await page.open(`#${link}`);
      await page.click('#page-lab');
      await page.setPace(0);
      await page.click('#run');
      await page.click(`#page-${name}`);
      const first = await rested(page, id);
      await page.evaluate(hold);
      await listen(page);
      await page.setPace(1);
      await page.until(
        'it is another',
        (id, before) => {
          const text = document.getElementById(id)?.textContent?.trim();
          return text && text !== before;
        },
        id,
        first,
      );
      await page.setPace(0);
      // Of itself, and of what drives, the lab says so.
      const now = await page.evaluate((id) => document.getElementById(id)?.textContent?.trim() ?? '', id);
      const others = (await settled(page)).filter(
        (text) => !/^(Generation|J) /.test(text) || text.includes(now),
      );
      assert.deepEqual(others, [], link);
      assert.doesNotMatch(first, /^(Generation|J) /);
      await page.press('r');
      await page.until(
        'it is said',
        (id, before) => {
          const text = document.getElementById(id)?.textContent?.trim();
          const { heard, settle } = /** @type {{ heard: string[], settle: () => void }} */ (
            /** @type {unknown} */ (window)
          );
          settle();
          return text && text !== before && heard.some((one) => one.includes(text));
        },
        id,
        first,
      );
    }
  },
);

/** In the page: holds what waits for a second, until `settle` is called. */
function hold() {
  const { setTimeout: begin, clearTimeout: end } = window;
  /** @type {Map<number, () => void>} */
  const held = new Map();
  let last = 0;
  Object.assign(window, {
    setTimeout: (
      /** @type {() => void} */ act,
      /** @type {number} */ wait,
      /** @type {unknown[]} */ ...given
    ) => {
      if (wait !== 1000) return begin(act, wait, ...given);
      last -= 1;
      held.set(last, act);
      return last;
    },
    clearTimeout: (/** @type {number} */ timer) => (held.delete(timer) ? undefined : end(timer)),
    settle: () => {
      for (const act of held.values()) act();
      held.clear();
    },
  });
}

/** What is said once the hand rests. @param {Page} page */
const settled = async (page) => {
  await page.evaluate(() => /** @type {{ settle: () => void }} */ (/** @type {unknown} */ (window)).settle());
  return heard(page);
};

/** The text of an element once nothing is computed any more, if it is another. @param {Page} page @param {string} id @param {string} [before] */
const rested = (page, id, before = '') =>
  page.until(
    'it is there, and rests',
    (id, before) => {
      const text = document.getElementById(id)?.textContent?.trim() ?? '';
      return document.querySelector('[aria-busy="true"]') === null && text !== before && text;
    },
    id,
    before,
  );

pageTest(
  'what a slider makes of a readout is said once the hand rests, what is there at first not',
  async (page) => {
    const site = await serve(undefined, { before: `(${hold})()` });
    try {
      for (const [link, id] of readouts) {
        await page.leave();
        await page.visit(
          `${site.address}#${link}${link.includes('&') ? '' : '&v=1'}&drives=hand&gains=3,6,1`,
        );
        const before = await rested(page, id);
        await listen(page);
        assert.deepEqual(await settled(page), [], `opening ${link}`);
        await page.focus('#slider-kx');
        await page.press(...Array(6).fill(Key.ARROW_RIGHT));
        const said = await rested(page, id, before);
        assert.deepEqual(await heard(page), [], link);
        const after = await settled(page);
        assert.deepEqual([after.length, after[0]?.includes(said)], [1, true], `${link}: ${after} / ${said}`);
      }
    } finally {
      await page.leave();
      await site.close();
    }
  },
);

pageTest('an axis of Landscape that another choice has moved says so', async (page) => {
  await page.open('#landscape');
  const shown = (/** @type {string} */ id) =>
    page.evaluate(
      (id) => /** @type {HTMLSelectElement} */ (document.getElementById(id)).selectedOptions[0].text,
      id,
    );
  assert.deepEqual([await shown('landscape-x'), await shown('landscape-y')], ['kx', 'kθ']);
  await page.click('#landscape-x option:nth-child(3)');
  await hears(page, 'Gain on the vertical axis: kx$');
  assert.deepEqual([await shown('landscape-x'), await shown('landscape-y')], ['kθ', 'kx']);
});

pageTest('a slider says its value with the unit, once, and is no slider twice', async (page) => {
  await page.open('#park');
  await listen(page);
  await page.focus('#park-kx');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  await page.until('it has moved', () => document.querySelector('#park .park-bar .primary:not(:disabled)'));
  assert.deepEqual(
    (await heard(page)).filter((text) => /^[\d.]+$/.test(text)),
    [],
  );
  const names = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('input[type="range"]')]
        .filter((slider) => slider.checkVisibility())
        .map(({ ariaLabel, ariaValueText }) => `${ariaLabel}: ${ariaValueText}`),
    );
  assert.doesNotMatch((await names()).join(), /slider/);
  await page.open('#disturbance');
  assert.match((await names()).join(), /: [\d.]+ m\/s,.*: [\d.]+ rad\/s/);
});
