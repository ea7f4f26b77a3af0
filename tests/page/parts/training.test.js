import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, evaluate, experiment, fares, paperGains, startsOnCircle } from '../harness/core.js';
import { test } from '../harness/once.js';
import { read } from '../harness/reading.js';
import { handOf } from '../../../www/parts/training/request.js';
import { createSets, testOn } from '../../../www/parts/training/sets.js';
import { trainingSlice } from '../../../www/parts/training/state.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../harness/core.js').Gains} Gains */
/** @typedef {import('../../../pkg/ep_locomotion.js').Posture} Posture */

const velocityLimits = experiment('velocity-limits');
const generations = 50;
/** Fewer of them evolve in a fifth of the time, and differ more from seed to seed. */
const few = experiment({ evolution: { ...velocityLimits.evolution, population: 4 } });
const link = '#training&v=1&population=4';

/** The starts as the page describes them, made anew. @param {Experiment} from */
function setsOf({ starts, goal }) {
  const circle = (/** @type {number} */ radius, /** @type {number} */ count, /** @type {number} */ seed) =>
    startsOnCircle({ x: goal.x, y: goal.y, radius, count, seed });
  const places = [0, 1, 2, 3, 4, 5].map((index) => 3 * ((2 * index) / 5 - 1));
  const grid = places.flatMap((y, row) =>
    places.map((x, column) => {
      const heading = goal.theta + Math.PI / 4 + (((column + 2 * row) % 4) * Math.PI) / 2;
      return {
        x: goal.x + x,
        y: goal.y + y,
        theta: heading > Math.PI ? heading - 2 * Math.PI : heading,
      };
    }),
  );
  const within = (/** @type {number} */ inner) => Math.round((1000 * inner ** 2) / 18 ** 2);
  const unseen = Array.from({ length: 18 }, (_, i) =>
    circle((4 * (i + 0.5)) / 18, within(i + 1) - within(i), 1000 + i),
  ).flat();
  return { one: starts, circle: circle(2 * Math.SQRT2, 32, 1), grid, unseen };
}

/** The share that arrives in whole percents, and the mean J. @param {Experiment} from @param {Posture[]} starts @param {Gains} gains */
function faring(from, starts, gains) {
  const { arrived, cost } = fares({ ...from, starts }, gains);
  const mean = (/** @type {Float64Array | Uint8Array} */ values) =>
    Array.from(values).reduce((sum, value) => sum + value, 0) / starts.length;
  return { percent: `${(100 * mean(arrived)).toFixed(0)} %`, cost: mean(cost).toFixed(2) };
}

/** A row as it must be shown. @param {Experiment} from @param {Gains} gains @param {Posture[]} [trained] */
function rowOf(from, gains, trained) {
  const unseen = faring(from, setsOf(from).unseen, gains);
  return {
    gains: [...gains].map((gain) => gain.toFixed(2)),
    seen: trained ? faring(from, trained, gains).percent : '–',
    unseen: unseen.percent,
    cost: unseen.cost,
    own: evaluate(from, gains)[0].toFixed(2),
  };
}

/** @param {Experiment} from @param {Posture[]} starts */
function evolved(from, starts) {
  const evolution = new Evolution({ ...from, starts });
  for (let i = 0; i < generations; i++) evolution.step();
  return evolution.statistics().best.gains;
}

/** What a row shows, once it shows anything. @param {Page} page @param {string} name */
async function readRow(page, name) {
  await page.until(
    `the row ${name} has a result`,
    (id) => document.querySelector(`#${id} strong`)?.textContent !== '–',
    `training-${name}`,
  );
  return page.evaluate(async (id) => {
    const text = (/** @type {string} */ selector) =>
      /** @type {HTMLElement} */ (document.querySelector(`#${id} ${selector}`)).innerText
        .replaceAll('\u202f', ' ')
        .replaceAll('−', '-')
        .trim();
    return {
      gains: ['kx', 'ky', 'ktheta'].map((gain) => text(`.${gain}`)),
      seen: text('.training-seen'),
      unseen: text('strong'),
      cost: text('.training-cost'),
      own: text('.training-own'),
    };
  }, `training-${name}`);
}

