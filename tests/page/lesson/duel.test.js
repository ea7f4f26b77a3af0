import assert from 'node:assert/strict';
import {
  generationsIn,
  isDuelOf,
  judge,
  lockedIn,
  lowestOf,
  nextSeed,
  roundOf,
  scoreOf,
  winners,
} from '../../../www/lesson/duel.js';
import { noTally } from '../../../www/lesson/state.js';
import { taskText } from '../../../www/lesson/tally.js';
import { duel as words } from '../../../www/lesson/words/en/duel.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, evaluate, experiment, seedRuns, shown } from '../harness/core.js';
import { opened } from './links.js';
import { answered, liveOf, tryOf } from './live.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */

const usual = experiment('velocity-limits');
const { engine } = liveOf('lab');

/** What was driven by hand, with these J. @param {readonly number[]} costs @param {Experiment} [from] */
const driven = (costs, from = usual) =>
  lockedIn({ ...noTally, experiment: taskText(from), drives: costs.length, costs }, from);

/** The best J of an evolution with a seed. @param {number} seed @param {number} generation */
function evolvedBest(seed, generation) {
  const evolution = new Evolution({ ...usual, evolution: { ...usual.evolution, seed } });
  for (let i = 0; i < generation; i++) evolution.step();
  return evolution.statistics().best.cost;
}

test('evolution gets the generations that fit into as many drives, at least the first robots', () => {
  for (const [drives, generation] of [
    [1, 0],
    [19, 0],
    [20, 0],
    [39, 0],
    [40, 1],
    [187, 8],
    [1000, 49],
  ])
    assert.equal(generationsIn(drives, 20), generation, `${drives} drives`);
});

test('the duel compares with the core’s evolution and random search of that seed', async () => {
  const duel = driven(Array.from({ length: 187 }, (_, i) => 20 - i / 20));
  const round = await roundOf(engine, duel, 3);
  const verdict = judge(duel, round);
  const [run] = seedRuns(usual, { seeds: [3, 4], generations: 49 });
  assert.deepEqual([verdict.generation, verdict.given, verdict.longest, verdict.seed], [8, 180, 1000, 3]);
  assert.equal(verdict.costs.evolution, evolvedBest(3, 8));
  assert.equal(verdict.costs.random, run.random[8]);
  assert.equal(verdict.later.evolution, evolvedBest(3, 49));
  assert.equal(verdict.costs.you, 20 - 186 / 20);
});

test('who has the lowest J wins, whether its robot arrived or not', async () => {
  const round = { seed: 1, evolution: [9, 8.5, 8, 7.9], random: [9, 8.4, 8.4, 8.4] };
  const winnerWith = (/** @type {number} */ best, /** @type {number} */ drives) =>
    judge(driven([...Array(drives - 1).fill(30), best]), round).winner;
  assert.equal(winnerWith(8.3, 40), 'you');
  assert.equal(winnerWith(8.45, 40), 'random');
  assert.equal(winnerWith(8.2, 60), 'evolution');
  assert.equal(winnerWith(9.5, 30), 'both');
  assert.equal(winnerWith(9.5, 3), 'both');
  assert.equal(judge(driven([30]), round).given, 20);
  assert.equal(judge(driven([8.2]), round).passed, 60);
  assert.equal(judge(driven([7]), round).passed, null);
  assert.equal(lowestOf([]), Number.POSITIVE_INFINITY);
  assert.deepEqual(scoreOf({ ...driven([8.3, 9]), rounds: [round, round] }), {
    you: 2,
    evolution: 0,
    random: 0,
    both: 0,
  });
  const { outcome, why } = await answered('duel', 'ahead');
  assert.deepEqual([winners[outcome.right], outcome.drives], ['both', 0]);
  for (const text of why) assert.doesNotMatch(text, /undefined|NaN|∞/);
});

test('a duel is about start, goal and limits, not about the seed, and the seeds follow each other', () => {
  const duel = driven([9]);
  assert.ok(isDuelOf(duel, { ...usual, evolution: { ...usual.evolution, seed: 9 } }));
  assert.ok(!isDuelOf(duel, opened(tryOf('duel', 'round')).experiment));
  assert.equal(nextSeed(duel), 1);
  assert.equal(nextSeed({ ...duel, rounds: [{ seed: 4, evolution: [], random: [] }] }), 5);
});

test('with a hundred drives luck decides, with a thousand evolution is ahead', () => {
  const runs = seedRuns(usual, { seeds: [1, 31], generations: 49 });
  const ahead = (/** @type {number} */ drives) =>
    runs.filter(({ best, random }) => random[drives / 20 - 1] < best[drives / 20 - 1]).length;
  assert.ok(ahead(100) > 9 && ahead(100) < 21, `${ahead(100)} of 30 with 100 drives`);
  assert.equal(ahead(1000), 0);
  for (const { best, random } of runs) assert.equal(best[0], random[0]);
});

test('looking away from the goal evolution is no better than drawing lots', () => {
  const { experiment: from } = opened(tryOf('duel', 'backwards'));
  const runs = seedRuns(from, { seeds: [1, 21], generations: 49 });
  const lots = runs.filter(({ best, random }) => random[49] < best[49]).length;
  assert.ok(lots >= 7 && lots <= 15, `${lots} of 20`);
});

test('evolution leaves the range of the first gains, where that is better', () => {
  const { experiment: from } = opened(tryOf('duel', 'round'));
  const [low, high] = from.evolution.initialRange;
  assert.deepEqual([low, high], [0.01, 10]);
  const runs = seedRuns(from, { seeds: [1, 6], generations: 49 });
  for (const { champion, best, random } of runs) {
    assert.ok(champion.gains.some((gain) => gain < low || gain > high));
    assert.ok(best[49] < random[49]);
  }
});

