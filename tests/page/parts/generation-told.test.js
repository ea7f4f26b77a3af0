// What Generation tells of a method is true also of its rare generations.
import assert from 'node:assert/strict';
import { dissect } from '../../../www/parts/generation/record.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment } from '../harness/core.js';

/** @typedef {import('../../../www/parts/generation/record.js').Anatomy} Anatomy */
/** @typedef {import('../../../www/parts/generation/record.js').Method} Method */

const base = experiment('velocity-limits');

/** From generation 1 on. @param {Method} method @param {number} generations @param {Partial<typeof base.evolution>} [change] @returns {Anatomy[]} */
function anatomiesOf(method, generations, change = {}) {
  const settings = { ...base.evolution, ...change, method };
  const evolution = new Evolution({ ...base, evolution: settings });
  for (let i = 0; i < generations; i += 1) evolution.step();
  return Array.from({ length: generations }, (_, i) => dissect(evolution.record(i + 1), settings));
}

/** @param {readonly { cost: number }[]} some */
const bestOf = (some) => Math.min(...some.map(({ cost }) => cost));

pageTest('below those that stay stand their ranks', async (page) => {
  for (const [method, generation] of /** @type {const} */ ([
    ['de', 9],
    ['de', 0],
    ['random', 9],
  ]))
    for (const [language, name] of /** @type {const} */ ([
      ['en', 'rank'],
      ['ko', '순위'],
    ])) {
      await page.open(
        `#generation&v=1&lang=${language}&evolution.method=${method}&generation=${generation}&phase=survivors`,
      );
      const across = await page.until('the axis', () => {
        const texts = [...document.querySelectorAll('.generation-picture .axis text')];
        return texts.length > 0 && texts.map((one) => one.textContent);
      });
      assert.ok(across.includes(name), `${method}, generation ${generation}: ${across}`);
    }
});

pageTest('of a better probe that is not taken nobody says that the best J stays', async (page) => {
  for (const [language, best, probe] of /** @type {const} */ ([
    ['en', /best/i, /probe/i],
    ['ko', /최소/, /시험점은/],
  ]))
    for (const [seed, generation] of [
      [4, 1],
      [2, 1],
      [2, 3],
      [2, 6],
      [2, 11],
    ]) {
      const { record } = anatomiesOf('finite-differences', generation, { seed })[generation - 1];
      assert.equal(record.plan.steps, null);
      await page.open(
        `#generation&v=1&lang=${language}&evolution.method=finite-differences&seed=${seed}&generation=${generation}&phase=survivors&individual=0`,
      );
      const told = await page.until('it is told', () =>
        document.querySelector('#generation-details .headline + p')?.textContent?.trim(),
      );
      assert.doesNotMatch(told, best);
      assert.equal(probe.test(told), bestOf(record.offspring) < bestOf(record.parents), told);
    }
});