test('gains are tested the same whatever method the lab evolves with', () => {
  const { unseen } = createSets({ startsOnCircle })(velocityLimits);
  const gains = paperGains('velocity-limits', 'ep');
  const usual = fares(testOn(velocityLimits, unseen), gains);
  for (const method of /** @type {const} */ (['de', 'cma-es'])) {
    const own = { ...velocityLimits, evolution: { ...velocityLimits.evolution, method } };
    assert.deepEqual(fares(testOn(own, unseen), gains), usual, method);
  }
});

test('gains from Training, even of an evolution of before, are not those by hand', () => {
  const byHand = /** @type {const} */ ([1, 2, 3]);
  const stateOf = (/** @type {string} */ found, /** @type {object | null} */ evolved) => {
    const slices = { [trainingSlice.name]: { ...trainingSlice.first, byHand, evolved } };
    return /** @type {any} */ ({ handGains: [4, 5, 6], found, slices });
  };
  assert.equal(handOf(stateOf('training', {})), byHand);
  assert.deepEqual(handOf(stateOf('hand', {})), [4, 5, 6]);
  // As a link brings them.
  assert.deepEqual(handOf(stateOf('training', null)), [4, 5, 6]);
});

/** @param {Page} page @param {string} id */
const text = async (page, id) => (await page.text(`#${id}`)).replaceAll('\u202f', ' ');

/** Presses the button and waits for what it brings. @param {Page} page */
async function evolveAll(page) {
  await page.evaluate((count) => {
    const select = /** @type {HTMLSelectElement} */ (document.getElementById('training-generations'));
    select.value = String(count);
    select.dispatchEvent(new Event('change'));
  }, generations);
  await page.click('#training-evolve');
  await page.until(
    'evolution ends',
    () => document.getElementById('training-evolve')?.innerText === 'Evolve again',
  );
}

pageTest("the paper's rows are there without pressing, those to evolve are empty", async (page) => {
  await page.open('#training');
  const known = /** @type {const} */ ([
    ['paper-ep', 'ep'],
    ['paper-arbitrary', 'arbitrary'],
  ]);
  for (const [name, method] of known)
    assert.deepEqual(
      await readRow(page, name),
      rowOf(velocityLimits, paperGains('velocity-limits', method)),
      name,
    );
  assert.equal(await page.text('#training-circle strong'), '–');
  assert.ok((await text(page, 'training-finding')).includes('arrive from 25 % of 1000 starts'));
});

pageTest('where the paper is hidden, the page says what to press', async (page) => {
  await page.open('#training&v=1&hide=paper');
  assert.equal(
    await text(page, 'training-finding'),
    'Evolve on one start and on many: which robot gets further?',
  );
});

pageTest(
  'the three evolved rows are what evolution and the core give, and stay after a cancel',
  async (page) => {
    await page.open(link);
    await evolveAll(page);
    const sets = setsOf(few);
    /** @type {Record<string, ReturnType<typeof rowOf>>} */
    const rows = {};
    for (const name of /** @type {const} */ (['one', 'circle', 'grid'])) {
      rows[name] = rowOf(few, evolved(few, sets[name]), sets[name]);
      assert.deepEqual(await readRow(page, name), rows[name], name);
    }
    const finding = await text(page, 'training-finding');
    for (const { unseen } of Object.values(rows))
      assert.ok(finding.includes(unseen), `${unseen}: ${finding}`);
    assert.deepEqual(await page.problems(), []);
    assert.deepEqual(await page.obstacles(), []);
    await page.evaluate(() => {
      const button = /** @type {HTMLElement} */ (document.getElementById('training-evolve'));
      button.click();
      button.click();
    });
    await page.until('the page says so', () => document.getElementById('training-status')?.innerText);
    assert.equal(await text(page, 'training-status'), 'Cancelled: these are the results from before.');
    for (const name of Object.keys(rows)) assert.deepEqual(await readRow(page, name), rows[name]);
  },
);

