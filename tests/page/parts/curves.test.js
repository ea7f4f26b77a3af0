import assert from 'node:assert/strict';
import { scaleLinear } from 'd3-scale';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { dashes } from '../../../www/kit/palette.js';
import { ticksUp } from '../../../www/parts/curves/axes.js';
import { layoutOf } from '../../../www/parts/curves/layout.js';
import { Evolution, experiment, simulate } from '../harness/core.js';
import { test } from '../harness/once.js';
import { follow } from '../whole/surround.js';
import { coloured, numberOf, pixelsOf, textOf } from '../harness/reading.js';
import {
  arbitrary,
  ep,
  expectedReadings,
  layoutOn,
  openCurves,
  readings,
  show,
  table,
  velocityLimits,
} from './curves-page.js';

test('what does not change has an axis whose numbers have room', () => {
  // Under this rule a robot that parks never turns.
  const still = simulate(experiment({ law: 'kanayama' }), [1, 1, 1]);
  const { plots } = layoutOf({ width: 600, height: 700 }, still, [], velocityLimits.limits);
  for (const { name, scale } of plots) {
    const [low, high] = scale.domain();
    const step = scale.ticks(3)[1] - scale.ticks(3)[0];
    assert.ok(low < high && step > 1e-3, `${name}: ${low} to ${high}`);
  }
});

test('an upright axis has two numbers, also where it is low', () => {
  // As far as the wheels turn, both ways.
  for (const height of [48, 64, 90, 200]) {
    const axes = {
      frame: { left: 0, right: 1, top: 0, bottom: height },
      y: scaleLinear([-7.2, 7.2], [height, 0]),
    };
    assert.ok(ticksUp(axes).length > 1, `${height} px`);
  }
});

test('where there is no room for all rows, those of the paper’s figure stand above its words', () => {
  const rows = (/** @type {number} */ height, /** @type {boolean} */ isFigure) =>
    layoutOf({ width: 600, height }, ep, [arbitrary], velocityLimits.limits, isFigure).plots.map(
      ({ name }) => name,
    );
  const all = ['position', 'theta', 'linear', 'angular', 'cost'];
  for (const isFigure of [true, false]) assert.deepEqual(rows(320, isFigure), all);
  // The last is not in the paper's.
  assert.deepEqual(rows(240, true), all.slice(0, 4));
  assert.deepEqual(rows(240, false), ['position', 'linear', 'cost']);
});

pageTest('the numbers of the run are those of the core', async (page) => {
  await openCurves(page);
  await show(page, 'numbers');
  const [, ...rows] = await table(page, 'numbers-table');
  const last = ep.time.length - 1;
  assert.equal(rows.length, 39);
  for (const [n, cells] of rows.entries()) {
    const sample = Math.min(last, 5 * n);
    const paid = expectedReadings(ep, sample)[5];
    assert.deepEqual(
      cells.map(numberOf),
      [
        ep.time[sample].toFixed(2),
        ep.x[sample].toFixed(3),
        ep.y[sample].toFixed(3),
        ((ep.theta[sample] * 180) / Math.PI).toFixed(1),
        ep.linear[sample].toFixed(2),
        ep.commandLinear[sample].toFixed(2),
        ep.angular[sample].toFixed(2),
        ep.commandAngular[sample].toFixed(2),
        paid,
      ].map((text) => Number(text) + 0),
      `row ${n}`,
    );
  }
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
});

