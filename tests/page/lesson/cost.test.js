import assert from 'node:assert/strict';
import { beatOf, gentle } from '../../../www/lesson/views/standings.js';
import { withKy } from '../../../www/lesson/steps/cost.js';
import { cost as words } from '../../../www/lesson/words/en/cost.js';
import { costText } from '../../../www/words/numbers.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { Key, pageTest } from '../harness/browsers.js';
import { experiment, paper, paperGains, simulate } from '../harness/core.js';
import { answerOf, driven, engine, linkOf, opened } from './links.js';
import { test } from '../harness/once.js';

const step = stepOf('cost');

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */

const usual = experiment('velocity-limits');
const entrants = {
  ep: paperGains('velocity-limits', 'ep'),
  arbitrary: paperGains('velocity-limits', 'arbitrary'),
  gentle,
};

/** @param {Experiment} from */
function cheapest(from) {
  const costs = Object.entries(entrants).map(([name, gains]) => ({
    name,
    cost: simulate(from, gains).cost.total,
  }));
  return costs.reduce((a, b) => (b.cost < a.cost ? b : a)).name;
}

/** @param {string} name */
const answer = (name) => {
  const { experiment: own, preset } = opened(linkOf(step, name));
  const state = /** @type {any} */ ({ experiment: own, preset });
  return answerOf(step, name, { engine, state, paper: paper() });
};

test('with our weights the EP gains win, with heavy ones the gentle, with light ones the arbitrary', async () => {
  assert.equal(cheapest(usual), 'ep');
  const { experiment: heavy } = opened(linkOf(step, 'heavier'));
  assert.deepEqual(heavy.weights.velocity, [5, 5]);
  assert.equal(cheapest(heavy), 'gentle');
  assert.match(words.quizzes.heavier.choices[(await answer('heavier')).right], /^The gentle/);
  assert.equal(cheapest(opened(linkOf(step, 'cheap')).experiment), 'arbitrary');
});

test('the arbitrary gains arrive first, the gentle ones last, and weights change no drive', () => {
  const times = Object.values(entrants).map((gains) => simulate(usual, gains).finalTime);
  assert.equal(Math.min(...times), times[1]);
  assert.equal(Math.max(...times), times[2]);
  const { experiment: heavy } = opened(linkOf(step, 'heavier'));
  for (const gains of Object.values(entrants))
    assert.deepEqual(simulate(heavy, gains).x, simulate(usual, gains).x);
});

test('the dots on the drives are a round number of seconds apart, and at most twelve after the start', () => {
  for (const finalTime of [0.03, 0.6, 1.9, 2, 3.59, 10, 25, 999]) {
    const beat = beatOf([/** @type {any} */ ({ finalTime }), null]);
    assert.match(beat.toExponential(), /^[125]e/);
    assert.ok(Math.floor(finalTime / beat) <= 12, `${finalTime}: ${beat}`);
    assert.ok(Math.floor(finalTime / beat) >= 4, `${finalTime}: ${beat}`);
  }
});

test('where moving is dear, staying at home costs less than arriving, until the end is dear too', async () => {
  const outcome = await answer('home');
  assert.match(words.quizzes.home.choices[outcome.right], /stays at home/);
  assert.ok(outcome.drives.arrived && !outcome.stays.arrived);
  const stays = driven(linkOf(step, 'final'));
  const drives = simulate(opened(linkOf(step, 'final')).experiment, gentle);
  assert.ok(stays.cost.total > drives.cost.total);
});

test('evolution with the heaviest weights finds a robot that does not arrive and hardly works', () => {
  const run = driven(linkOf(step, 'evolved'));
  assert.equal(run.arrived, false);
  assert.ok(run.cost.total < simulate(opened(linkOf(step, 'evolved')).experiment, [0, 0, 0]).cost.total);
  assert.ok(Math.hypot(run.x.at(-1) ?? 0, run.y.at(-1) ?? 0) < 1, 'it stays near its start');
});

test('a gain a little below zero costs 1000 times as much', () => {
  assert.ok(Math.abs(driven(linkOf(step, 'negative')).cost.penalty - 10) < 1e-9);
});

test('from the paper’s start each bit of ky costs', () => {
  const costs = withKy.map((gains) => simulate(usual, gains).cost.total);
  assert.ok(costs[0] < costs[1] && costs[1] < costs[2], String(costs));
});

test('whoever arrives pays almost nothing for the end', () => {
  for (const gains of Object.values(entrants)) {
    const { arrived, cost } = simulate(usual, gains);
    assert.ok(arrived && cost.finalError <= 0.05 ** 2 + 0.05 ** 2);
  }
  assert.deepEqual(usual.tolerance, { position: 0.05, heading: 0.05, speed: null, turnRate: null });
});

test('the program’s weights are those that the text names', () => {
  assert.deepEqual(usual.weights, { final: [1, 1, 1], velocity: [1, 1], penalty: 1000 });
});

/** The table of drives, as it is read. @param {Page} page */
const standings = (page) =>
  page.evaluate(async () => {
    const rows = [...document.querySelectorAll('#standings tr')];
    return {
      totals: rows.map((row) => row.querySelector('.standing-total')?.textContent),
      winner: rows.findIndex((row) => row.querySelector('.standing-mark:not([hidden])')),
      drives: rows.findIndex((row) => row.querySelector('[aria-pressed="true"]')),
    };
  });
/** @param {Experiment} from */
const totals = (from) =>
  [...Object.values(entrants), [3, 1, 5]].map((gains) => costText(simulate(from, gains).cost.total));

