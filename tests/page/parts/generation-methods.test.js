// What Generation shows of each method is what the core's record says of it.
import assert from 'node:assert/strict';
import { methods } from '../../../www/core/methods.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { phasesOf, shownIn } from '../../../www/parts/generation/phases.js';
import { pointsOf, sketchOf } from '../../../www/parts/generation/sketch.js';
import { generationTable } from '../../../www/parts/generation/table.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { followTo, ownSection } from './generation-page.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/parts/generation/record.js').Anatomy} Anatomy */
/** @typedef {import('../../../www/parts/generation/record.js').Method} Method */

const base = experiment('velocity-limits');
const rivals = /** @type {readonly Exclude<Method, 'ep'>[]} */ (
  Object.keys(methods).filter((method) => method !== 'ep')
);

/** @param {Method} method @param {number} generations @param {Partial<typeof base.evolution>} [change] @returns {Anatomy[]} */
function anatomiesOf(method, generations, change = {}) {
  const settings = { ...base.evolution, ...change, method };
  const evolution = new Evolution({ ...base, evolution: settings });
  for (let i = 0; i < generations; i += 1) evolution.step();
  return Array.from({ length: generations + 1 }, (_, g) => dissect(evolution.record(g), settings));
}

/** @param {readonly number[]} a @param {readonly number[]} b */
const isNear = (a, b) => a.every((value, i) => Math.abs(value - b[i]) <= 1e-9 * (1 + Math.abs(value)));

test('every phase of every method has its sentence and its name, in both languages', () => {
  const said = new Map();
  for (const method of rivals)
    for (const anatomy of anatomiesOf(method, 120)) {
      const { count, columns, rowOf } = generationTable(anatomy);
      for (let row = 0; row < count; row += 1) {
        assert.equal(rowOf(row).length, columns.length);
        assert.doesNotMatch(rowOf(row).join(), /undefined|NaN/);
      }
      for (const phase of phasesOf(anatomy))
        for (const words of [en, ko]) {
          const text = words.sentence(anatomy, phase);
          assert.ok(text.length > 5 && !/undefined|NaN|Infinity/.test(text), `${method} ${phase}: ${text}`);
          assert.notEqual(words.phaseName(anatomy, phase), phase);
          for (const number of anatomy.all.keys()) assert.ok(words.nameOf(anatomy, number));
          said.set(`${method} ${phase} ${text.replace(/[\d.·⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+/g, '#')}`, true);
        }
    }
  // Each move of the simplex, each outcome of a step.
  for (const part of [
    'Reflection',
    'Expansion',
    'Contraction inside',
    'Success',
    'Failure',
    'probes',
    'a step up',
  ])
    assert.ok(
      [...said.keys()].some((text) => text.includes(part)),
      part,
    );
});

test('all that a phase draws lies among the points for which the picture has room', () => {
  for (const method of rivals)
    for (const anatomy of anatomiesOf(method, 60)) {
      const points = pointsOf(anatomy);
      const [low, high] = [Math.min, Math.max].map((most) =>
        [0, 1, 2].map((j) => most(...points.map((point) => point[j]))),
      );
      for (const phase of phasesOf(anatomy)) {
        if (shownIn(method, phase) !== 'gains') continue;
        const chosen = phase === 'parents' ? 0 : anatomy.count;
        const { lines, rings, names } = sketchOf(anatomy, phase, Math.min(chosen, anatomy.all.length - 1));
        const drawn = [...lines.flatMap(({ from, to }) => [from, to]), ...names.map(({ at }) => at)];
        for (const point of drawn)
          assert.ok(
            point.every((value, j) => value >= low[j] - 1e-9 && value <= high[j] + 1e-9),
            `${method} ${phase} ${anatomy.record.generation}: ${point}`,
          );
        for (const { outline } of rings)
          for (const [x, y] of outline((gains) => [gains[0], gains[1]]))
            assert.ok(x >= low[0] - 1e-6 && x <= high[0] + 1e-6 && y >= low[1] - 1e-6 && y <= high[1] + 1e-6);
      }
    }
});

