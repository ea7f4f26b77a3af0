// The equations of a mutation, as they are written, against the record of the core.
import assert from 'node:assert/strict';
import { bell, shareOf } from '../../../www/parts/generation/bell.js';
import { ratesOf } from '../../../www/parts/generation/birth.js';
import { detailsOf } from '../../../www/parts/generation/details.js';
import { columnsOf, placesOf } from '../../../www/parts/generation/places.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { generationTable } from '../../../www/parts/generation/table.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { pageTest } from '../harness/browsers.js';
import { createEngine, Evolution, experiment, wordFields } from '../harness/core.js';
import { test } from '../harness/once.js';
import { written } from '../harness/templates.js';
import { numbersIn, same } from './generation-page.js';

/** @typedef {typeof usual.evolution} Settings */
/** @typedef {ReturnType<typeof dissect>} Anatomy */

const usual = experiment('velocity-limits');

/** The newest of some generations. @param {Partial<Settings>} change @param {number} [generation] */
function anatomyOf(change, generation = 1) {
  const settings = { ...usual.evolution, ...change };
  const evolution = new Evolution({ ...usual, evolution: settings });
  for (let g = 0; g < generation; g += 1) evolution.step();
  return dissect(evolution.record(generation), settings);
}

/** What is written of how one came to be, and the equations in it. @param {Anatomy} anatomy @param {number} chosen @param {number} [adaptation] */
function toldOf(anatomy, chosen, adaptation = 1) {
  const model = /** @type {any} */ ({ anatomy, phase: 'mutation', chosen });
  const rates = ratesOf(createEngine().learningRates(), adaptation);
  const html = written(detailsOf(model, { rates, choose() {} }));
  const plain = (/** @type {string} */ text) => text.replaceAll(/<[^>]*>/g, ' ').replaceAll(/\s+/g, ' ');
  const equations = [...html.matchAll(/<p class="equation">(.*?)<\/p>/gs)].map(([, one]) => plain(one));
  return { text: plain(html), equations, unbroken: html.split(/ =\u00a0(?=\d)/).length - 1 };
}

/** What evolutionary programming may be made of: for each choice, all its words. @type {readonly Partial<Settings>[][]} */
const choices = wordFields()
  .filter(({ path }) => path.startsWith('evolution.') && path !== 'evolution.method')
  .map(({ path, words }) => words.map((word) => ({ [path.replace('evolution.', '')]: word })));

/** @type {readonly Partial<Settings>[]} */
const ingredients = [
  ...choices.flat(),
  { adaptation: 0 },
  { adaptation: 0.5 },
  { sigmaFloor: 0.5 },
  { crossover: 1 },
  { crossover: 0.5, belowZero: 'mirror', sigmaFloor: 1 },
];

test('what is written of a mutation is true, whatever it is made of: each equation comes to what follows it', () => {
  let arrows = 0;
  for (const change of ingredients) {
    const { adaptation = 1 } = change;
    for (const generation of [1, 3]) {
      const anatomy = anatomyOf(change, generation);
      const { record, count } = anatomy;
      for (let chosen = 0; chosen < 2 * count; chosen += 1) {
        const { equations, unbroken } = toldOf(anatomy, chosen, adaptation);
        // What each σ comes to stands in no line of its own.
        assert.deepEqual([equations.length, unbroken], [6, 3]);
        const child = record.offspring[chosen % count];
        for (const [i, equation] of equations.entries()) {
          const what = `${JSON.stringify(change)}: ${equation}`;
          const [name, sum, result] = equation.split(' = ');
          assert.match(name, /^ ?[kσ] [xyθ] ′$/, what);
          const [before, a, b, c] = numbersIn(sum).map(Number);
          const isGain = i % 2 === 0;
          const value = isGain ? before + a * b : before * Math.exp(a + b * c);
          const [came, ...rest] = numbersIn(result);
          // A sum as printed, to the last digit.
          const digits = came?.split('.')[1]?.length ?? 0;
          const most = isGain ? 0.500001 / 10 ** digits : 0.005 * (1 + value);
          assert.ok(Math.abs(value - Number(came)) <= most, what);
          same(rest[0] ?? came, isGain ? child.gains[i / 2] : child.sigmas[(i - 1) / 2], what);
          assert.notEqual(rest[0], came, what);
          arrows += rest.length;
        }
      }
    }
  }
  assert.ok(arrows > 0);
});

