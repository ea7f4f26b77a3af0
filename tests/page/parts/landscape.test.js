import assert from 'node:assert/strict';
import { createAxis, createCostScale } from '../../../www/parts/landscape/scale.js';
import { shadeAt } from '../../../www/kit/shades.js';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { experiment, landscape, paperGains, shown, simulate } from '../harness/core.js';
import { middleOf, read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {{ gain: 'kx' | 'ky' | 'ktheta', from: number, to: number, log: boolean }} Axis */

/** Who arrives does so sooner, and whoever does not takes less time. */
const brief = experiment({ horizon: 4 });
const link = '#landscape&v=1&drives=paper-ep&horizon=4';
const [, paperKy, paperKtheta] = paperGains('velocity-limits', 'ep');
/** @type {Axis} */
const across = { gain: 'kx', from: 0, to: 12, log: false };
/** @type {Axis} */
const up = { gain: 'ktheta', from: 0, to: 12, log: false };
const count = 128;
// Where the frame of the map lies in its element.
const margin = { left: 44, right: 14, top: 10, bottom: 30 };

/** Opens the landscape around the paper's gains, whose ky is then that of every point. @param {Page} page */
async function openLandscape(page) {
  await page.open(link);
  await finished(page);
}

/** @param {Page} page @param {'x' | 'y'} axis @param {string} text */
const setAxis = (page, axis, text) =>
  page.evaluate(
    (axis, text) => {
      const select = /** @type {HTMLSelectElement} */ (document.getElementById(`landscape-${axis}`));
      select.selectedIndex = [...select.options].findIndex((option) => option.text === text);
      select.dispatchEvent(new Event('change'));
    },
    axis,
    text,
  );

/** Waits until the page has drawn what happened last, and the fine landscape of that is there. @param {Page} page */
const finished = (page) =>
  page.until('the fine landscape is drawn', async () => {
    await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    return document
      .getElementById('landscape-note')
      ?.textContent?.replace(/\s/g, '')
      .startsWith('16384drives');
  });

/** @param {Page} page */
const readout = (page) => page.text('#landscape-readout');

/** @param {Page} page @param {Axis} x @param {Axis} y */
async function axesOn(page, x, y) {
  const { width, height } = await page.evaluate(() => {
    const map = /** @type {HTMLElement} */ (document.getElementById('landscape-map'));
    return { width: map.clientWidth, height: map.clientHeight };
  });
  return {
    x: createAxis(x, [x.from, x.to], [margin.left, width - margin.right]),
    y: createAxis(y, [y.from, y.to], [height - margin.bottom, margin.top]),
  };
}

/**
 * That the colours of the picture are those of J as the core computes it.
 * @param {Page} page @param {Experiment} from @param {Axis} x @param {Axis} y @param {[number, number, number]} gains
 */
async function assertPicture(page, from, x, y, gains) {
  const costs = landscape(from, { x: { ...x, count }, y: { ...y, count }, gains, rows: [0, count] });
  const scale = createCostScale(costs);
  const axes = await axesOn(page, x, y);
  const cells = [16, 32, 48, 64, 80, 96, 112].flatMap((row) =>
    [16, 32, 48, 64, 80, 96, 112].map((column) => ({ row, column })),
  );
  const value = (/** @type {Axis} */ { from: low, to: high, log }, /** @type {number} */ i) =>
    log ? low * (high / low) ** (i / (count - 1)) : low + ((high - low) * i) / (count - 1);
  const points = cells.map(({ row, column }) => [axes.x.at(value(x, column)), axes.y.at(value(y, row))]);
  const colours = await page.evaluate((places) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('landscape-picture'));
    const context = canvas.getContext('2d');
    return places.map(([px, py]) => [
      ...(context?.getImageData(Math.round(px * devicePixelRatio), Math.round(py * devicePixelRatio), 1, 1)
        .data ?? []),
    ]);
  }, points);
  const matches = cells.filter(({ row, column }, i) => {
    const [, ...rgb] = /(\d+), (\d+), (\d+)/.exec(shadeAt(scale.part(costs[row * count + column]))) ?? [];
    return rgb.every((part, channel) => Math.abs(Number(part) - colours[i][channel]) <= 24);
  });
  // Contours cross some cells, and beside a cliff a pixel is a mixture.
  assert.ok(matches.length >= 0.75 * cells.length, `${matches.length} of ${cells.length} colours are right`);
}