test('a step of the sketch leads to what was tried', () => {
  for (const method of /** @type {const} */ (['one-plus-one-es', 'one-at-a-time', 'finite-differences']))
    for (const anatomy of anatomiesOf(method, 40).slice(1))
      for (const [own, { gains }] of anatomy.record.offspring.entries()) {
        const steps = sketchOf(anatomy, 'mutation', anatomy.count + own).lines.filter(
          ({ kind }) => kind === 'step',
        );
        assert.deepEqual(steps, [{ from: anatomy.record.parents[0].gains, to: gains, kind: 'step' }]);
      }
  for (const anatomy of anatomiesOf('de', 10).slice(1))
    for (const [own, { gains }] of anatomy.record.offspring.entries()) {
      const { lines, names } = sketchOf(anatomy, 'mutation', anatomy.count + own);
      const [, step, crossed] = lines;
      const [a, b, c] = names.map(({ at }) => at);
      assert.ok(
        isNear(
          step.to,
          a.map((value, j) => value + 0.5 * (b[j] - c[j])),
        ),
      );
      assert.deepEqual((crossed ?? step).to, gains);
    }
});

test('the simplex that is drawn in the end is the one from which the next generation goes', () => {
  const anatomies = anatomiesOf('nelder-mead', 120);
  for (const [i, anatomy] of anatomies.slice(0, -1).entries()) {
    const edges = (/** @type {Anatomy} */ of, /** @type {'parents' | 'survivors'} */ phase) =>
      sketchOf(of, phase, 0).lines.filter(({ kind }) => kind === 'edge');
    assert.deepEqual(edges(anatomy, 'survivors'), edges(anatomies[i + 1], 'parents'));
  }
});

/** Follows a link to a generation of a method in one of its phases. @param {Page} page @param {string} method @param {number} generation @param {string} phase @param {string} [more] */
async function openAt(page, method, generation, phase, more = '') {
  await followTo(page, generation, `evolution.method=${method}&phase=${phase}${more}`);
}

/** @param {Page} page */
const readDetails = (page) =>
  page.evaluate(() => ({
    equations: [...document.querySelectorAll('#generation-details .gain-row')].map((row) =>
      [...row.querySelectorAll('.equation')].map((line) => /** @type {HTMLElement} */ (line).innerText),
    ),
    headline: /** @type {HTMLElement} */ (document.querySelector('#generation-details .headline')).innerText,
    said: document.getElementById('generation-picture')?.getAttribute('aria-valuetext') ?? '',
  }));

/** @param {string} text */
const numbersIn = (text) =>
  (
    text
      .replaceAll('−', '-')
      .replaceAll('- ', '-')
      .match(/-?\d+(\.\d+)?(?![\d.]*×)/g) ?? []
  ).map(Number);

/** That a printed number is the exact one, rounded. @param {number} printed @param {number} exact @param {string} what */
const same = (printed, exact, what) =>
  assert.ok(Math.abs(printed - exact) <= 0.00051 * Math.max(1, Math.abs(exact)), `${what}: ${exact}`);

/** One generation of every move of the simplex but its beginning, which is no sum. @returns {[Method, number][]} */
function movesOfSimplex() {
  const motions = ['reflection', 'expansion', 'outside-contraction', 'inside-contraction', 'shrink'];
  const moves = anatomiesOf('nelder-mead', 400).map(({ record }) => String(record.plan.motion));
  return motions.map((motion) => ['nelder-mead', moves.indexOf(motion)]);
}

pageTest('the numbers of a trial are those of the record', async (page) => {
  for (const [method, generation] of /** @type {[Method, number][]} */ ([
    ['de', 6],
    ['cma-es', 6],
    ['one-plus-one-es', 6],
    ...movesOfSimplex(),
    ['one-at-a-time', 6],
  ])) {
    const anatomy = anatomiesOf(method, generation)[generation];
    const { record, count } = anatomy;
    // The last: three corners of a simplex shrink at once.
    const own = record.offspring.length - 1;
    await openAt(page, method, generation, 'mutation', `&individual=${count + own}`);
    const { equations, headline } = await readDetails(page);
    const name = headline.split(/\s+/).slice(0, 2).join(' ').toLowerCase();
    assert.equal(name, en.nameOf(anatomy, count + own));
    const trial = record.offspring[own].gains;
    for (const [i, lines] of equations.entries()) {
      const told = method === 'de' ? lines[1] : lines[0];
      const what = `${method}, generation ${generation}: ${lines.join(' / ')}`;
      same(/** @type {number} */ (numbersIn(told).at(-1)), trial[i], what);
    }
    assert.deepEqual(await page.problems(), []);
  }
});