/** The first births, some of gains below 0, and what is said of them, without their numbers. @param {Partial<Settings>} word */
function birthsOf(word) {
  const anatomy = anatomyOf({ initialSigma: 5, crossover: 0.5, ...word });
  const { parents, offspring } = anatomy.record;
  const texts = offspring.flatMap((_, pair) => toldOf(anatomy, pair).text.split(' '));
  const said = new Set(texts.filter((text) => !/[\d→]/.test(text)));
  return {
    word: JSON.stringify(word),
    parents: JSON.stringify(parents),
    offspring: JSON.stringify(offspring),
    said: [...said].sort().join(' '),
  };
}

test('a word by which the same parents have other offspring is said', () => {
  let others = 0;
  for (const births of choices.map((words) => words.map(birthsOf)))
    for (const [i, one] of births.entries())
      for (const other of births.slice(i + 1).filter(({ parents }) => parents === one.parents)) {
        if (one.offspring === other.offspring) continue;
        others += 1;
        assert.notEqual(one.said, other.said, `${one.word} and ${other.word}`);
      }
  assert.ok(others > 0);
});

test('who has no offspring beside it stands above its own number', () => {
  const size = { width: 493, height: 180 };
  for (const generation of [1, 4]) {
    const anatomy = anatomyOf({}, generation);
    const { x } = columnsOf(size, anatomy.columns);
    const [parents, mutation, survivors] = /** @type {const} */ (['parents', 'mutation', 'survivors']).map(
      (phase) => placesOf(anatomy, phase, size),
    );
    for (let number = 0; number < anatomy.count; number += 1) {
      assert.equal(parents[number].x, x(number));
      assert.ok(mutation[number].x < x(number) && x(number) < mutation[number + anatomy.count].x);
      assert.equal(survivors[anatomy.ranking[number]].x, x(number));
    }
  }
});

test('where an arrow may stand its rule is written, and where the draws are Cauchy’s the formula says so', () => {
  for (const words of [en, ko]) assert.notEqual(words.belowZeroText.mirror, words.belowZeroText.clamp);
  const rules = [en.belowZeroText.clamp, en.belowZeroText.mirror, en.floorText('0.500'), en.cauchyText];
  const written = (/** @type {Partial<Settings>} */ change) => {
    const { text } = toldOf(anatomyOf(change), 3);
    return rules.filter((rule) => text.includes(rule));
  };
  assert.deepEqual(written({}), []);
  assert.deepEqual(written({ belowZero: 'clamp' }), rules.slice(0, 1));
  assert.deepEqual(written({ method: 'de', belowZero: 'mirror', sigmaFloor: 0.5 }), rules.slice(1, 2));
  assert.deepEqual(written({ sigmaFloor: 0.5, step: 'cauchy' }), rules.slice(2));
  const { gaussian, cauchy } = en.formula.gain;
  for (const [step, own] of /** @type {const} */ ([
    ['gaussian', gaussian],
    ['cauchy', cauchy],
  ])) {
    const { text } = toldOf(anatomyOf({ step }), 3);
    for (const formula of [gaussian, cauchy]) assert.equal(text.includes(formula), formula === own, text);
  }
});

