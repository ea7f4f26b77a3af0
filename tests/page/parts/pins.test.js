// Runs that are pinned, beside the one that drives.
import assert from 'node:assert/strict';
import { differenceOf } from '../../../www/run/pins.js';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, experiment, paperGains, shown, simulate } from '../harness/core.js';
import { test } from '../harness/once.js';
import { coloured, pixelsOf, textOf } from '../harness/reading.js';
import { comparison, ep, layoutOn, openCurves, show, toEnd, velocityLimits } from './curves-page.js';

pageTest('four runs can be pinned, a fifth is refused in words, and any can be let go', async (page) => {
  await openCurves(page);
  await page.click('#pin');
  assert.match(await textOf(page, '#pin-note'), /pinned as “paper’s EP”/);
  assert.equal(await textOf(page, '#pin'), 'Unpin this drive');
  await page.click('#pin');
  assert.equal(await textOf(page, '#pin'), 'Pin this drive');
  await page.click('#page-lab');
  await page.click('#drives-paper-ep');
  for (const gain of ['3', '4', '5', '6', '7']) {
    await page.focus('#gain-kx');
    await page.press(gain, Key.ENTER);
    await page.click('#pin');
  }
  assert.match(await textOf(page, '#pin-note'), /Four drives are pinned: unpin one first/);
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
});

pageTest('a pinned drive can be renamed, but not to nothing', async (page) => {
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
  // What is typed stays, whatever else comes meanwhile.
  await page.focus('#pin-name-1');
  await page.press('a', 'b');
  await page.evaluate(() => document.getElementById('drives-paper-arbitrary')?.click());
  await page.until('another robot drives', () => location.hash.includes('drives=paper-arbitrary'));
  assert.match(
    await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).value),
    /ab/,
  );
});

test('of a pin is told in what else than the gains it differs', () => {
  const { limits } = experiment('acceleration-limits');
  const goal = { ...velocityLimits.goal, x: 1 };
  const weights = { ...velocityLimits.weights, penalty: 1 };
  const starts = [{ x: 1, y: 0, theta: 0 }];
  const evolution = { ...velocityLimits.evolution, seed: 7 };
  for (const [change, difference] of /** @type {const} */ ([
    [{}, null],
    [{ evolution }, null],
    [{ starts: velocityLimits.starts.concat(starts) }, null],
    [{ starts }, 'start'],
    [{ limits }, 'limits'],
    [{ goal, evolution }, 'goal'],
    [{ weights }, 'weights'],
    [{ goal, limits }, 'settings'],
    [{ horizon: 5 }, 'settings'],
  ])) {
    const other = /** @type {typeof velocityLimits} */ ({ ...velocityLimits, ...change });
    assert.equal(differenceOf(velocityLimits, other), difference, JSON.stringify(change));
  }
});

pageTest('the legend says of a pin that it drove within other limits', async (page) => {
  await openCurves(page);
  await page.click('#pin');
  const legend = () => page.evaluate(() => document.querySelector('#legend .pin')?.textContent);
  assert.match(String(await legend()), /^paper’s EP, J 7\.935$/);
  await page.click('#preset-acceleration-limits');
  await page.until('it says so', () =>
    document.querySelector('#legend .pin')?.textContent?.endsWith('paper’s EP, J 7.935 (other limits)'),
  );
  assert.deepEqual(await page.problems(), []);
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

pageTest('a pinned drive is drawn in every picture, also from where it had another goal', async (page) => {
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
  assert.ok(found > 24, `${found} of ${points.length} points of the pinned drive`);

  await page.click('#page-landscape');
  const picture = () =>
    page.evaluate(async () => {
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

pageTest(
  'a penalty that a pin alone pays is compared, and starts that are others, as many as they are',
  async (page) => {
    const starts = (/** @type {number} */ x) => `0,0,0;${x},0,0`;
    await page.open(`#curves&v=1&drives=paper-ep&start=${starts(1)}&pin1=a~-1,2,3~start:${starts(2)}`);
    const { rows } = await comparison(page);
    assert.equal(rows.penalty.length, 2);
    assert.deepEqual(rows['Evolved on'], ['2 starts', '2 starts']);
  },
);
