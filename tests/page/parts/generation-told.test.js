// What Generation tells of a method is true also of its rare generations.
import assert from 'node:assert/strict';
import { madeBy, successesIn } from '../../../www/parts/generation/detail-methods.js';
import { detailsOf } from '../../../www/parts/generation/details.js';
import { sidesOf } from '../../../www/parts/generation/gain-view.js';
import { dissect } from '../../../www/parts/generation/record.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { written } from '../harness/templates.js';

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

test('of a better probe that is not taken nobody says that the best J stays', () => {
  const isTold = new Set();
  for (const seed of [2, 4])
    for (const anatomy of anatomiesOf('finite-differences', 12, { seed })) {
      const { plan, parents, offspring } = anatomy.record;
      if (plan.steps) continue;
      const isBetter = bestOf(offspring) < bestOf(parents);
      isTold.add(isBetter);
      const model = /** @type {any} */ ({ anatomy, phase: 'survivors', chosen: 0, successes: null });
      const told = written(detailsOf(model, /** @type {any} */ ({ choose() {} })));
      const cost = en.costWriter(anatomy)(parents[0].cost);
      assert.ok(told.includes(`<p>${en.probedText(cost, isBetter)}</p>`), told);
    }
  assert.equal(isTold.size, 2);
  for (const [words, best, probe] of /** @type {const} */ ([
    [en, /best/i, /probe/i],
    [ko, /최소/, /시험점은/],
  ]))
    for (const isBetter of [true, false]) {
      assert.doesNotMatch(words.probedText('8.000', isBetter), best);
      assert.equal(probe.test(words.probedText('8.000', isBetter)), isBetter);
    }
});

test('why a slope cannot be told, and why a simplex begins anew, is said as it is', () => {
  const [probed] = anatomiesOf('finite-differences', 1).slice(-1);
  const untold = { ...probed.record, next: { ...probed.record.next, slope: null, steps: null } };
  for (const [words, arrives] of /** @type {const} */ ([
    [en, /arriv/],
    [ko, /도착/],
  ]))
    assert.doesNotMatch(words.sentence({ ...probed, record: untold }, 'survivors'), arrives);

  const begun = anatomiesOf('nelder-mead', 400).find(({ record }) => record.plan.motion === 'begin');
  assert.ok(begun);
  const parents = begun.record.parents.map((one) => ({ ...one, cost: Number.POSITIVE_INFINITY }));
  const nowhere = { ...begun, record: { ...begun.record, parents } };
  for (const [words, shrunk] of /** @type {const} */ ([
    [en, /shrunk/],
    [ko, /줄어/],
  ])) {
    assert.match(words.sentence(begun, 'parents'), shrunk);
    assert.doesNotMatch(words.sentence(nowhere, 'parents'), shrunk);
  }
});

test('only luck is of this time: by J alone it is always the lowest that stay', () => {
  for (const [words, thisTime] of /** @type {const} */ ([
    [en, /^This time/],
    [ko, /^이번에는/],
  ])) {
    const [lowest] = anatomiesOf('ep', 1, { selection: 'truncation' }).slice(-1);
    assert.doesNotMatch(words.upsetText(lowest), thisTime);
    const lucky = anatomiesOf('ep', 40, { population: 3 }).find(({ upset }) => !upset);
    assert.match(words.upsetText(/** @type {Anatomy} */ (lucky)), thisTime);
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
