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
} from '../../../www/lesson/duel/duel.js';
import { marksOf } from '../../../www/lesson/duel/marks.js';
import { noTally } from '../../../www/lesson/state.js';
import { taskText } from '../../../www/lesson/duel/tally.js';
import { swarm } from '../../../www/lesson/words/en.js';
import { duel as words } from '../../../www/lesson/words/en/duel.js';
import { duel as korean } from '../../../www/lesson/words/ko/duel.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { Key, pageTest } from '../harness/browsers.js';
import { evaluate, seedRuns, shown } from '../harness/core.js';
import { contest, engine, evolvedBest, yard } from './duel-task.js';
import { opened } from './links.js';
import { answered, liveOf, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('duel');

/** @typedef {import('../harness/browsers.js').Page} Page */

/** What was driven by hand, with these J. @param {readonly number[]} costs */
const driven = (costs) =>
  lockedIn({ ...noTally, experiment: taskText(contest), drives: costs.length, costs }, contest);

test('evolution gets the generations that fit into as many trials, at least its twenty', () => {
  for (const [drives, generation] of [
    [0, 20],
    [40, 20],
    [420, 20],
    [440, 21],
    [1000, 49],
  ])
    assert.equal(generationsIn(drives, 20), generation, `${drives} trials`);
});

test('the duel compares with the core’s evolution and random search of that seed, from all starts', async () => {
  const duel = driven(Array.from({ length: 46 }, (_, i) => 20 - i / 20));
  const round = await roundOf(engine, duel, 3);
  const verdict = judge(duel, round);
  const [run] = seedRuns(contest, { seeds: [3, 4], generations: 60 });
  assert.deepEqual([verdict.generation, verdict.given, verdict.longest, verdict.seed], [20, 420, 1220, 3]);
  assert.equal(verdict.costs.evolution, evolvedBest(3, 20).cost);
  assert.deepEqual(round.champion, evolvedBest(3, 20).gains);
  assert.equal(verdict.costs.random, run.random[20]);
  assert.equal(evaluate(contest, round.drawn)[0], run.random[20]);
  assert.equal(verdict.later.evolution, evolvedBest(3, 60).cost);
  assert.equal(verdict.costs.you, 20 - 45 / 20);
  /** @type {typeof contest} */
  const elsewhere = { ...contest, evolution: { ...contest.evolution, method: 'nelder-mead' } };
  assert.deepEqual(
    await roundOf(engine, { ...duel, experiment: elsewhere }, 3),
    round,
    'whatever searches in the lab',
  );
});

test('the workers are asked once for a round that two wait for, and anew for what has failed', async () => {
  const asked = [];
  const seedRuns = (/** @type {any[]} */ ...job) => Promise.reject(new Error(`no. ${asked.push(job)}`));
  const broken = { ...engine, surveys: { ...engine.surveys, seedRuns } };
  const ask = () => roundOf(broken, driven([9]), 3).catch(({ message }) => message);
  assert.deepEqual(await Promise.all([ask(), ask()]), ['no. 1', 'no. 1']);
  assert.equal(await ask(), 'no. 2');
});

test('who has the lowest J wins', async () => {
  const evolution = Array.from({ length: 61 }, (_, i) => 13 - i / 60);
  const random = evolution.map((cost, i) => (i < 30 ? 12.8 : cost + 0.5));
  /** @type {import('../../../www/lesson/duel/duel.js').Round} */
  const round = { seed: 1, evolution, random, champion: [1, 1, 1], drawn: [2, 2, 2] };
  const winnerWith = (/** @type {number} */ best) => judge(driven([30, best]), round).winner;
  assert.equal(winnerWith(12.5), 'you');
  assert.equal(winnerWith(evolution[20]), 'you');
  assert.equal(winnerWith(12.7), 'evolution');
  assert.equal(judge(driven([30]), { ...round, random: evolution }).winner, 'both');
  assert.equal(judge(driven([30]), { ...round, random: evolution.map(() => 11) }).winner, 'random');
  assert.equal(judge(driven([30]), round).given, 420);
  assert.equal(judge(driven([13]), round).passed, 40);
  assert.equal(judge(driven([7]), round).passed, null);
  assert.equal(lowestOf([]), Number.POSITIVE_INFINITY);
  // The line under the table says when that is, however far both have gone on.
  const verdict = judge(driven([30]), round);
  for (const { duel, quizzes } of [words, korean]) {
    assert.match(duel.caption(verdict), /20.*420/);
    assert.doesNotMatch(quizzes.ahead.why(verdict), /undefined|NaN|∞/);
  }
  assert.deepEqual(scoreOf({ ...driven([12.5, 15]), rounds: [round, round] }), {
    you: 2,
    evolution: 0,
    random: 0,
    both: 0,
  });
  const { outcome } = await answered('duel', 'ahead');
  assert.equal(winners[outcome.right], 'evolution');
});

test('a duel is about start, goal and weights, not about the seed, and the seeds follow each other', () => {
  const duel = driven([9]);
  assert.ok(isDuelOf(duel, { ...contest, evolution: { ...contest.evolution, seed: 9 } }));
  assert.ok(!isDuelOf(duel, yard.experimentOf(opened(tryOf('duel', 'dear')).experiment)));
  assert.equal(nextSeed(duel), 1);
  assert.equal(
    nextSeed({
      ...duel,
      rounds: [{ seed: 4, evolution: [], random: [], champion: [1, 1, 1], drawn: [2, 2, 2] }],
    }),
    5,
  );
});

test('what one can beat is beaten by 5, 5, 5 last', () => {
  const marks = marksOf(liveOf(step.link));
  assert.deepEqual(
    marks.map(({ name }) => name),
    ['ep', 'arbitrary', 'fives'],
  );
});

/** Drives by hand: so many steps of a slider, each drawn. @param {Page} page @param {string} gain @param {number} steps */
async function drive(page, gain, steps) {
  await page.focus(`#slider-${gain}`);
  for (let i = 0; i < steps; i++) await page.press(Key.ARROW_RIGHT);
}

/** The table, row by row, best first. @param {Page} page */
const table = (page) =>
  page.evaluate(() =>
    [
      .../** @type {NodeListOf<HTMLTableRowElement>} */ (document.querySelectorAll('#duel-table tbody tr')),
    ].map((row) => ({
      who: row.dataset.who,
      drives: Number(row.cells[1].textContent),
      parked: row.cells[2].textContent,
      cost: row.cells[3].textContent,
      wins: row.className === 'wins',
    })),
  );

/** @param {Page} page @param {string} id */
const textOf = (page, id) => page.evaluate((name) => document.getElementById(name)?.textContent ?? '', id);

pageTest('drive, lock in, predict; every number is the core’s', async (page) => {
  await page.open('#lesson&step=9');
  await page.until('the robots', () => document.getElementById('swarm-parked')?.textContent === '4');
  assert.equal(await textOf(page, 'duel-drives'), '0', 'the page’s own drive is nobody’s');
  await drive(page, 'kx', 5);
  await drive(page, 'ktheta', 4);
  const gains = [
    ...Array.from({ length: 5 }, (_, i) => [1 + (i + 1) / 100, 1, 1]),
    ...Array.from({ length: 4 }, (_, i) => [1.05, 1, 1 + (i + 1) / 100]),
  ];
  const costs = [...evaluate(contest, gains.flat())];
  const best = shown(Math.min(...costs));
  assert.deepEqual([await textOf(page, 'duel-drives'), await textOf(page, 'duel-best')], ['9', best]);
  assert.ok(!(await page.evaluate(() => document.getElementById('duel-table')?.checkVisibility())));
  assert.match(
    await textOf(page, 'duel-beaten'),
    /Your lowest J is below that of the paper’s evolved gains \(20\.\d+\)\./,
  );

  await page.click('#duel-lock');
  await drive(page, 'ky', 2);
  assert.deepEqual([await textOf(page, 'duel-drives'), await textOf(page, 'duel-best')], ['9', best]);
  await page.click('#quiz-ahead .choice:first-child');
  await page.until('the table', () => document.getElementById('duel-table')?.checkVisibility());
  const [run, second] = seedRuns(contest, { seeds: [1, 3], generations: 60 });
  const rows = (/** @type {typeof run} */ { best: evolution, random }) =>
    [
      { who: 'you', drives: 9, cost: best },
      { who: 'evolution', drives: 420, cost: shown(evolution[20]) },
      { who: 'random', drives: 420, cost: shown(random[20]) },
    ].sort((a, b) => Number(a.cost) - Number(b.cost));
  const seen = async () => (await table(page)).map(({ who, drives, cost }) => ({ who, drives, cost }));
  assert.deepEqual(await seen(), rows(run));
  const hidden = await page.evaluate(
    () => [...document.querySelectorAll('#duel-table td')].filter((cell) => !cell.checkVisibility()).length,
  );
  assert.equal(hidden, 0, 'every number of the table is seen');
  const champion = yard.drive(contest, evolvedBest(1, 20).gains);
  assert.equal((await table(page))[0].parked, String(champion?.parked));
  const { drawn } = await roundOf(engine, driven(costs), 1);
  const random = (await table(page)).find(({ who }) => who === 'random');
  assert.equal(
    random?.parked,
    String(yard.drive(contest, drawn)?.parked),
    'also how many random search parks',
  );

  assert.match(await page.text('.duel-result'), /beyond the slider/);
  await page.until(
    'evolution’s robots drive by themselves',
    (parked) => document.getElementById('swarm-parked')?.textContent === parked,
    String(champion?.parked),
  );
  const named = () => page.evaluate(() => document.querySelector('.swarm-name')?.textContent);
  assert.equal(await named(), swarm.evolution(evolvedBest(1, 20).gains));
  await drive(page, 'ky', 1);
  assert.equal(await named(), swarm.own([1.05, 1.03, 1.04]), 'who drives on sees that');
  await page.click('#duel-watch');
  await page.until(
    'evolution’s robots again',
    (name) => document.querySelector('.swarm-name')?.textContent === name,
    swarm.evolution(evolvedBest(1, 20).gains),
  );
  await page.click('[data-try="sharp"]');
  await page.until(
    'the robots of the try',
    (name) => document.querySelector('.swarm-name')?.textContent === name,
    swarm.own([12, 12, 6]),
  );
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
  assert.ok(later.includes(shown(second.best[60])) && later.includes(shown(second.random[60])), later);
});

pageTest('a drag is one trial, however far it goes', async (page) => {
  await page.open('#lesson&step=9');
  await page.until('the robots', () => document.getElementById('swarm-parked'));
  // A slider that has the focus loses it where the drag begins.
  await drive(page, 'kx', 1);
  assert.equal(await textOf(page, 'duel-drives'), '1');
  await page.drag(
    '#slider-ky',
    Array.from({ length: 8 }, (_, i) => ({ x: 100 + 20 * i, y: 12 })),
    120,
  );
  const ky = Number(
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('slider-ky')).value),
  );
  assert.ok(ky > 1);
  assert.equal(await textOf(page, 'duel-drives'), '2');
  const best = Math.min(...evaluate(contest, [1.01, 1, 1, 1.01, ky, 1]));
  assert.equal(await textOf(page, 'duel-best'), shown(best));
});

