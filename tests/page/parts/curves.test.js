import assert from 'node:assert/strict';
import { layoutOf } from '../../../www/parts/curves/layout.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { Evolution, experiment, paperGains, shown, simulate } from '../harness/core.js';
import { coloured, numberOf, pixelsOf, textOf } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');
const ep = simulate(velocityLimits, paperGains('velocity-limits', 'ep'));
const arbitrary = simulate(velocityLimits, paperGains('velocity-limits', 'arbitrary'));

/** Opens the curves with the paper's gains from evolution, at rest. @param {Page} page */
async function openCurves(page) {
  await page.open('#curves');
  await page.click('#drives-paper-ep');
  await toEnd(page);
}

/** @param {Page} page */
async function toEnd(page) {
  await page.focus('#scrub');
  await page.press(Key.END);
}

/** @param {Page} page @param {string} view */
const show = (page, view) => page.click(`#curves-view-${view}`);

/** The rows of a table, its head first. @param {Page} page @param {string} id */
const table = (page, id) =>
  page.evaluate(async (name) => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const element = /** @type {HTMLTableElement} */ (document.getElementById(name));
    return [...element.rows].map((row) =>
      [...row.cells].map((cell) => cell.innerText.replaceAll('\n', ' ').trim()),
    );
  }, id);

/** What the comparison says, by the names of its rows. @param {Page} page */
async function comparison(page) {
  await show(page, 'compare');
  const [head, ...rows] = await table(page, 'pins-table');
  const body = rows.map(([name, ...values]) => /** @type {[string, string[]]} */ ([name, values]));
  return { names: head.slice(1), rows: Object.fromEntries(body) };
}

/** @param {Page} page */
const readings = (page) =>
  page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    return ['x', 'y', 'theta', 'linear', 'angular', 'cost'].map((id) =>
      Number(document.getElementById(`reading-${id}`)?.innerText.replace('−', '-')),
    );
  });

/** What has to be read at a sample. @param {import('../../../pkg/ep_locomotion.js').Run} run @param {number} i */
const expectedReadings = (run, i) => [
  Number(run.x[i].toFixed(2)),
  Number(run.y[i].toFixed(2)),
  Number(((run.theta[i] * 180) / Math.PI).toFixed(1)),
  Number(run.linear[i].toFixed(2)),
  Number(run.angular[i].toFixed(2)) + 0,
  Number(
    (i === run.time.length - 1 ? run.cost.total : run.time[i] + run.pathCost[i] + run.energyCost[i]).toFixed(
      3,
    ),
  ),
];

/** Where the picture has its plots. @param {Page} page @param {import('../../../pkg/ep_locomotion.js').Run[]} others */
async function layoutOn(page, others, driving = ep) {
  const size = await page.evaluate(() => {
    const { clientWidth, clientHeight } = /** @type {HTMLElement} */ (
      document.getElementById('curves-picture')
    );
    return { width: clientWidth, height: clientHeight };
  });
  return layoutOf(size, driving, others, velocityLimits.limits);
}

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

