// What the lesson says of starts that evolution did not see is so.
import assert from 'node:assert/strict';
import { cheapTurns } from '../../../www/lesson/steps/task.js';
import { gridAround, sharesBySide, tally } from '../../../www/parts/robustness/grid.js';
import { createSets } from '../../../www/parts/training/sets.js';
import { pageTest } from '../harness/browsers.js';
import {
  Evolution,
  evaluate,
  fares,
  paperGains,
  robustness,
  simulate,
  startsOnCircle,
} from '../harness/core.js';
import { yardOf } from '../../../www/lesson/duel/yard.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { task as en } from '../../../www/lesson/words/en/task.js';
import { task as ko } from '../../../www/lesson/words/ko/task.js';
import { driven, engine, opened } from './links.js';
import { answered, liveOf, numbersOn, toldBy, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('task');

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../harness/core.js').Gains} Gains */

const { experiment: own, generation } = opened(step.link);
const sets = createSets({ startsOnCircle })(own);

/** @param {Experiment} from @param {number} [generations] */
function champion(from, generations = generation) {
  const evolution = new Evolution(from);
  for (let i = 0; i < generations; i++) evolution.step();
  const { best } = evolution.statistics();
  evolution.free();
  return best;
}
const best = champion(own);

/** x_e, y_e and θ_e at the end of a run. @param {ReturnType<typeof simulate>} run @param {Experiment} from */
function left({ x, y, theta }, { goal } = own) {
  const last = x.length - 1;
  const [dx, dy, turn] = [goal.x - x[last], goal.y - y[last], goal.theta - theta[last]];
  const [cos, sin] = [Math.cos(goal.theta), Math.sin(goal.theta)];
  return [cos * dx + sin * dy, cos * dy - sin * dx, turn - 2 * Math.PI * Math.round(turn / (2 * Math.PI))];
}

test('the robot of the beginning is better than the paper’s, and nothing much is left to find', () => {
  assert.ok(driven(step.link).arrived);
  assert.ok(best.cost < driven('lab&drives=paper-ep').cost.total);
  assert.ok(best.cost - champion(own, 3 * generation).cost < 0.01);
});

test('all that fail end beside the goal', () => {
  const grid = gridAround(own.goal, 4, 9);
  let failed = 0;
  for (let column = 0; column < 9; column++)
    for (let row = 0; row < 9; row++)
      for (let heading = 0; heading < 18; heading++) {
        const start = {
          x: grid.x.from + column,
          y: grid.y.from + row,
          theta: (heading * 2 * Math.PI) / 18,
        };
        const run = simulate({ ...own, starts: [start] }, best.gains);
        if (run.arrived) continue;
        failed += 1;
        const [along, aside, turn] = left(run).map(Math.abs);
        assert.ok(along < 0.05 && turn < 0.1 && aside > 0.05, `${JSON.stringify(start)}: ${left(run)}`);
      }
  assert.ok(failed > 700);
});

test('from its own start ky has nothing to mend, and costs', () => {
  const [start] = own.starts;
  const { goal } = own;
  const aside = Math.cos(goal.theta) * (goal.y - start.y) - Math.sin(goal.theta) * (goal.x - start.x);
  assert.ok(Math.abs(aside) < 1e-12);
  const [kx, ky, ktheta] = best.gains;
  assert.ok(ky < 0.001);
  const costs = [0, 0.1, 1, 10].map((other) => evaluate(own, [kx, other, ktheta])[0]);
  assert.deepEqual(
    costs,
    [...costs].sort((a, b) => a - b),
  );
});

test('a start that fails arrives with ky', () => {
  const [failing, mended] = ['beside', 'withKy'].map((name) => tryOf('task', name));
  assert.deepEqual(opened(failing).trial, opened(mended).trial);
  assert.ok(!driven(failing).arrived && Math.abs(left(driven(failing))[1]) > 0.5);
  assert.ok(driven(mended).arrived);
  const gains = opened(mended).handGains ?? [];
  assert.ok([0, 2].every((i) => Math.abs(gains[i] - best.gains[i]) < 0.1));
});

test('the map has the axis of the goal', () => {
  const grid = gridAround(own.goal, 4, 25);
  const runs = robustness(own, { ...grid, gains: best.gains });
  const { behind, front, left: one, right } = sharesBySide(grid, own.goal, tally(runs).count);
  assert.ok(Math.min(behind, front) > 0.45 && Math.max(one, right) < 0.05);
});

test('a quarter or fewer, more with arbitrary gains; on many starts J from the one start rises', async () => {
  const share = await answered('task', 'share');
  assert.equal(share.outcome.right, 3);
  assert.equal(share.outcome.starts, 118_098);
  for (const why of share.why) assert.match(why, /118.098.*24\.7/s);
  const map = tally(robustness(own, { ...gridAround(own.goal, 4, 81), gains: best.gains }));
  assert.equal(share.outcome.share, map.share);
  // The map that the words open next to it is that of the same robot.
  for (const { texts } of [en, ko]) {
    const [, link] = /\]\((robustness[^)]*)\)/.exec(texts.beside) ?? [];
    assert.deepEqual(opened(link), { ...opened('robustness'), generation, lesson: 0 });
  }
  const arbitrary = await answered('task', 'arbitrary');
  assert.equal(arbitrary.outcome.right, 2);
  assert.ok(arbitrary.outcome.dear.cost.total > arbitrary.outcome.best.cost.total + 1);
  const price = await answered('task', 'price');
  assert.equal(price.outcome.right, 2);
  const { one, many } = price.outcome;
  assert.deepEqual([one.own, one.gains], [best.cost, best.gains]);
  assert.ok(many.gains[1] > 1000 * one.gains[1] && many.unseen.count > 2 * one.unseen.count);
  for (const why of [...arbitrary.why, ...price.why]) assert.doesNotMatch(why, /undefined|NaN/);
});