pageTest('answers, trials and a locked duel outlast a reload of the tab', async (page) => {
  await page.open('#lesson&step=9');
  await page.until('the robots', () => document.getElementById('swarm-parked'));
  await drive(page, 'kx', 3);
  await page.click('#quiz-ahead .choice:nth-child(2)');
  await page.until('the table', () => document.getElementById('duel-table')?.checkVisibility());
  const before = await table(page);
  const why = await page.until(
    'the answer',
    () => document.querySelector('#quiz-ahead .quiz-why strong')?.parentElement?.innerText,
  );
  await page.driver.navigate().refresh();
  await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
  await page.until('the table again', () => document.getElementById('duel-table')?.checkVisibility());
  assert.deepEqual(await table(page), before);
  assert.equal(
    await page.evaluate(
      () => document.querySelector('#quiz-ahead .quiz-why strong')?.parentElement?.innerText,
    ),
    why,
  );
  await page.click('[data-try="dear"]');
  await page.until(
    'the other task',
    (text) => document.getElementById('duel-status')?.textContent === text,
    words.duel.elsewhere,
  );
  assert.equal(await textOf(page, 'duel-beaten'), '', 'J of one task compares with none of another');
  await page.click('#duel-new');
  assert.ok(!(await page.evaluate(() => document.getElementById('duel-table')?.checkVisibility())));
  assert.equal(await textOf(page, 'duel-drives'), '0');
});
