import assert from 'node:assert/strict';
import { generationSlice } from '../../../www/parts/generation/state.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { anatomyOf as anatomyIn, placeByCost } from '../../../www/lesson/anatomy.js';
import { gainFormula, sigmaFormula } from '../../../www/lesson/formulas/formulas.js';
import { question } from '../../../www/lesson/steps/generation.js';
import { generation as words } from '../../../www/lesson/words/en/generation.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, experiment, simulate, wordFields } from '../harness/core.js';
import { evolved, opened, shownIn } from './links.js';
import { answered, liveOf, numbersOn, toldBy, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('generation');
const usual = experiment('velocity-limits');

/** The generation that a link shows. @param {string} link */
function anatomyOf(link) {
  const { evolution, generation } = evolved(link);
  return dissect(evolution.record(generation));
}

/** The records of the first generations of some seeds. @param {number} seeds @param {number} generations */
function recordsOf(seeds, generations) {
  return Array.from({ length: seeds }, (_, i) => {
    const evolution = new Evolution({ ...usual, evolution: { ...usual.evolution, seed: i + 1 } });
    return Array.from({ length: generations }, (_, g) => {
      evolution.step();
      return evolution.record(g + 1);
    });
  }).flat();
}

/** The links within a text. @param {string} text */
const linksIn = (text) => [...text.matchAll(/\]\(([^)]+)\)/g)].map(([, link]) => link);

/** @param {number} a @param {number} b @param {string} what */
const near = (a, b, what) =>
  assert.ok(Math.abs(a - b) <= 1e-12 * Math.max(1, Math.abs(a)), `${what}: ${a}, ${b}`);

test('the four moves show one generation and one pair, phase by phase', () => {
  const { mutate, drive, select } = words.texts;
  const links = [step.link, ...[mutate, drive, select].flatMap(linksIn)];
  const phases = links.map((link) => {
    const shown = shownIn(link, generationSlice);
    assert.equal(opened(link).generation, 1);
    assert.equal(shown.chosen, 26);
    return shown.phase;
  });
  assert.deepEqual(phases, ['parents', 'mutation', 'drive', 'tournament', 'survivors']);
});

test('an offspring is its parent moved by the old σ times a draw, which is rarely beyond ±2', () => {
  const draws = [];
  for (const { parents, offspring, mutations } of recordsOf(5, 20))
    for (const [i, child] of offspring.entries())
      for (const j of [0, 1, 2]) {
        near(child.gains[j], parents[i].gains[j] + parents[i].sigmas[j] * mutations[i].gains[j], 'k′');
        draws.push(mutations[i].gains[j]);
      }
  assert.ok(draws.filter((draw) => Math.abs(draw) > 2).length < 0.06 * draws.length);
  for (const { sigmas } of anatomyOf(step.link).record.parents) assert.deepEqual(sigmas, [1, 1, 1]);
});

test('most offspring drive worse than their parent', () => {
  const { record } = anatomyOf(step.link);
  const betterIn = (/** @type {typeof record} */ { offspring, parents }) =>
    offspring.filter(({ cost }, i) => cost < parents[i].cost).length;
  assert.ok(betterIn(record) < 10);
  const records = recordsOf(20, 30);
  const share = records.reduce((sum, one) => sum + betterIn(one), 0) / (20 * records.length);
  assert.ok(share < 0.3, `${share}`);
});

test('ten bouts each; the twenty with the most wins stay, with gains, σ and J; 20 drives a generation', () => {
  const { evolution } = evolved('generation&generation=2');
  const { record, all } = dissect(evolution.record(1));
  for (const [i, met] of record.opponents.entries()) {
    assert.equal(met.length, 10);
    assert.equal(record.wins[i], met.filter((other) => all[i].cost <= all[other].cost).length);
  }
  const fewest = Math.min(...record.survivors.map((number) => record.wins[number]));
  for (const number of all.keys())
    if (!record.survivors.includes(number)) assert.ok(record.wins[number] <= fewest);
  assert.deepEqual(
    evolution.record(2).parents,
    record.survivors.map((number) => all[number]),
  );
  assert.equal(evolution.statistics(2).evaluations - evolution.statistics(1).evaluations, 20);
});

test('of the two in the question the better one falls, and the answer says so', async () => {
  const { better, worse, right } = (await answered('generation', 'luck')).outcome;
  assert.ok(better.cost < worse.cost && better.place < worse.place);
  assert.equal(right, 1);
  assert.match(words.quizzes.luck.question, /offspring 11 .* offspring 9\./);
  const { record, upset } = anatomyOf('generation&generation=1');
  assert.ok(!record.survivors.includes(question.better) && record.survivors.includes(question.worse));
  // What the figure tells before the answer is of another pair.
  for (const one of Object.values(question)) assert.ok(!Object.values(upset ?? question).includes(one));
});

