// A goal so near the edge of the plane that starts around it would lie beyond: the parts that ask for such starts say so.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';

/** Of each part that asks for starts around the goal, where it says why there are none. */
const places = {
  robustness: '#robustness-note',
  training: '#training-status',
  disturbance: '#disturbance-note',
};

for (const [part, place] of Object.entries(places))
  pageTest(`${part} names the goal where starts around it would lie beyond the plane`, async (page) => {
    for (const [language, told] of /** @type {const} */ ([
      ['en', 'This could not be computed: the goal is too near the edge of the plane, ±1000 m'],
      ['ko', '계산하지 못했습니다: 목표가 평면의 끝(±1000 m)에 너무 가까워'],
    ])) {
      await page.open(`#${part}&v=1&goal.x=1000&goal.y=-1000&lang=${language}`);
      await page.until(
        `${place} says ${told}`,
        (selector, text) => document.querySelector(selector)?.textContent?.startsWith(text),
        place,
        told,
      );
      const text = await page.evaluate(
        (name) =>
          /** @type {HTMLElement} */ (document.querySelector(`section[data-page="${name}"]`)).innerText,
        part,
      );
      assert.doesNotMatch(text, /starts\[|grid\.|\d\.\d{6}/);
    }
    if (part === 'training') await pressesNothing(page);
    if (part === 'disturbance') await keepsNoPlace(page);
  });

/** @param {import('../harness/browsers.js').Page} page */
async function pressesNothing(page) {
  await page.click('#training-evolve');
  const { disabled, runs } = await page.evaluate(() => ({
    disabled: document.getElementById('training-evolve')?.getAttribute('aria-disabled'),
    runs: !document.getElementById('training-progress')?.classList.contains('visually-hidden'),
  }));
  assert.deepEqual({ disabled, runs }, { disabled: 'true', runs: false });
}

/** @param {import('../harness/browsers.js').Page} page */
async function keepsNoPlace(page) {
  const heights = await page.evaluate(() =>
    ['remains-legend', 'remains', 'remains-text'].map((id) => document.getElementById(id)?.offsetHeight),
  );
  assert.deepEqual(heights, [0, 0, 0]);
}