/** Moves the mouse to a point of the map, without a button. @param {Page} page @param {readonly [number, number]} point */
async function hover(page, [px, py]) {
  const { left, top } = await page.evaluate(() => {
    const { left, top } = /** @type {HTMLElement} */ (
      document.getElementById('landscape-map')
    ).getBoundingClientRect();
    return { left, top };
  });
  await page.driver
    .actions()
    .move({ x: Math.round(left + px), y: Math.round(top + py) })
    .perform();
}

engineTest('the landscape has the colours of the costs that the core computes', async (page) => {
  await openLandscape(page);
  await assertPicture(page, brief, across, up, [0, paperKy, 0]);
  assert.match(await page.text('#landscape-method'), /Contours: equal J\./);
  assert.deepEqual(await page.problems(), []);
  assert.deepEqual(await page.obstacles(), []);
});

/** Where the map stands, and its edges without the numbers beside it. @param {Page} page */
const roomOf = (page) =>
  page.evaluate(() => {
    const [map, plane] = ['landscape-map', 'plane'].map((id) =>
      /** @type {HTMLElement} */ (document.getElementById(id)).getBoundingClientRect(),
    );
    return { map: [map.left, map.top, map.width, map.height], planeWidth: plane.width };
  });

pageTest('beside the plane the map has the most room, about a square, whoever drives', async (page) => {
  await page.open('#landscape&v=1&horizon=4');
  for (const [width, height, least] of /** @type {const} */ ([
    [1024, 768, 340],
    [1280, 720, 440],
    [1366, 768, 480],
    [1440, 900, 540],
    [1920, 1080, 760],
  ])) {
    await page.resize(width, height);
    await page.click('#drives-evolved');
    const { map, planeWidth } = await roomOf(page);
    const [wide, high] = [map[2] - margin.left - margin.right, map[3] - margin.top - margin.bottom];
    const said = `${wide} × ${high} at ${width} × ${height}, the plane ${planeWidth}`;
    assert.ok(Math.min(wide, high) >= least && map[2] > planeWidth, said);
    assert.ok(high / wide > 0.7 && high / wide < 1.3, said);
    await page.click('#drives-hand');
    assert.deepEqual((await roomOf(page)).map, map, 'by hand');
  }
});

pageTest('landscape and map of starts name the generation that is shown', async (page) => {
  for (const [part, id] of [
    ['landscape', 'landscape-readout'],
    ['robustness', 'robustness-summary'],
  ]) {
    await page.open(`#${part}&v=1&generation=2&drives=evolved`);
    for (const generation of [2, 1]) {
      await page.until(
        `generation ${generation} is named`,
        (element, name) => document.getElementById(element)?.textContent?.includes(name),
        id,
        `best of generation ${generation}`,
      );
      await page.evaluate(() => document.getElementById('one-back')?.click());
    }
  }
});

pageTest('after the goal was dragged the landscape is that of the new goal', async (page) => {
  await openLandscape(page);
  const { x, y } = await middleOf(page, 'goal-position', 'goal-position');
  await page.drag('#goal-position', [
    { x, y },
    { x: x - 30, y: y + 40 },
    { x: x - 60, y: y + 80 },
    { x: x - 90, y: y + 60 },
  ]);
  await finished(page);
  const { goal } = await read(page);
  assert.notEqual(goal.x, 2);
  const moved = { ...brief, goal: { x: goal.x, y: goal.y, theta: (goal.degrees * Math.PI) / 180 } };
  await assertPicture(page, moved, across, up, [0, paperKy, 0]);
});