engineTest('the cursor of the plots is the robots’ clock, both ways', async (page) => {
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

pageTest(
  'four runs can be pinned, a fifth is refused in words, and any can be let go',
  async (page) => {
    await openCurves(page);
    await page.click('#pin');
    assert.match(await textOf(page, '#pin-note'), /pinned as “paper’s EP”/);
    assert.equal(await textOf(page, '#pin'), 'Unpin this run');
    await page.click('#pin');
    assert.equal(await textOf(page, '#pin'), 'Pin this run');
    await page.click('#page-lab');
    await page.click('#drives-paper-ep');
    for (const gain of ['3', '4', '5', '6', '7']) {
      await page.focus('#gain-kx');
      await page.press(gain, Key.ENTER);
      await page.click('#pin');
    }
    assert.match(await textOf(page, '#pin-note'), /Four runs are pinned: unpin one first/);
    await page.click('#page-curves');
    const full = await comparison(page);
    assert.deepEqual(full.names, [
      'now: your gains',
      'your gains 3.0, 0.1, 5.2',
      'your gains 4.0, 0.1, 5.2',
      'your gains 5.0, 0.1, 5.2',
      'your gains 6.0, 0.1, 5.2',
    ]);
    const costs = [7, 3, 4, 5, 6].map((kx) => {
      const [, ky, ktheta] = paperGains('velocity-limits', 'ep');
      return shown(simulate(velocityLimits, [kx, ky, ktheta]).cost.total);
    });
    assert.deepEqual(full.rows.J, costs);
    await page.click('#unpin-2');
    await page.click('#pin');
    const { names } = await comparison(page);
    assert.deepEqual(
      names.slice(1).map((name) => name.split(' ')[2]),
      ['3.0,', '7.0,', '5.0,', '6.0,'],
    );
    const legend = await page.evaluate(() => document.getElementById('legend')?.innerText);
    assert.match(String(legend), /your gains 7\.0, 0\.1, 5\.2, J /);
    assert.deepEqual(await page.problems(), []);
    assert.deepEqual(await page.obstacles(), []);
  },
  { moves: true },
);

pageTest('a pinned run can be renamed, but not to nothing', async (page) => {
  await openCurves(page);
  await page.click('#pin');
  await show(page, 'compare');
  const rename = async (/** @type {string[]} */ ...keys) => {
    await page.focus('#pin-name-1');
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
    await page.press(...keys, Key.ENTER);
  };
  await rename('k', 'i', 'm');
  assert.equal((await comparison(page)).names[1], 'kim');
  await rename(Key.BACK_SPACE);
  assert.match(await textOf(page, '#pins-message'), /name/);
  assert.equal((await comparison(page)).names[1], 'kim');
});

pageTest('the comparison names the settings that differ, and only those', async (page) => {
  await openCurves(page);
  await page.click('#pin');
  const same = await comparison(page);
  assert.ok('All settings are the same.' in same.rows);
  assert.deepEqual(same.rows.kx, ['3.24', '3.24']);

  await page.click('#preset-acceleration-limits');
  await page.click('#drives-paper-arbitrary');
  const limited = experiment('acceleration-limits');
  const other = simulate(limited, paperGains('acceleration-limits', 'arbitrary'));
  const { rows } = await comparison(page);
  assert.deepEqual(rows.J, [shown(other.cost.total), shown(ep.cost.total)]);
  assert.deepEqual(
    rows.energy,
    [other, ep].map(({ cost }) => cost.energy.toFixed(2)),
  );
  assert.deepEqual(rows.goal, [other.arrived ? 'reached' : 'missed', 'reached']);
  assert.deepEqual(
    rows.end,
    [other, ep].map(({ finalTime }) => `${finalTime.toFixed(2)} s`),
  );
  assert.deepEqual(rows.Acceleration, ['5 m/s²', 'no limit']);
  assert.deepEqual(rows['Turn acceleration'], ['900°/s²', 'no limit']);
  assert.ok(!('Seed' in rows) && !('Goal x' in rows));

  await page.focus('#goal-position');
  await page.press(Key.ARROW_RIGHT);
  await page.click('#page-lab');
  await page.click('#new-seed');
  const seed = await textOf(page, '#seed');
  await page.click('#page-curves');
  const moved = await comparison(page);
  assert.deepEqual(moved.rows['Goal x'], ['2.1 m', '2 m']);
  assert.deepEqual(moved.rows.Seed, [seed, '1']);
  assert.deepEqual(moved.rows.J[1], shown(ep.cost.total));
  assert.ok(!('Goal y' in moved.rows));
});

pageTest('a pinned run is drawn in every picture, also from where it had another goal', async (page) => {
  await openCurves(page);
  const canvases = ['#plane-paths', '#plane-robots', '#curves-lines'];
  for (const canvas of canvases) assert.equal(await pixelsOf(page, canvas, '--pin-1'), 0, canvas);
  await page.click('#pin');
  await page.click('#drives-paper-arbitrary');
  await toEnd(page);
  for (const canvas of canvases) assert.ok((await pixelsOf(page, canvas, '--pin-1')) > 60, canvas);

  // Half of a dashed line is there, and it is there for the experiment in which the run was pinned.
  await page.focus('#goal-position');
  await page.press(...Array(6).fill(Key.ARROW_DOWN));
  const moved = { ...velocityLimits, goal: { ...velocityLimits.goal, y: 1.4 } };
  const gains = ['arbitrary', 'ep'].map((method) =>
    paperGains('velocity-limits', /** @type {'ep' | 'arbitrary'} */ (method)),
  );
  const driving = simulate(moved, gains[0]);
  // The evolved best of generation 0 is what the arbitrary gains are compared with.
  const evolved = simulate(moved, new Evolution(moved).statistics().best.gains);
  const layout = await layoutOn(page, [evolved, ep], driving);
  const [{ scale }] = layout.plots;
  const samples = Array.from({ length: 60 }, (_, i) => 3 * i);
  const points = samples.map((i) => ({ x: layout.time(ep.time[i]), y: scale(ep.y[i]), token: '--pin-1' }));
  const found = await coloured(page, '#curves-lines', points);
  assert.ok(found > 24, `${found} of ${points.length} points of the pinned run`);

  await page.click('#page-landscape');
  const picture = () =>
    page.evaluate(async () => {
      await new Promise((resolve) => requestAnimationFrame(resolve));
      return /** @type {HTMLCanvasElement} */ (document.getElementById('landscape-marks')).toDataURL();
    });
  await page.click('#drives-evolved');
  // The lowest point is that of the last map.
  await page.until('the fine landscape is drawn', async () => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return /^16.384 drives/.test(document.getElementById('landscape-note')?.textContent ?? '');
  });
  const before = await picture();
  await page.click('#pin');
  assert.notEqual(await picture(), before);
  await page.click('#pin');
  assert.equal(await picture(), before);
});

pageTest('σ over the generations is told with the numbers of the core', async (page) => {
  const evolution = new Evolution(velocityLimits);
  const first = evolution.statistics().meanSigmas;
  for (let i = 0; i < 6; i++) evolution.step();
  const newest = evolution.statistics().meanSigmas;
  await page.click('#curve-choice-sigmas');
  await page.focus('#one-generation');
  await page.press(...Array(6).fill(Key.ENTER));
  const label = await page.evaluate(async () => {
    await new Promise((resolve) => requestAnimationFrame(resolve));
    const visible =
      document.getElementById('sigmas')?.checkVisibility() &&
      !document.getElementById('curve')?.checkVisibility();
    return visible ? document.getElementById('sigmas')?.getAttribute('aria-label') : 'not in sight';
  });
  for (const token of ['--x', '--y', '--theta'])
    assert.ok((await pixelsOf(page, '#sigmas canvas', token)) > 40, token);
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