test('of a best J that only fell it is said that it never rose', () => {
  const { why } = words.quizzes.best;
  assert.match(why({ generations: 60, fell: 16, rose: 0 }), / fell 16 times and never rose\./);
  assert.match(why({ generations: 60, fell: 16, rose: 2 }), / fell 16 times and rose 2 times\./);
});

test('the best J never rises, for the best wins all its bouts', async () => {
  const { rose, fell, right } = (await answered('generation', 'best')).outcome;
  assert.equal(rose, 0);
  assert.ok(fell > 10);
  assert.equal(right, 2);
  for (const record of recordsOf(20, 30)) {
    const { all } = dissect(record);
    const costs = all.map(({ cost }) => cost);
    const best = costs.indexOf(Math.min(...costs));
    assert.equal(record.wins[best], 10);
    assert.equal(record.survivors[0], best);
  }
});

test('whatever searches and selects, the step has all its numbers, and a formula has its numbers or none', async () => {
  const wordsOf = (/** @type {string} */ name) =>
    wordFields().find(({ path }) => path === `evolution.${name}`)?.words ?? [];
  const settings = [
    ...wordsOf('method').map((word) => ['method', word]),
    ...wordsOf('selection').map((word) => ['selection', word]),
  ];
  assert.ok(settings.length > 8);
  const first = await toldBy(step, liveOf('lab&generation=1'));
  const names = Object.values(words.texts).flatMap((text) =>
    [...text.matchAll(/\{=(\w+)\}/g)].map(([, name]) => name),
  );
  for (const [name, word] of settings)
    for (const generation of [0, 1, 5]) {
      const where = `${word}, generation ${generation}`;
      const live = liveOf(`lab&evolution.${name}=${word}&generation=${generation}`);
      const isPapers = generation > 0 && (name === 'selection' || word === 'ep');
      for (const { numbers } of [gainFormula, sigmaFormula])
        assert.equal(Object.keys(numbers?.(live) ?? {}).length > 0, isPapers, where);
      const known = await toldBy(step, live);
      for (const one of names) assert.match(known[one] ?? '', /^\w/, `${where}: ${one}`);
      assert.doesNotMatch(JSON.stringify(known), /undefined|NaN/, where);
      const hasBouts = isPapers && ['ep', 'tournament'].includes(word);
      if (!isPapers) assert.deepEqual(known, first, where);
      else if (!hasBouts)
        for (const one of ['all', 'bouts', 'chosen', 'wins', 'fate'])
          assert.equal(known[one], first[one], `${where}: ${one}`);
      else {
        const { record, all } = anatomyIn(live);
        assert.ok(known.fate.includes(`of generation ${generation + 1}`) || /fell/.test(known.fate), where);
        assert.ok(
          all.some(({ cost }) => cost.toFixed(3) === known.childCost),
          where,
        );
        assert.equal(known.bouts, String(record.opponents[0].length), where);
      }
    }
});

test('what the figure does not have is told of generation 1 of the same run', async () => {
  for (const rest of ['seed=3', 'population=6', 'goal.theta=90deg&individual=3'])
    assert.deepEqual(
      await toldBy(step, liveOf(`generation&generation=0&${rest}`)),
      await toldBy(step, liveOf(`generation&generation=1&${rest}`)),
      rest,
    );
});

test('whatever a birth is made of, the formulas with its numbers come to what they say', () => {
  const read = (/** @type {string} */ text) => Number(text.replaceAll('−', '-').replace(/^\((.*)\)$/, '$1'));
  const about = (/** @type {number} */ value, /** @type {number} */ other, /** @type {string} */ what) =>
    assert.ok(Math.abs(value - other) < 0.005 * (1 + Math.abs(other)), `${what}: ${value}, ${other}`);
  for (const [setting, hasArrows] of /** @type {const} */ ([
    ['evolution.adaptation=0.5', false],
    ['evolution.crossover=1', false],
    ['evolution.belowZero=mirror', true],
    ['evolution.belowZero=clamp&evolution.sigmaFloor=1', true],
  ])) {
    let arrows = 0;
    for (let individual = 0; individual < 20; individual += 1) {
      const live = liveOf(`generation&generation=1&individual=${individual}&${setting}`);
      const { record } = anatomyIn(live);
      const [gain, sigma] = [gainFormula, sigmaFormula].map(({ numbers }) => numbers?.(live) ?? {});
      for (const [j, index] of ['x', 'y', 't'].entries()) {
        const what = `${setting}, ${individual + 1}, ${index}`;
        const [child, sum = child] = gain[`newk${index}`].split(' ← ').map(read);
        const [k, s, n] = ['k', 's', 'N'].map((letter) => read(gain[letter + index]));
        about(k + s * n, sum, what);
        about(child, record.offspring[individual].gains[j], what);
        const [own, grown = own] = sigma[`news${index}`].split(' ← ').map(read);
        const [tau, common, shared] = ['tau', 'tau2', 'N'].map((letter) => read(sigma[letter]));
        const [before, draw] = ['s', 'N2'].map((letter) => read(sigma[letter + index]));
        about(before * Math.exp(common * shared + tau * draw), grown, what);
        about(own, record.offspring[0].sigmas[j], what);
        arrows += Number(child !== sum) + Number(own !== grown);
      }
    }
    assert.equal(arrows > 0, hasArrows, setting);
  }
});