test('whatever the seed, many starts serve the unseen better, and the one start worse', () => {
  const fare = (/** @type {Gains} */ gains, /** @type {Experiment['starts']} */ starts) => {
    const { arrived, cost } = fares(
      { ...own, starts, evolution: { ...own.evolution, population: 1 } },
      gains,
    );
    const mean = (/** @type {Float64Array | Uint8Array} */ all) =>
      [...all].reduce((sum, value) => sum + value, 0) / all.length;
    return { share: mean(arrived), cost: mean(cost) };
  };
  const arbitrary = fare(paperGains('velocity-limits', 'arbitrary'), sets.unseen);
  const cheap = opened(tryOf('task', 'cheap')).experiment.evolution.seed;
  for (const seed of [1, 2, 3, 4, 5]) {
    const evolution = { ...own.evolution, seed };
    const [one, circle, grid] = /** @type {const} */ (['one', 'circle', 'grid']).map((name) => {
      const { gains } = champion({ ...own, starts: sets[name], evolution });
      const unseen = fare(gains, sets.unseen);
      assert.ok(fare(gains, sets[name]).share > unseen.share, `${name} ${seed} looks better where it grew`);
      return { ...unseen, own: fare(gains, sets.one).cost };
    });
    for (const many of [circle, grid]) {
      assert.ok(many.share > one.share && many.share < 0.75, `${seed}`);
      assert.ok(many.cost < one.cost && many.own > 1.4 * one.own, `${seed}`);
    }
    if (seed === cheap) assert.ok(grid.share < arbitrary.share && grid.cost < 0.75 * arbitrary.cost);
  }
});

test('with turning at a tenth of its price nearly all unseen starts park, whatever the seed', async () => {
  const { outcome, why } = await answered('task', 'turning');
  assert.equal(outcome.right, 2);
  assert.ok(outcome.before.unseen.count < 600 && outcome.after.unseen.count > 990);
  for (const text of why) assert.match(text, /999/);
  const cheap = opened(`lab&${cheapTurns}`).experiment;
  for (const seed of [2, 3, 4]) {
    const evolution = { ...cheap.evolution, seed };
    const { gains } = champion({ ...cheap, starts: sets.circle, evolution });
    const { arrived } = fares(
      { ...cheap, starts: sets.unseen, evolution: { ...evolution, population: 1 } },
      gains,
    );
    assert.ok([...arrived].reduce((a, b) => a + b, 0) > 990, `seed ${seed}`);
  }
});