pageTest('what each method learns is told, and is what the next generation goes by', async (page) => {
  const [cma] = anatomiesOf('cma-es', 6).slice(-1);
  await openAt(page, 'cma-es', 6, 'survivors');
  for (const [i, [mean]] of (await readDetails(page)).equations.entries()) {
    const [before, after] = numbersIn(mean);
    same(before, cma.record.ellipse?.mean[i] ?? Number.NaN, mean);
    same(after, cma.record.next.ellipse?.mean[i] ?? Number.NaN, mean);
  }
  const [hand] = anatomiesOf('one-at-a-time', 6).slice(-1);
  await openAt(page, 'one-at-a-time', 6, 'survivors');
  for (const [i, [, step]] of (await readDetails(page)).equations.entries())
    same(numbersIn(step.replace('+', ''))[0], hand.record.next.steps?.[i] ?? Number.NaN, step);
  const slopes = anatomiesOf('finite-differences', 30);
  const probed = slopes.findIndex(
    ({ record }) => record.generation > 0 && !record.plan.steps && record.next.slope,
  );
  await openAt(page, 'finite-differences', probed, 'survivors');
  for (const [i, [slope]] of (await readDetails(page)).equations.entries())
    if (!slope.includes('×'))
      same(numbersIn(slope.replace('+', ''))[0], slopes[probed].record.next.slope?.[i] ?? Number.NaN, slope);
});

pageTest('the ranks of CMA-ES tell their weights, and so does its table', async (page) => {
  const [anatomy] = anatomiesOf('cma-es', 4).slice(-1);
  const { weights } = anatomy.record.plan;
  await openAt(page, 'cma-es', 4, 'ranking');
  await page.focus('#generation-picture');
  await page.press(Key.HOME);
  const ranks = await page.evaluate(() =>
    [...document.querySelectorAll('#generation-details .ranks li')].map(
      (row) => /** @type {HTMLElement} */ (row.querySelector('.wins')).innerText,
    ),
  );
  assert.deepEqual(
    ranks,
    [0, 8, 9, 10, 11].map((rank) => (weights[rank] ?? 0).toFixed(3)),
  );
  assert.equal(
    await page.evaluate(() => document.querySelectorAll('#generation-picture .weight').length),
    10,
  );
  await page.click('#generation-table');
  const cells = await page.evaluate(() =>
    [...document.querySelectorAll('#table-rows tbody tr')]
      .slice(0, 20)
      .map((row) => /** @type {HTMLElement} */ (row.children[row.children.length - 2]).innerText),
  );
  assert.deepEqual(
    cells,
    Array.from({ length: 20 }, (_, rank) => (weights[rank] ?? 0).toFixed(3)),
  );
});

/** What is said of the picture in each phase that can be chosen, and how high the page is then. @param {Page} page */
const seenPhases = (page) =>
  page.evaluate(async () => {
    const seen = [];
    for (const { id, value } of /** @type {NodeListOf<HTMLInputElement>} */ (
      document.querySelectorAll('#generation-phases input:not(:disabled)')
    )) {
      document.getElementById(id)?.click();
      await pageFrames.settled();
      const picture = document.getElementById('generation-picture');
      const said = picture?.dataset.drawn === value ? picture.getAttribute('aria-valuetext') : null;
      seen.push({ phase: value, said: said ?? '', height: document.documentElement.scrollHeight });
    }
    return seen;
  });

/** The paper's own method stands in generation-steps.test.js. @type {readonly [Method, Partial<typeof base.evolution>][]} */
const searches = [
  ...rivals.map((method) => /** @type {[Method, {}]} */ ([method, {}])),
  ['ep', { selection: 'truncation' }],
  ['ep', { crossover: 1 }],
];

pageTest(
  'each phase of each method is in sight without scrolling, and readable for everybody',
  async (page) => {
    await page.resize(1024, 768);
    for (const language of ['en', 'ko']) {
      await page.open(`#generation&v=1&lang=${language}`);
      for (const [method, change] of searches) {
        const settings = Object.entries(change).map(([name, value]) => `&evolution.${name}=${value}`);
        await openAt(page, method, 4, 'parents', `&lang=${language}${settings.join('')}`);
        const seen = await seenPhases(page);
        assert.deepEqual(
          seen.map(({ phase }) => phase),
          phasesOf(anatomiesOf(method, 4, change)[4]),
        );
        for (const { phase, said, height } of seen) {
          assert.ok(phase === 'mutation' ? said !== '' : said.includes('J '), said);
          assert.equal(height, 768, `${language} ${method} ${phase}`);
        }
        if (language === 'en') assert.deepEqual(await page.obstacles(ownSection), [], method);
      }
      assert.deepEqual(await page.problems(), []);
    }
  },
);