pageTest('the cursor reads J, and a click drives those gains', async (page) => {
  await openLandscape(page);
  const axes = await axesOn(page, across, up);
  await hover(page, [axes.x.at(6), axes.y.at(2)]);
  const [, kx, ky, ktheta, cost, outcome] =
    /kx\s([\d.]+), ky\s([\d.]+), kθ\s([\d.]+): J ([\d.]+), (.*)/.exec(await readout(page)) ?? [];
  assert.ok(Math.abs(Number(kx) - 6) < 0.1 && Math.abs(Number(ktheta) - 2) < 0.1, `${kx}, ${ktheta}`);
  assert.equal(ky, '0.0968');
  const run = simulate(brief, [Number(kx), paperKy, Number(ktheta)]);
  assert.equal(cost, shown(run.cost.total));
  assert.match(outcome, run.arrived ? /^arrives/ : /^has not arrived/);
  // What is the browser's stays so: another button, and keys with Ctrl.
  const isLeft = await page.evaluate(() => {
    const map = /** @type {HTMLElement} */ (document.getElementById('landscape-map'));
    map.dispatchEvent(new PointerEvent('pointerdown', { button: 2 }));
    const key = { key: 'ArrowRight', ctrlKey: true, cancelable: true };
    return map.dispatchEvent(new KeyboardEvent('keydown', key));
  });
  assert.ok(isLeft);
  assert.equal((await read(page)).driver, 'paper-ep');

  await page.drag('#landscape-map', [{ x: axes.x.at(6), y: axes.y.at(2) }]);
  const driven = await read(page);
  assert.equal(driven.driver, 'hand');
  assert.equal(await page.text('#legend .solid'), 'gains from the landscape');
  assert.deepEqual(driven.gains.map(Number), [Number(kx), Number(paperKy.toFixed(3)), Number(ktheta)]);
  assert.equal(driven.cost, shown(run.cost.total));
  assert.equal(driven.generation, '0');
});

engineTest('the cursor moves by keys, and Enter drives', async (page) => {
  await openLandscape(page);
  const before = await readout(page);
  await page.focus('#landscape-map');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT, Key.ARROW_UP);
  const under = await readout(page);
  assert.notEqual(under, before);
  await page.press(Key.ENTER);
  const { driver, cost } = await read(page);
  assert.equal(driver, 'hand');
  assert.ok(under.includes(`J ${cost}`), `${under} has no J ${cost}`);
  await page.press(Key.TAB);
  assert.ok((await readout(page)).includes(`J ${cost}`));
});

pageTest('the axes can be changed, also to logarithms, and the third gain set', async (page) => {
  await openLandscape(page);
  await setAxis(page, 'y', 'ky, log');
  await finished(page);
  /** @type {Axis} */
  const logarithmic = { gain: 'ky', from: 0.01, to: 120, log: true };
  await assertPicture(page, brief, across, logarithmic, [0, 0, paperKtheta]);

  await page.focus('#landscape-third');
  await page.press('x', Key.ENTER);
  await page.until('the value is refused', () =>
    document.getElementById('landscape-third-error')?.innerText.startsWith('kθ must be a number'),
  );
  await page.press(Key.TAB);
  await page.focus('#landscape-third');
  await page.press('2', Key.ENTER);
  await finished(page);
  await assertPicture(page, brief, across, logarithmic, [0, 0, 2]);

  // It stays as long as it is the same gain.
  for (const [axis, text, axes] of /** @type {const} */ ([
    ['x', 'kx, log', 'x=kx-log&y=ky-log&third=2'],
    ['x', 'ky', 'x=ky&y=kx-log&third=2'],
    ['y', 'kx', 'x=ky&y=kx&third=2'],
    ['x', 'kθ', 'x=ktheta&y=kx'],
  ])) {
    await setAxis(page, axis, text);
    await page.until(
      `the link says ${axes}`,
      (wanted) =>
        location.hash.includes(wanted) && location.hash.includes('third') === wanted.includes('third'),
      axes,
    );
  }
});