test('gains of its own would park each robot that waits, for less; one set that parks all costs more in the mean', () => {
  const circle = { ...own, starts: sets.circle };
  const found = champion(circle);
  const { arrived, cost } = fares(circle, found.gains);
  const waiting = [...arrived].flatMap((arrives, i) => (arrives ? [] : [i]));
  assert.ok(waiting.length >= 5, `${waiting.length}`);
  for (const i of waiting) {
    const alone = [1, 2, 3, 4].map((seed) =>
      champion({ ...own, starts: [sets.circle[i]], evolution: { ...own.evolution, seed } }),
    );
    assert.ok(Math.min(...alone.map(({ cost: one }) => one)) < 0.8 * cost[i], `start ${i}`);
  }
  const all = champion({ ...opened(`lab&${cheapTurns}`).experiment, starts: sets.circle });
  assert.ok([...fares(circle, all.gains).arrived].every(Boolean));
  assert.ok(evaluate(circle, all.gains)[0] > 1.2 * found.cost);
});

pageTest('who fails is seen to fail once one has predicted', async (page) => {
  await page.open('#lesson&step=11');
  await page.click('#quiz-share .choice:first-child');
  const parked = yardOf(engine).drive(own, /** @type {any} */ ([...best.gains]))?.parked;
  assert.ok(Number(parked) < 10);
  await page.until(
    'its robots',
    (count) => document.getElementById('swarm-parked')?.textContent === count,
    String(parked),
  );
});

pageTest('what the answer says of many starts is what the training then finds', async (page) => {
  await page.open('#lesson&step=11');
  await page.click('#quiz-price .choice:first-child');
  const why = await page.until(
    'the answer',
    () => document.querySelector('#quiz-price .quiz-why strong')?.parentElement?.innerText,
  );
  // The prediction has set them going, and the answer waited for them.
  const finding = await page.evaluate(() =>
    document.getElementById('training-note')?.textContent
      ? (document.getElementById('training-finding')?.textContent ?? '')
      : '',
  );
  assert.ok(finding, 'the three evolutions are in sight');
  const [, before, after] = /From (\d+\.\d+) to (\d+\.\d+)/.exec(why) ?? [];
  const counts = /from (\d+) of the 1000 starts.*instead of (\d+)/s.exec(why) ?? [];
  const row = await page.evaluate(() => document.getElementById('training-table')?.innerText ?? '');
  for (const cost of [before, after]) assert.ok(row.includes(Number(cost).toFixed(2)), `${cost} in ${row}`);
  for (const count of counts.slice(1))
    assert.ok(finding.includes(`${Math.round(Number(count) / 10)}\u202f%`), `${count} in ${finding}`);
});

test('whatever is open, what is said of the first robot is of that one', async () => {
  const told = await toldBy(step, liveOf(step.link));
  assert.deepEqual(
    [told.generation, told.cost, told.ky],
    [String(generation), best.cost.toFixed(3), best.gains[1].toFixed(4)],
  );
  for (const link of [
    tryOf('task', 'cheap'),
    `training&generation=100&${cheapTurns}`,
    `${step.link}&goal.theta=90deg`,
    `${step.link}&law=kanayama`,
    `${step.link}&horizon=1`,
    'lab',
  ])
    assert.deepEqual(await toldBy(step, liveOf(link)), told, link);
});

pageTest('what is said of the first robot stays said of it after a reload too', async (page) => {
  const said = () => numbersOn(page, 'its numbers');
  await page.open('#lesson&step=task');
  const first = await said();
  assert.match(first, /generation 100/);
  await page.evaluate(() =>
    /** @type {HTMLElement} */ (document.querySelector('[data-try="cheap"]')).click(),
  );
  await page.until('another seed', () => location.hash.includes('seed=3'));
  await page.until('its robot', () => document.getElementById('training-evolve')?.checkVisibility());
  assert.equal(await said(), first);
  await page.open('#training&v=1&generation=100&weights.velocity=1,0.1&lesson=task');
  assert.equal(await said(), first);
});
