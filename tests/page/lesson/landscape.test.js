// What the lesson says of the landscape is so.
import assert from 'node:assert/strict';
import { landscapeSlice } from '../../../www/parts/landscape/state.js';
import { landscape as en } from '../../../www/lesson/words/en/landscape.js';
import { landscape as ko } from '../../../www/lesson/words/ko/landscape.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { specOf } from '../../../www/lesson/lowest.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { pageTest } from '../harness/browsers.js';
import { Evolution, evaluate, experiment, landscape, paperGains, simulate } from '../harness/core.js';
import { driven, engine, linkOf, opened, shownIn } from './links.js';
import { answered, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('landscape');

const { experiment: own } = opened(step.link);
const ky = shownIn(step.link, landscapeSlice).third ?? Number.NaN;
const count = 128;
/** @param {number} third */
const mapOf = (third, from = own) =>
  landscape(from, {
    x: { gain: 'kx', from: 0, to: 12, count },
    y: { gain: 'ktheta', from: 0, to: 12, count },
    gains: [0, third, 0],
  });
/** @param {number} cell @returns {[number, number]} */
const gainsOf = (cell) => [
  ((cell % count) * 12) / (count - 1),
  (Math.floor(cell / count) * 12) / (count - 1),
];
const map = mapOf(ky);
const least = Math.min(...map);

test('the valley holds very different gains that are almost equally good', () => {
  const floor = [...map.keys()].filter((cell) => map[cell] < 1.05 * least).map(gainsOf);
  for (const axis of [0, 1]) {
    const values = floor.map((gains) => gains[axis]);
    assert.ok(Math.max(...values) > 2 * Math.min(...values));
  }
});

test('at the edge J rises at once, because robots do not arrive', () => {
  const jumps = [];
  for (let row = 3; row < count; row += 8) {
    const runs = Array.from({ length: count }, (_, column) => {
      const [kx, ktheta] = gainsOf(row * count + column);
      return simulate(own, [kx, ky, ktheta]);
    });
    for (const [i, run] of runs.entries()) {
      if (!run.arrived) assert.ok(run.cost.time === own.horizon && run.cost.total > 1.5 * least);
      if (i > 0 && run.arrived !== runs[i - 1].arrived)
        jumps.push(Math.abs(run.cost.total - runs[i - 1].cost.total));
    }
  }
  assert.ok(jumps.length > 20);
  assert.ok(jumps.sort((a, b) => a - b)[Math.floor(jumps.length / 10)] > 3);
});

test('the ripples are single huge commands, and gone with ky = 0', () => {
  const smooth = shownIn(tryOf('landscape', 'smooth'), landscapeSlice).third;
  assert.equal(smooth, 0);
  const along = Array.from({ length: 60 }, (_, i) => 3.5 + i / 20);
  const [rough, even] = [ky, 0].map((third) => along.map((kx) => simulate(own, [kx, third, 6])));
  const wiggle = (/** @type {typeof rough} */ runs) =>
    runs.slice(1).reduce((sum, { cost }, i) => sum + Math.abs(cost.total - runs[i].cost.total), 0);
  assert.ok(wiggle(rough) > 5 * wiggle(even));
  const turn = (/** @type {(typeof rough)[0]} */ run) => Math.max(...run.commandAngular.map(Math.abs));
  const dearest = rough.reduce((a, b) => (b.cost.energy > a.cost.energy ? b : a));
  assert.ok(turn(dearest) > 5 * Math.max(...even.map(turn)));
});

test('turning the goal moves the lowest point, and its old gains no longer arrive', async () => {
  const { outcome, why } = await answered('landscape', 'turn');
  assert.equal(outcome.right, 2);
  const turned = experiment({ ...own, goal: { ...own.goal, theta: Math.PI / 2 } });
  // Nothing else changes: neither the rest of the run, nor the ky of the map.
  const [before, after] = [step.link, linkOf(step, 'turn')].map(opened);
  assert.deepEqual(after, { ...before, experiment: turned });
  for (const [found, from] of [
    [outcome.old, own],
    [outcome.now, turned],
  ])
    assert.ok(Math.abs(found.cost - Math.min(...mapOf(ky, from))) < 1e-12);
  assert.ok(!outcome.left.arrived && outcome.left.cost.total > 2 * outcome.now.cost);
  // What is told can be driven: the same robot on the same map.
  assert.equal(driven(outcome.again).cost.total, outcome.left.cost.total);
  assert.deepEqual(opened(outcome.again).experiment, turned);
  assert.equal(opened(outcome.again).handGains?.[1], ky);
  for (const text of why) assert.ok(text.includes(`](${outcome.again})`));
  // A gorge: far less of the map is near its lowest point.
  const floor = (/** @type {Float64Array} */ costs, /** @type {number} */ lowest) =>
    costs.filter((cost) => cost < 1.1 * lowest).length;
  assert.ok(floor(mapOf(ky, turned), outcome.now.cost) < floor(map, least) / 4);
  for (const text of why) assert.match(text, /17\.73/);
});

test('along ky the lowest point is at the border, behind which stands a wall', async () => {
  const { outcome } = await answered('landscape', 'ky');
  assert.equal(outcome.right, 1);
  assert.equal(outcome.lowest.gains[1], 0);
  assert.ok(outcome.wall.cost.total > outcome.middle.cost.total && outcome.wall.cost.penalty > 9);
});

test('most generations leave the best where it is; of the paper’s gains those of EP lie in the valley', () => {
  const { generation } = opened(tryOf('landscape', 'walked'));
  const evolution = new Evolution(own);
  let moves = 0;
  let best = evolution.statistics().best.cost;
  for (let i = 0; i < generation; i++) {
    const { cost } = evolution.step().best;
    if (cost < best) moves += 1;
    best = cost;
  }
  assert.ok(moves > 10 && moves < generation / 2, `${moves} moves`);
  // It finds what there is to find.
  assert.ok(best < 1.001 * evaluate(own, [3.2, 0, 4.35])[0]);
  // As they are, and where they stand on the map.
  for (const onMap of [false, true]) {
    const [ep, arbitrary] = /** @type {const} */ (['ep', 'arbitrary']).map((name) => {
      const [kx, third, ktheta] = paperGains('velocity-limits', name);
      return evaluate(own, [kx, onMap ? ky : third, ktheta])[0];
    });
    assert.ok(ep < 1.05 * least && arbitrary > 1.05 * least, `${ep}, ${arbitrary}`);
  }
  const said = [en, ko].map(({ notice }) => notice.at(-1) ?? '');
  for (const text of said) assert.match(text, /EP.*(arbitrary|임의)/);
});

test('in the gorge the population is stuck, though J falls on', () => {
  const { experiment: gorge, generation } = opened(tryOf('landscape', 'stuck'));
  const evolution = new Evolution(gorge);
  for (let i = 0; i < generation; i++) evolution.step();
  const { best, meanSigmas } = evolution.statistics();
  assert.ok(Math.max(...meanSigmas) < 0.01);
  const costs = mapOf(best.gains[1], gorge);
  const lowest = costs.indexOf(Math.min(...costs));
  assert.ok(costs[lowest] < best.cost - 1 && gainsOf(lowest)[0] < best.gains[0] - 3);
  // Half-way along the gorge it is in between.
  assert.ok(
    [...costs.keys()].some(
      (cell) =>
        Math.abs(gainsOf(cell)[0] - 6) < 0.1 && costs[cell] < best.cost && costs[cell] > costs[lowest],
    ),
  );
});

pageTest('the text has the numbers of the map, and follows the population', async (page) => {
  await page.open('#lesson&step=10');
  const value = (/** @type {string} */ name) =>
    page.evaluate((one) => document.querySelector(`#lesson [data-value="${one}"]`)?.textContent, name);
  await page.until(
    'the fine map is counted',
    () =>
      document.querySelector('#lesson [data-value="drives"]')?.textContent?.replace(/\D/g, '') === '16384',
  );
  const floor = map.filter((cost) => cost < 1.05 * least).length / map.length;
  assert.equal(await value('floor'), (100 * floor).toFixed(0));
  assert.deepEqual([await value('generation'), await value('spent')], ['0', '20']);
  await page.click('#one-generation');
  await page.until(
    'one generation more is told',
    () => document.querySelector('#lesson [data-value="spent"]')?.textContent === '40',
  );
  // Of the map with which the step opens it tells whatever map is in sight.
  const turned = '#landscape&v=1&x=kx&y=ky&generation=100&goal.theta=90deg&horizon=3&lesson=10';
  for (const link of ['#landscape&v=1&third=0.05&lesson=10', turned]) {
    await page.open(link);
    const told = await page.until('the share of the floor', () => {
      const values = ['drives', 'floor', 'horizon'].map(
        (name) => document.querySelector(`#lesson [data-value="${name}"]`)?.textContent,
      );
      return values[0]?.replace(/\D/g, '') === '16384' && !values.includes('…') && values.slice(1).join();
    });
    assert.equal(told, `${(100 * floor).toFixed(0)},10`, link);
  }
});

pageTest('on a telephone J of the robot that is pressed on the map is read in sight of it', async (page) => {
  await page.resize(390, 844);
  await page.open('#lesson&step=landscape');
  await page.until('the map is there', () => document.getElementById('landscape-lowest')?.textContent);
  for (const [width, height] of [
    [390, 844],
    [375, 667],
    [600, 900],
  ]) {
    await page.resize(width, height);
    await page.click('#landscape-map');
    await page.until('what is pressed is driven', () => location.hash.includes('drives=hand'));
    const [map, readout, pane] = await page.evaluate(() =>
      ['#landscape-map', '#landscape-readout', '.readings'].map((one) => {
        const { top, bottom } = /** @type {Element} */ (document.querySelector(one)).getBoundingClientRect();
        return { top, bottom };
      }),
    );
    const seen = JSON.stringify({ width, map, readout, pane });
    assert.ok(map.top >= pane.top && readout.top >= map.bottom && readout.bottom <= pane.bottom, seen);
  }
});

test('what is said of the map is as wide before it is there', () => {
  const state = firstState(engine, 'velocity-limits', atEnd);
  const told = (/** @type {object | null} */ result) => {
    const slices = { ...state.slices, landscape: { ...landscapeSlice.of(state), result } };
    const values = step.values?.(/** @type {any} */ ({ engine, state: { ...state, slices } })) ?? {};
    return ['drives', 'grid', 'side', 'floor'].map((name) => String(values[name]).length);
  };
  const { experiment, preset } = state;
  const spec = specOf({ experiment, preset, x: 'kx', y: 'ktheta', third: ky });
  const whole = told({ spec, count, costs: map });
  assert.deepEqual(whole, [6, 9, 3, 2]);
  assert.deepEqual(told(null), whole);
  assert.deepEqual(told({ spec, count: 64, costs: map.slice(0, 64 ** 2) }), whole);
});