test('the picture of a draw is that of its distribution, and what lies beyond it is no point of it', () => {
  const heights = (/** @type {'gaussian' | 'cauchy'} */ step) =>
    [...(/class="density" d="M([^"]*)"/.exec(written(bell(null, step)))?.[1] ?? '').split('L')].map((point) =>
      Number(point.split(' ')[1]),
    );
  const [top, foot] = [4, 34];
  for (const [step, reach, density] of /** @type {const} */ ([
    ['gaussian', 3.3, (/** @type {number} */ x) => Math.exp((-x * x) / 2)],
    ['cauchy', 10, (/** @type {number} */ x) => 1 / (1 + x * x)],
  ]))
    for (const [i, height] of heights(step).entries())
      assert.ok(Math.abs(height - (foot - (foot - top) * density(reach * (i / 22 - 1)))) <= 0.051, step);
  const marks = (/** @type {number} */ draw) =>
    written(bell(draw, 'cauchy')).match(/<(circle|path) class="drawn"/)?.[1];
  assert.deepEqual([0, 9, -9, 11, -1e9].map(marks), ['circle', 'circle', 'circle', 'path', 'path']);
});

test('the pictures of three draws have one scale: each is as wide as its σ, and its mark is as far off as the gain moved', () => {
  const sigmas = [0.863, 1.204, 2.67];
  for (const [i, sigma] of sigmas.entries()) {
    const share = shareOf(sigmas, i);
    assert.equal(share, sigma / 2.67);
    const picture = written(bell(-1.2, 'gaussian', share));
    const [first] = /class="density" d="M([^ ]*)/.exec(picture)?.slice(1).map(Number) ?? [];
    assert.ok(Math.abs(first - 42 * (1 - share)) < 0.051, picture);
    const [x] = /cx="?([^" ]*)/.exec(picture)?.slice(1).map(Number) ?? [];
    assert.ok(Math.abs((42 - x) / 42 - (1.2 * sigma) / (3.3 * 2.67)) < 1e-9, picture);
  }
  // What lies beyond the picture of the widest may lie within that of none.
  const farthest = (/** @type {number} */ share) => written(bell(5, 'gaussian', share)).includes('<circle');
  assert.deepEqual([0.5, 1].map(farthest), [true, false]);
  assert.equal(shareOf([Infinity, 1, 1], 1), 1);
  // Without a σ nothing moves, whatever was drawn.
  const still = written(bell(-1.2, 'gaussian', shareOf([0, 0, 0], 1)));
  assert.match(still, /class="density" d="M42\.0 [^"]*L42\.0 /);
  assert.match(still, /cx="?42"? /);
});

test('a parent that was crossed names the other, and the gains that it got from there', () => {
  const anatomy = anatomyOf({ crossover: 0.6 });
  const { record, count } = anatomy;
  let alone = 0;
  for (let pair = 0; pair < count; pair += 1) {
    const [donor] = record.donors[pair];
    const { text } = toldOf(anatomy, pair);
    const row = generationTable(anatomy).rowOf(anatomy.ranks[pair + count]);
    assert.equal(row[3], [`parent ${pair + 1}`, ...record.donors[pair].map((one) => one + 1)].join(', '));
    if (donor === undefined) {
      alone += 1;
      assert.ok(!text.includes(en.crossedWith), text);
      continue;
    }
    const given = ['kx', 'ky', 'kθ'].filter(
      (_, j) => record.bases[pair].gains[j] === record.parents[donor].gains[j],
    );
    assert.ok(text.includes(`${en.crossedWith}parent ${donor + 1} ${en.givenText(given)}`), text);
  }
  assert.ok(alone > 0 && alone < count);
  for (const words of [en, ko]) {
    assert.match(words.sentence(anatomy, 'mutation'), new RegExp(`${count - alone}\\D`));
    assert.doesNotMatch(words.sentence(anatomyOf({}), 'mutation'), /\d/);
  }
});

