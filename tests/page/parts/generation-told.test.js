// What Generation tells of a method is true also of its rare generations.
import assert from 'node:assert/strict';
import { madeBy, successesIn } from '../../../www/parts/generation/detail-methods.js';
import { sidesOf } from '../../../www/parts/generation/gain-view.js';
import { dissect } from '../../../www/parts/generation/record.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';

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

test('the probes of a slope are said to be one point only where the picture shows one', () => {
  const told = new Set();
  for (const seed of [1, 2, 3])
    for (const anatomy of anatomiesOf('finite-differences', 60, { seed })) {
      const { plan, parents, offspring } = anatomy.record;
      if (plan.steps) continue;
      const [from] = parents;
      const sides = sidesOf(anatomy, { width: 600, height: 300 });
      const farthest = Math.max(
        ...sides.flatMap(({ place, shadow }) => {
          const at = place(shadow(from.gains));
          return offspring.map(({ gains }) => {
            const probe = place(shadow(gains));
            return Math.hypot(probe.x - at.x, probe.y - at.y);
          });
        }),
      );
      for (const [words, one] of /** @type {const} */ ([
        [en, /one point/],
        [ko, /한 점/],
      ])) {
        const isOne = one.test(words.sentence(anatomy, 'mutation'));
        told.add(isOne);
        if (isOne) assert.ok(farthest < 2, `seed ${seed}: ${farthest} pixels`);
        else assert.ok(farthest > 0.2, `seed ${seed}: ${farthest} pixels`);
      }
    }
  assert.equal(told.size, 2);
});

/** What stands in a template, with all that it holds. @param {unknown} template @returns {string} */
const textIn = (template) =>
  Array.isArray(template)
    ? template.map(textIn).join(' ')
    : typeof template === 'object' && template !== null && 'values' in template
      ? textIn(template.values)
      : String(template);

test('of a trial that is at 0 as its member is, its mutant below, neither is said to be sure', () => {
  let found = 0;
  for (const belowZero of /** @type {const} */ (['clamp', 'penalty']))
    for (const anatomy of anatomiesOf('de', 12, { belowZero }))
      for (const [own, { gains }] of anatomy.record.offspring.entries()) {
        const { bases, parents } = anatomy.record;
        const either = gains.filter(
          (gain, i) => gain === 0 && parents[own].gains[i] === 0 && bases[own].gains[i] < 0,
        );
        const told = textIn(madeBy(anatomy, anatomy.count + own, () => {}));
        assert.equal(told.split('held at 0, or').length - 1, either.length);
        found += either.length;
      }
  assert.ok(found > 0);
});

test('with a first σ of 0 nothing grows, and the gains have their turns', () => {
  const still = { initialSigma: 0 };
  for (const anatomy of anatomiesOf('cma-es', 6, still))
    for (const words of [en, ko]) assert.match(words.sentence(anatomy, 'survivors'), /1\.00/);
  for (const words of [en, ko])
    assert.deepEqual(
      anatomiesOf('one-at-a-time', 6, still).map(
        (anatomy) => words.sentence(anatomy, 'mutation').match(/k[xyθ]/)?.[0],
      ),
      ['kx', 'ky', 'kθ', 'kx', 'ky', 'kθ'],
    );
});

test('as many steps are said to succeed as the offspring that stay', () => {
  for (const initialSigma of [0, 1, 1e6]) {
    const settings = { ...base.evolution, initialSigma, method: /** @type {const} */ ('one-plus-one-es') };
    const evolution = new Evolution({ ...base, evolution: settings });
    const history = [evolution.statistics()];
    let stayed = 0;
    for (let i = 1; i <= 20; i += 1) {
      evolution.step();
      history.push(evolution.statistics());
      const anatomy = dissect(evolution.record(i), settings);
      if (/^Success/.test(en.sentence(anatomy, 'survivors'))) stayed += 1;
      assert.deepEqual(successesIn(anatomy, history), { steps: i, won: stayed }, `σ ${initialSigma}`);
    }
  }
});
