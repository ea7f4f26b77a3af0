// The parking place as a test works it, and what the core says of it in Node.
import { Evolution, simulate, startsOnCircle } from '../../../pkg/ep_locomotion.js';
import { experiment } from '../harness/core.js';
import { once } from '../../../www/kit/memo.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

export const usual = experiment('velocity-limits');
export const starts = startsOnCircle({ x: 2, y: 2, radius: 2.83, count: 32, seed: 1 });
export const task = {
  ...usual,
  starts,
  weights: { ...usual.weights, velocity: /** @type {[number, number]} */ ([1, 0.1]) },
};

/** @param {readonly number[]} gains */
export const parked = (gains) =>
  starts.filter((start) => simulate({ ...task, starts: [start] }, Float64Array.from(gains)).arrived).length;

/** The first generation of seed 1 whose best robot parks them all, found in Node. */
export const bred = once(() => {
  const evolution = new Evolution({ ...task, evolution: { ...task.evolution, seed: 1 } });
  let { generation, best, evaluations } = evolution.statistics();
  while (parked(best.gains) < 32) ({ generation, best, evaluations } = evolution.step());
  return { generation, gains: best.gains, cost: best.cost, evaluations };
});

/** @param {Page} page @param {string} gain @param {number} value */
export const slide = (page, gain, value) =>
  page.evaluate(
    (id, to) => {
      const slider = /** @type {HTMLInputElement} */ (document.getElementById(id));
      slider.value = String(to);
      slider.dispatchEvent(new Event('input', { bubbles: true }));
    },
    `park-${gain}`,
    value,
  );

/** How many have parked, once the film has ended. @param {Page} page */
export async function counted(page) {
  await page.until(
    'the film has ended',
    () =>
      document.querySelector('#park-again[aria-disabled="false"]') &&
      document.querySelector('#park .primary, #park-lesson'),
  );
  return Number(await page.text('#park-count'));
}