test('of a draw that was held at 0 or may have been mirrored there it is not told how far it went', () => {
  for (const belowZero of /** @type {const} */ (['clamp', 'mirror'])) {
    const seen = { told: 0, untold: 0 };
    for (let seed = 1; seed <= 60; seed += 1) {
      const change = { method: /** @type {const} */ ('one-plus-one-es'), seed };
      const anatomy = anatomyOf({ ...change, belowZero });
      // The first step is drawn alike; with the penalty it is tried as it is.
      const { record } = anatomyOf(change);
      const { equations } = toldOf(anatomy, 1);
      for (const i of [0, 1, 2]) {
        const [from, drawn] = [record.parents[0].gains[i], record.offspring[0].gains[i]];
        const [told] = /times σ/.test(equations[2 * i + 1]) ? numbersIn(equations[2 * i + 1]) : [];
        const tried = anatomy.record.offspring[0].gains[i];
        same(numbersIn(equations[2 * i]).at(-1), tried, equations[2 * i]);
        if (told === undefined) seen.untold += 1;
        else {
          seen.told += 1;
          same(told, drawn - from, equations[2 * i + 1]);
        }
        if (tried !== drawn) assert.equal(told, undefined, equations[2 * i + 1]);
      }
    }
    assert.ok(seen.told > 0 && seen.untold > 0, JSON.stringify(seen));
  }
});

test('a step that ends below 0 is written as it was taken', () => {
  let arrows = 0;
  for (const method of /** @type {const} */ (['one-at-a-time', 'finite-differences']))
    for (let generation = 1; generation <= 30; generation += 1) {
      const anatomy = anatomyOf({ method, belowZero: 'clamp' }, generation);
      const { parents, offspring, plan } = anatomy.record;
      if (!plan.steps) continue;
      for (const [i, equation] of toldOf(anatomy, anatomy.count).equations.entries()) {
        const [result, after = result] = numbersIn(equation.split(' = ').at(-1) ?? '').slice(-2);
        if (!equation.includes('=')) assert.equal(offspring[0].gains[i], parents[0].gains[i], equation);
        else {
          same(result, parents[0].gains[i] + plan.steps[i], equation);
          same(after, offspring[0].gains[i], equation);
          if (equation.includes('→')) arrows += 1;
        }
      }
    }
  assert.ok(arrows > 0);
});

pageTest('a crossed parent’s partner can be opened, and an arrow leads to what was tried', async (page) => {
  const change = { crossover: 1, belowZero: /** @type {const} */ ('mirror') };
  /** The first pair whose offspring would lie below 0. @param {Anatomy} anatomy */
  const mirroredIn = ({ record: { bases, mutations } }) =>
    bases.findIndex(({ gains, sigmas }, i) =>
      gains.some((gain, j) => gain + sigmas[j] * mutations[i].gains[j] < -0.01),
    );
  const generations = Array.from({ length: 20 }, (_, g) => anatomyOf(change, g + 1));
  const { record, count } = /** @type {Anatomy} */ (generations.find((one) => mirroredIn(one) >= 0));
  const pair = mirroredIn(/** @type {any} */ ({ record }));
  await page.open(
    `#generation&v=1&generation=${record.generation}&phase=mutation&individual=${pair + count}&evolution.crossover=1&evolution.belowZero=mirror`,
  );
  const { told, arrows } = await page.until('how it came to be', () => {
    const details = document.getElementById('generation-details');
    const equations = [...(details?.querySelectorAll('.equation') ?? [])];
    return (
      details?.querySelector('.donors') && {
        told: details.innerText,
        arrows: equations.filter((one) => one.textContent?.includes('→')).length,
      }
    );
  });
  const other = `parent ${record.donors[pair][0] + 1}`;
  assert.ok(arrows > 0 && told.includes(other) && told.includes(en.belowZeroText.mirror), told);
  await page.click('#generation-details .donors button');
  const isChosen = (/** @type {string} */ name) =>
    document.getElementById('generation-picture')?.getAttribute('aria-valuetext')?.startsWith(`${name},`);
  await page.until('the other parent is chosen', isChosen, other);
  assert.deepEqual(await page.obstacles(), []);
  assert.deepEqual(await page.problems(), []);
});