pageTest('drives that take long stand in the table once they are there', async (page) => {
  await page.open('#lab&v=1&lesson=6&horizon=200&tolerance.position=0&drives=hand&gains=3,1,5');
  const long = { ...usual, horizon: 200, tolerance: { ...usual.tolerance, position: 0 } };
  await page.until('all of them', () => document.querySelectorAll('#standings .standing-total').length === 4);
  assert.deepEqual((await standings(page)).totals, totals(long));
});

pageTest('what the dots and the pale lines mean stands over the four drives', async (page) => {
  await page.open('#lesson&step=6');
  for (const [width, height, hasGains] of /** @type {const} */ ([
    [1280, 800, true],
    [390, 844, false],
  ])) {
    await page.resize(width, height);
    const [isSaid, isGiven] = await page.until('the four drives', () => {
      const [caption, gains] = ['caption', '.standing-head .muted'].map((one) =>
        document.querySelector(`#standings ${one}`),
      );
      return caption?.textContent && [caption, gains].map((one) => one?.checkVisibility());
    });
    assert.deepEqual([isSaid, isGiven], [true, hasGains], `${width} × ${height}`);
    const cut = await page.evaluate(
      () =>
        [...document.querySelectorAll('.standing')].filter((one) => one.scrollHeight > one.clientHeight)
          .length,
    );
    assert.equal(cut, 0);
  }
});

pageTest('weights in the lesson change J and the winner, and are those of the settings', async (page) => {
  await page.open('#lesson&step=6');
  assert.deepEqual(await standings(page), { totals: totals(usual), winner: 0, drives: 3 });
  for (const name of ['velocity-0', 'velocity-1']) {
    await page.focus(`#lesson-weights-${name}`);
    await page.press('5', Key.ENTER);
  }
  const heavy = opened(linkOf(step, 'heavier')).experiment;
  assert.deepEqual(await standings(page), { totals: totals(heavy), winner: 2, drives: 3 });
  assert.equal(await page.evaluate(() => document.getElementById('cost-total')?.innerText), totals(heavy)[3]);
  await page.click('#settings-button');
  await page.until(
    'the settings show the same weight',
    () =>
      /** @type {HTMLInputElement} */ (document.getElementById('setting-weights-velocity-0')).value === '5',
  );
  await page.click('#settings-close');
  await page.focus('#lesson-weights-velocity-1');
  await page.press('x', Key.ENTER);
  await page.until('the weight is refused by name', () => {
    const error = document.getElementById('lesson-weights-velocity-1-error');
    return error?.checkVisibility() && /a number from/.test(error.innerText);
  });
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('a drive of the table can be driven, and one’s own gains stay in it', async (page) => {
  await page.open('#lesson&step=6');
  await page.click('#standings tr:nth-child(3) button');
  const gentleCost = costText(simulate(usual, gentle).cost.total);
  const shown = await standings(page);
  assert.deepEqual(shown, { totals: totals(usual), winner: 0, drives: 2 });
  assert.equal(await page.evaluate(() => document.getElementById('cost-total')?.innerText), gentleCost);
  await page.click('#standings tr:nth-child(1) button');
  assert.equal((await standings(page)).drives, 0);
  await page.click('#standings tr:nth-child(4) button');
  assert.equal((await standings(page)).drives, 3);
  assert.equal(
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('gain-ky')).value),
    '1.000',
  );
});

pageTest('the evolved robot that drives stands in the table, in the place of one’s own', async (page) => {
  await page.open('#lesson&step=6');
  await page.evaluate(() =>
    /** @type {HTMLElement} */ (document.querySelector('[data-try="evolved"]')).click(),
  );
  // The first of its generations are seen before the last.
  await page.until('generation 60', () => document.getElementById('generation')?.textContent === '60');
  const cost = await page.until('its J', () => {
    const row = document.querySelector('#standings tr:nth-child(4)');
    const total = row?.querySelector('.standing-total')?.textContent;
    return row?.classList.contains('wins') && total === document.getElementById('cost-total')?.innerText
      ? total
      : '';
  });
  assert.ok(Number(cost) < 61, cost);
  assert.equal(
    await page.evaluate(() => document.querySelector('#standings [aria-pressed="true"]')?.textContent),
    'Evolved best',
  );
  const whole = await page.evaluate(() =>
    [.../** @type {NodeListOf<HTMLElement>} */ (document.querySelectorAll('.standing-total'))].every(
      (total) => total.getClientRects().length === 1 && total.offsetHeight < 40,
    ),
  );
  assert.ok(whole, 'no number is broken into two lines');
});

pageTest('the formula’s numbers are the parts of J, and each lights up in the bar', async (page) => {
  await page.open('#lesson&step=6');
  await page.click('.formula-button');
  const { cost } = simulate(usual, [3, 1, 5]);
  const numbers = () =>
    page.evaluate(async () => {
      return [...document.querySelectorAll('.formula-now mn')].map((leaf) => leaf.textContent);
    });
  assert.deepEqual(
    await numbers(),
    [cost.total, cost.time, cost.finalError, cost.path, cost.energy, cost.penalty].map(costText),
  );
  const lit = await page.evaluate(() =>
    ['time', 'finalError', 'path', 'energy', 'penalty'].map((part) => {
      document
        .querySelector(`.formula [data-term="${part}"]`)
        ?.dispatchEvent(new PointerEvent('pointerover', { bubbles: true }));
      return [...document.querySelectorAll('#cost-bar .lit')].map((one) => one.className);
    }),
  );
  assert.deepEqual(
    lit,
    ['time', 'finalError', 'path', 'energy', 'penalty'].map((part) => [`cost-segment part-${part} lit`]),
  );
});