pageTest('fifteen seeds are a dot each, where the core says that their robots arrive', async (page) => {
  await page.open(link);
  await evolveAll(page);
  await page.click('#training-seeds');
  const dots = await page.until('there are dots', () => {
    const of = (/** @type {string} */ name) => {
      const [bar, ...all] = [
        ...document.querySelectorAll(`#training-${name} :is(.training-bar, .training-dot)`),
      ].map((element) => element.getBoundingClientRect());
      return all.map(({ x, y, width }) => ({
        x,
        y,
        width,
        share: (100 * (x + width / 2 - bar.x)) / bar.width,
      }));
    };
    const all = { one: of('one'), circle: of('circle'), grid: of('grid') };
    return all.grid.length > 0 && all;
  });
  const sets = setsOf(few);
  const { evolution } = few;
  const finding = await text(page, 'training-finding');
  for (const name of /** @type {const} */ (['one', 'circle', 'grid'])) {
    assert.equal(dots[name].length, 15);
    const shares = dots[name].map(({ x, y, width, share }, i) => {
      const experiment = { ...few, evolution: { ...evolution, seed: evolution.seed + i } };
      const gains = evolved(experiment, sets[name]);
      const unseen = Number.parseFloat(rowOf(few, gains, sets[name]).unseen);
      const where = `${name}, seed ${evolution.seed + i}`;
      // At most two dots aside, and on no other.
      assert.ok(share >= 0 && share <= 100, where);
      assert.ok(Math.abs(share - unseen) < 2.5 * (100 / 15) + 1, `${where}: ${share}, ${unseen}`);
      for (const other of dots[name].slice(0, i))
        assert.ok(width > 2.5 && Math.hypot(other.x - x, other.y - y) >= width, where);
      return unseen;
    });
    const [low, , , , , , , median, , , , , , , high] = shares.sort((one, other) => one - other);
    assert.ok(finding.includes(`${median} % (${low} to ${high} %)`), finding);
  }
  assert.deepEqual(await page.problems(), []);
});

pageTest('a row drives its gains, which counts, and a start of its picture is driven from', async (page) => {
  await page.open(`${link}&task=Few.&aim=J%3C9;drives%3C%3D9`);
  await evolveAll(page);
  const sets = setsOf(few);
  await page.click('#training-one .training-name');
  const one = await read(page);
  const gains = evolved(few, sets.one);
  assert.deepEqual(
    one.gains,
    [...gains].map((gain) => gain.toFixed(3)),
  );
  assert.equal(one.cost, evaluate(few, gains)[0].toFixed(3));
  assert.equal(one.driver, 'hand');
  assert.equal(await page.text('#legend .solid'), 'gains from Training');
  // After those of the grid, which drove when evolution had ended.
  assert.equal(await page.text('.aim-drives'), '2 of 9 drives');

  await page.click('#training-paper-ep .training-cost');
  assert.equal((await read(page)).driver, 'paper-ep');

  await page.click('#training-circle .training-unseen');
  await page.focus('#training-seen');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  const circle = await read(page);
  const [, second] = sets.circle;
  assert.deepEqual(circle.start, {
    x: Number(second.x.toFixed(2)),
    y: Number(second.y.toFixed(2)),
    degrees: Math.round((second.theta * 180) / Math.PI),
  });
  const alone = { ...few, starts: [second] };
  assert.equal(circle.cost, evaluate(alone, evolved(few, sets.circle))[0].toFixed(3));
});

pageTest(
  'with another goal the evolved rows are out of date, and again up to date after undoing',
  async (page) => {
    await page.open(link);
    await evolveAll(page);
    const before = await readRow(page, 'circle');
    await page.focus('#goal-position');
    await page.press(Key.ARROW_UP);
    await page.until('it is out of date', () =>
      document.querySelector('#training-circle')?.classList.contains('old'),
    );
    assert.equal(await text(page, 'training-status'), 'Evolved for another goal: evolve again.');
    assert.deepEqual(await readRow(page, 'circle'), before);
    const moved = { ...few, goal: { ...few.goal, y: 2.1 } };
    await page.until(
      "the paper's row is up to date",
      () => !document.querySelector('#training-paper-ep')?.classList.contains('old'),
    );
    assert.deepEqual(await readRow(page, 'paper-ep'), rowOf(moved, paperGains('velocity-limits', 'ep')));
    await page.click('#restore-postures');
    await page.until(
      'it is up to date',
      () => !document.querySelector('#training-circle')?.classList.contains('old'),
    );
    assert.equal(await text(page, 'training-status'), '');
  },
);