engineTest('the lines are where the core has them', async (page) => {
  await openCurves(page);
  const layout = await layoutOn(page, [arbitrary]);
  const tokens = /** @type {Record<string, string[]>} */ ({
    position: ['--x', '--y'],
    theta: ['--theta'],
    linear: ['--energy'],
    angular: ['--omega'],
    cost: ['--ink'],
  });
  const samples = [30, 60, 90, 120, 150, 180];
  /** @type {Record<string, ((i: number) => number)[]>} */
  const values = {
    position: [(i) => ep.x[i], (i) => ep.y[i]],
    theta: [(i) => (ep.theta[i] * 180) / Math.PI],
    linear: [(i) => ep.linear[i]],
    angular: [(i) => ep.angular[i]],
    cost: [(i) => ep.time[i] + ep.pathCost[i] + ep.energyCost[i]],
  };
  for (const { name, scale } of layout.plots)
    for (const [curve, value] of values[name].entries()) {
      const points = samples.map((i) => ({
        x: layout.time((ep.time[i] + ep.time[i + 1]) / 2),
        y: scale(value(i)),
        token: tokens[name][curve],
      }));
      const found = await coloured(page, '#curves-lines', points);
      // Another line may cross one.
      assert.ok(found >= samples.length - 1, `${name} ${curve}: ${found} of ${samples.length}`);
      const wrong = points.map(({ x, y, token }) => ({ x, y: y + 12, token }));
      if (name === 'cost')
        assert.ok((await coloured(page, '#curves-lines', wrong)) <= 1, `${name} is elsewhere too`);
    }
  const label = await page.evaluate(() =>
    document.getElementById('curves-lines')?.getAttribute('aria-label'),
  );
  assert.match(
    String(label),
    /paper’s EP gains, J 7\.935, arrives after 1\.90 s\. Dotted: paper’s arbitrary gains, J 9\.016/,
  );
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('the cursor of the plots is the robots’ clock, both ways', async (page) => {
  await openCurves(page);
  assert.deepEqual(await readings(page), expectedReadings(ep, ep.time.length - 1));
  await page.focus('#scrub');
  await page.press(Key.HOME, ...Array(37).fill(Key.ARROW_RIGHT));
  assert.match(await textOf(page, '#clock'), /^0\.37 of 1\.90 s$/);
  assert.deepEqual(await readings(page), expectedReadings(ep, 37));

  const layout = await layoutOn(page, [arbitrary]);
  const at = (/** @type {number} */ time) => ({ x: layout.time(time), y: 200 });
  await page.drag('#curves-picture', [at(0.4), at(1.2)]);
  const [time] = (await textOf(page, '#clock')).split(' ').map(Number);
  assert.ok(Math.abs(time - 1.2) <= 0.011, `dragged to ${time} s`);
  assert.deepEqual(await readings(page), expectedReadings(ep, Math.round(time * 100)));
  await show(page, 'numbers');
  await table(page, 'numbers-table');
  const marked = numberOf(await textOf(page, '#numbers-table [aria-current] td:first-child'));
  assert.ok(marked <= time && time < marked + 0.05, `${marked} s is marked at ${time} s`);
});

pageTest('σ over the generations is told with the numbers of the core', async (page) => {
  const evolution = new Evolution(velocityLimits);
  const first = evolution.statistics().meanSigmas;
  for (let i = 0; i < 6; i++) evolution.step();
  const newest = evolution.statistics().meanSigmas;
  await page.click('#curve-choice-sigmas');
  await page.focus('#one-generation');
  await page.evaluate(() => {
    const { setLineDash } = CanvasRenderingContext2D.prototype;
    CanvasRenderingContext2D.prototype.setLineDash = function (dash) {
      const { dataset } = this.canvas;
      dataset.dashes = `${dataset.dashes ?? ''} ${this.strokeStyle}:${dash}`;
      setLineDash.call(this, dash);
    };
  });
  await page.press(...Array(6).fill(Key.ENTER));
  const label = await page.evaluate(async () => {
    const visible =
      document.getElementById('sigmas')?.checkVisibility() &&
      !document.getElementById('curve')?.checkVisibility();
    return visible ? document.getElementById('sigmas')?.getAttribute('aria-label') : 'not in sight';
  });
  for (const token of ['--x', '--y', '--theta'])
    assert.ok((await pixelsOf(page, '#sigmas canvas', token)) > 40, token);
  const drawn = await page.evaluate(() => {
    const style = getComputedStyle(document.documentElement);
    const all = /** @type {HTMLElement} */ (document.querySelector('#sigmas canvas')).dataset.dashes ?? '';
    return ['--x', '--y', '--theta'].map(
      (token) =>
        all
          .split(' ')
          .find((one) => one.startsWith(style.getPropertyValue(token)))
          ?.split(':')[1],
    );
  });
  assert.deepEqual(drawn, Object.values(dashes).map(String));
  const digits = (/** @type {number} */ value) => String(Number(value.toPrecision(3)));
  const told = ['kx', 'ky', 'kθ'].map(
    (name, i) => `${name} from ${digits(first[i])} to ${digits(newest[i])}`,
  );
  assert.equal(label, `Mean σ of each gain over 6 generations, on a logarithmic axis: ${told.join(', ')}.`);
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
  await page.click('#curve-choice-cost');
  assert.equal(await textOf(page, '#curve-title'), 'Fitness curve');
});

pageTest('which figure of the paper is drawn is said of its own experiments alone', async (page) => {
  await page.open('#curves');
  for (const [link, note] of /** @type {const} */ ([
    ['', /^Figure 5 /],
    ['&preset=acceleration-limits', /^Figure 7 /],
    ['&goal.x=1', /^not in sight$/],
  ])) {
    await follow(page, `curves&v=1${link}&drives=paper-ep`);
    assert.match(await textOf(page, '#curves-note'), note, link);
  }
});