test('what its tries are said to show', () => {
  const lucky = anatomyOf(tryOf('generation', 'lucky'));
  const { upset } = lucky;
  assert.equal(upset?.survivor, 12);
  assert.equal(shownIn(tryOf('generation', 'lucky'), generationSlice).chosen, 12);
  assert.ok(placeByCost(lucky, 12) > 20);

  const below = tryOf('generation', 'below');
  const chosen = shownIn(below, generationSlice).chosen ?? 0;
  const { gains } = anatomyOf(below).all[chosen];
  const { cost } = simulate(usual, gains);
  assert.equal(chosen, 20 + 14);
  assert.ok(Math.min(...gains) < 0 && cost.penalty > cost.total / 2);

  const bouts = anatomyOf(tryOf('generation', 'bouts'));
  assert.equal(bouts.record.opponents[0].length, 200);
  assert.equal(bouts.upset, null);

  const betterOf = (/** @type {string} */ link) => {
    const { offspring, parents } = anatomyOf(link).record;
    return offspring.filter((one, i) => one.cost < parents[i].cost).length;
  };
  assert.ok(betterOf(tryOf('generation', 'late')) < betterOf(step.link) / 2);
});

pageTest(
  'the text tells of whoever is chosen in the figure, and the formula has the numbers',
  async (page) => {
    await page.open('#lesson&step=7');
    const { record, all } = anatomyOf(step.link);
    const told = () =>
      page.evaluate(async () => {
        const values = [
          .../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('#lesson [data-value]')),
        ];
        return Object.fromEntries(values.map((element) => [element.dataset.value, element.innerText]));
      });
    assert.deepEqual(
      (({ child, childCost, parentCost, wins }) => ({ child, childCost, parentCost, wins }))(await told()),
      {
        child: 'Offspring 7',
        childCost: all[26].cost.toFixed(3),
        parentCost: all[6].cost.toFixed(3),
        wins: String(record.wins[26]),
      },
    );
    assert.match((await told()).fate, /^Offspring 7 survives as parent 3 /);

    await page.click('.formula-button');
    const line = await page.evaluate(() =>
      [...document.querySelectorAll('.formula-now mtr')].map((row) => row.textContent),
    );
    const { parents, offspring, mutations } = record;
    for (const i of [0, 1, 2]) {
      const printed =
        (line[i] ?? '')
          .replaceAll('−', '-')
          .match(/-?\d+\.\d+/g)
          ?.map(Number) ?? [];
      const exact = [offspring[6].gains[i], parents[6].gains[i], parents[6].sigmas[i], mutations[6].gains[i]];
      assert.equal(printed.length, 4, line[i] ?? '');
      for (const [j, value] of exact.entries()) assert.ok(Math.abs(printed[j] - value) < 6e-4, line[i] ?? '');
    }

    // What would give an answer away is not there before it.
    await page.click('#quiz-luck .choice:first-child');
    await page.until('the moves that follow', () => document.querySelector('#quiz-luck .right'));
    await page.click('#lesson .prose a[href*="phase=tournament"]');
    await page.until('the tournament', () => document.querySelector('#generation-phases-tournament:checked'));
    await page.focus('#generation-picture');
    await page.press(Key.ARROW_RIGHT);
    await page.until(
      'another one',
      () => document.querySelector('[data-value="chosen"]')?.textContent !== 'Offspring 7',
    );
    const now = await told();
    const number = all.findIndex(
      (_, i) => now.chosen === (i < 20 ? `Parent ${i + 1}` : `Offspring ${i - 19}`),
    );
    assert.equal(now.wins, String(record.wins[number]));
  },
);

pageTest('where the figure has no births, the text has its numbers all the same', async (page) => {
  await page.open('#lesson&step=7');
  const first = await numbersOn(page, 'the numbers of generation 1');
  assert.doesNotMatch(first, /–/);
  await page.click('#one-back');
  await page.until('generation 0', () => !location.hash.includes('generation=1'));
  assert.equal(await numbersOn(page, 'the same before any birth'), first);
  await page.open('#generation&v=1&generation=0&phase=parents&individual=26&lesson=7');
  assert.equal(await numbersOn(page, 'the same from a link'), first);
  await page.open('#generation&v=1&evolution.method=cma-es&generation=1&individual=26&lesson=7');
  assert.equal(await numbersOn(page, 'the same in another search'), first);
});