/** Drives by hand: so many steps of a slider, each drawn. @param {Page} page @param {string} gain @param {number} steps */
async function drive(page, gain, steps) {
  await page.focus(`#slider-${gain}`);
  for (let i = 0; i < steps; i++) {
    await page.press(Key.ARROW_RIGHT);
    await drawn(page);
  }
}

/** @param {Page} page */
const drawn = (page) =>
  page.evaluate(async () => {
    for (let i = 0; i < 2; i++) await new Promise((resolve) => requestAnimationFrame(resolve));
  });

/** The table, row by row, best first. @param {Page} page */
const table = (page) =>
  page.evaluate(() =>
    [
      .../** @type {NodeListOf<HTMLTableRowElement>} */ (document.querySelectorAll('#duel-table tbody tr')),
    ].map((row) => ({
      who: row.dataset.who,
      drives: Number(row.cells[1].textContent),
      cost: row.cells[2].textContent,
      wins: row.className === 'wins',
    })),
  );

/** @param {Page} page @param {string} id */
const textOf = (page, id) => page.evaluate((name) => document.getElementById(name)?.textContent ?? '', id);

pageTest('drive, lock in, predict; every number is the core’s', async (page) => {
  await page.open('#lesson&step=9');
  await page.until('the first drive', () => document.getElementById('duel-drives')?.textContent === '1');
  await drive(page, 'kx', 25);
  await drive(page, 'ktheta', 20);
  const driven = [
    ...Array.from({ length: 26 }, (_, i) => [1 + i / 100, 1, 1]),
    ...Array.from({ length: 20 }, (_, i) => [1.25, 1, 1 + (i + 1) / 100]),
  ];
  const costs = [...evaluate(usual, driven.flat())];
  const best = shown(Math.min(...costs));
  assert.deepEqual([await textOf(page, 'duel-drives'), await textOf(page, 'duel-best')], ['46', best]);
  assert.ok(!(await page.evaluate(() => document.getElementById('duel-table')?.checkVisibility())));

  await page.click('#duel-lock');
  await drive(page, 'ky', 2);
  assert.deepEqual([await textOf(page, 'duel-drives'), await textOf(page, 'duel-best')], ['46', best]);
  await page.click('#quiz-ahead .choice:first-child');
  await page.until('the table', () => document.getElementById('duel-table')?.checkVisibility());
  const [run, second] = seedRuns(usual, { seeds: [1, 3], generations: 49 });
  const rows = (/** @type {typeof run} */ { best: evolution, random }) =>
    [
      { who: 'you', drives: 46, cost: best },
      { who: 'evolution', drives: 40, cost: shown(evolution[1]) },
      { who: 'random', drives: 40, cost: shown(random[1]) },
    ].sort((a, b) => Number(a.cost) - Number(b.cost));
  const seen = async () => (await table(page)).map(({ who, drives, cost }) => ({ who, drives, cost }));
  assert.deepEqual(await seen(), rows(run));
  assert.deepEqual(
    (await table(page)).map(({ wins }) => wins),
    [true, false, false],
  );
  const right = await page.evaluate(() =>
    [...document.querySelectorAll('#quiz-ahead .choice')].findIndex((choice) =>
      choice.classList.contains('right'),
    ),
  );
  assert.equal(winners[right], rows(run)[0].who);

  await page.click('#duel-again');
  await page.until('the second seed', () =>
    document.querySelector('#duel-table caption')?.textContent?.startsWith('Seed 2.'),
  );
  assert.deepEqual(await seen(), rows(second));
  assert.match(await textOf(page, 'duel-score'), /^Of 2 seeds/);

  await page.click('#duel-further');
  const later = await page.until(
    'what comes later',
    () => document.getElementById('duel-later')?.textContent,
  );
  assert.ok(later.includes(shown(second.best[49])) && later.includes(shown(second.random[49])), later);

  await page.click('#duel-watch');
  await page.until('evolution’s best', () => document.getElementById('seed')?.textContent === '2');
  assert.equal(await textOf(page, 'cost-total'), shown(second.best[1]));
  assert.equal(await textOf(page, 'duel-drives'), '46');
});

pageTest('a duel outlasts other steps, and can be started over elsewhere', async (page) => {
  await page.open('#lesson&step=9');
  await page.click('#quiz-ahead .choice:first-child');
  await page.until('the table', () => document.getElementById('duel-table')?.checkVisibility());
  assert.equal(await textOf(page, 'duel-drives'), '1');
  assert.match(await textOf(page, 'duel-sentence'), /they had 20 drives each.*you had 1\./);
  const before = await table(page);
  await page.click('.step-on');
  await page.click('.step-back');
  await page.until('the table again', () => document.getElementById('duel-table')?.checkVisibility());
  assert.deepEqual(await table(page), before);

  await page.click('[data-try="backwards"]');
  await page.until(
    'the other start',
    (text) => document.getElementById('duel-status')?.textContent === text,
    words.duel.elsewhere,
  );
  assert.deepEqual(await table(page), before);
  await page.click('#duel-new');
  await drawn(page);
  assert.ok(!(await page.evaluate(() => document.getElementById('duel-table')?.checkVisibility())));
  assert.equal(await textOf(page, 'duel-drives'), '0');
  await drive(page, 'kx', 3);
  const { experiment: from } = opened(tryOf('duel', 'backwards'));
  const costs = evaluate(from, [3.01, 1, 5, 3.02, 1, 5, 3.03, 1, 5]);
  assert.deepEqual(
    [await textOf(page, 'duel-drives'), await textOf(page, 'duel-best')],
    ['3', shown(Math.min(...costs))],
  );
});
