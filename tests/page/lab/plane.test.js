import assert from 'node:assert/strict';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment, paperGains, simulate } from '../harness/core.js';
import { arrival, middleOf, read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../harness/reading.js').PostureText} PostureText */

const velocityLimits = experiment('velocity-limits');

/** The core's posture for one that is shown. @param {PostureText} shown */
const posture = ({ x, y, degrees }) => ({ x, y, theta: (degrees * Math.PI) / 180 });

/** That the generation, J and gains shown are those of generation 0 between the postures shown. @param {Page} page */
async function assertBegunAnew(page) {
  const { generation, cost, gains, start, goal } = await read(page);
  const { shown } = evolve({ ...velocityLimits, starts: [posture(start)], goal: posture(goal) });
  assert.deepEqual({ generation, cost, gains }, { generation: '0', ...shown });
}

/** Drags a handle by some pixels. @param {Page} page @param {'drag' | 'touchDrag'} by @param {string} id @param {number} dx @param {number} dy */
async function dragBy(page, by, id, dx, dy) {
  const { x, y } = await middleOf(page, id, id);
  await page[by](`#${id}`, [
    { x, y },
    { x: x + dx / 2, y: y + dy / 2 },
    { x: x + dx, y: y + dy },
  ]);
}

/** @param {Page} page @param {string} modifier @param {string} key */
const pressWith = (page, modifier, key) =>
  page.driver.actions().keyDown(modifier).keyDown(key).keyUp(key).keyUp(modifier).perform();

/** Pixels a metre, from where the paper's start and goal are drawn. @param {Page} page */
async function scaleOf(page) {
  const [start, goal] = [await middleOf(page, 'start-position'), await middleOf(page, 'goal-position')];
  return (goal.x - start.x) / (velocityLimits.goal.x - velocityLimits.starts[0].x);
}

/** @param {number} actual @param {number} wanted @param {number} tolerance */
const assertNear = (actual, wanted, tolerance) =>
  assert.ok(Math.abs(actual - wanted) <= tolerance, `${actual} is not within ${tolerance} of ${wanted}`);

engineTest(
  'the robots drive as soon as the page is open, until they arrive',
  async (page) => {
    // In a frame, so that nothing is missed between loading and looking.
    const clocks = await page.evaluate(async () => {
      const frame = document.createElement('iframe');
      frame.src = location.href;
      document.body.prepend(frame);
      /** @param {string} selector */
      const find = (selector) =>
        /** @type {HTMLElement | null} */ (frame.contentDocument?.querySelector(selector));
      /** @type {string[]} */
      const seen = [];
      while (seen.length === 0 || find('#play.playing')) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
        const text = find('#clock')?.textContent;
        if (text && text !== seen.at(-1)) seen.push(text);
      }
      return seen;
    });
    const times = clocks.map(Number.parseFloat);
    const { finalTime } = await read(page);
    assert.ok(finalTime > 0 && times[0] < finalTime / 2, `the clock begins with ${clocks[0]}`);
    assert.ok(times.length > 3 && times.every((time, i) => i === 0 || time > times[i - 1]), `${clocks}`);
    assert.equal(times.at(-1), finalTime);
  },
  { moves: true },
);

pageTest('Play lets the robots drive again, Pause holds them on the way', async (page) => {
  await page.focus('#scrub');
  await page.press(Key.END);
  await page.click('#speed option[value="0.5"]');
  // So slowly that a slow driver comes in time.
  await page.setPace(0.1);
  await page.click('#play');
  await page.until('the robots are on the way', () => {
    const { valueAsNumber, max } = /** @type {HTMLInputElement} */ (document.getElementById('scrub'));
    return valueAsNumber > 0.1 && valueAsNumber < Number(max);
  });
  await page.click('#play');
  await page.until('the robots stand', () => !document.querySelector('#play.playing'));
  const { time, finalTime } = await read(page);
  assert.ok(time > 0.1 && time < finalTime, `the clock stands at ${time} of ${finalTime}`);
  await page.click('#speed option[value="2"]');
  assert.equal((await read(page)).time, time);
  await page.setPace(1);
  await page.click('#play');
  await arrival(page);
});

engineTest('a robot stands where the clock says and has its trail behind it', async (page) => {
  const run = simulate(velocityLimits, paperGains('velocity-limits', 'ep'));
  await page.click('#drives-paper-ep');
  await page.focus('#scrub');
  await page.press(Key.HOME, Key.PAGE_UP, Key.PAGE_UP, Key.PAGE_UP, Key.PAGE_UP);
  const { time } = await read(page);
  assert.ok(time > 0 && time < run.finalTime, `the clock shows ${time}`);

  const [start, scale] = [await middleOf(page, 'start-position'), await scaleOf(page)];
  const samples = [...run.time].map((at, i) => ({
    at,
    x: start.x + scale * run.x[i],
    y: start.y - scale * run.y[i],
  }));
  const inked = await page.evaluate((points) => {
    const canvas = /** @type {HTMLCanvasElement} */ (document.getElementById('plane-robots'));
    const context = /** @type {CanvasRenderingContext2D} */ (canvas.getContext('2d'));
    const pixels = canvas.width / canvas.clientWidth;
    return points.map(
      ({ x, y }) => context.getImageData(Math.floor(x * pixels), Math.floor(y * pixels), 1, 1).data[3] > 128,
    );
  }, samples);

  const robot = samples[Math.round(time / velocityLimits.sampleTime)];
  /** @param {(sample: { at: number, x: number, y: number }) => boolean} among */
  const share = (among) => {
    const chosen = inked.filter((_, i) => among(samples[i]));
    return chosen.filter(Boolean).length / chosen.length;
  };
  const behind = share(({ at }) => at < time);
  const ahead = share(({ at, x, y }) => at > time && Math.hypot(x - robot.x, y - robot.y) > 30);
  assert.ok(behind > 0.95, `${behind} of the way behind the robot is inked`);
  assert.ok(ahead < 0.2, `${ahead} of the way ahead of the robot is inked`);
});

for (const [name, by] of /** @type {const} */ ([
  ['the mouse', 'drag'],
  ['a finger', 'touchDrag'],
]))
  engineTest(`${name} drags the goal to where it is let go, and evolution begins again`, async (page) => {
    const scale = await scaleOf(page);
    await page.click('#one-generation');
    await dragBy(page, by, 'goal-position', -90, 60);
    const { goal } = await read(page);
    assertNear(goal.x, 2 - 90 / scale, 0.02);
    assertNear(goal.y, 2 - 60 / scale, 0.02);
    assert.equal(goal.degrees, 45);
    await assertBegunAnew(page);

    const [position, knob] = [await middleOf(page, 'goal-position'), await middleOf(page, 'goal-heading')];
    await dragBy(page, by, 'goal-heading', position.x - 70 - knob.x, position.y - knob.y);
    const turned = (await read(page)).goal;
    assertNear(Math.abs(turned.degrees), 180, 1);
    assert.deepEqual([turned.x, turned.y], [goal.x, goal.y]);
    await assertBegunAnew(page);
  });

pageTest('the keyboard moves and turns start and goal, and they go back to the paper’s', async (page) => {
  const first = await read(page);
  await page.click('#one-generation');
  await page.focus('#goal-position');
  await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT, Key.ARROW_UP);
  await pressWith(page, Key.SHIFT, Key.ARROW_LEFT);
  assert.deepEqual((await read(page)).goal, { x: 2.2, y: 2.1, degrees: 50 });
  await pressWith(page, Key.SHIFT, Key.ARROW_RIGHT);
  await pressWith(page, Key.SHIFT, Key.ARROW_RIGHT);
  await page.press(Key.ARROW_LEFT, Key.ARROW_DOWN);
  assert.deepEqual((await read(page)).goal, { x: 2.1, y: 2, degrees: 40 });
  await page.focus('#goal-heading');
  await page.press(Key.ARROW_LEFT, Key.ARROW_LEFT, Key.ARROW_RIGHT);
  assert.equal((await read(page)).goal.degrees, 45);
  await page.focus('#start-position');
  await page.press(Key.ARROW_LEFT, Key.ARROW_DOWN);
  assert.deepEqual((await read(page)).start, { x: -0.1, y: -0.1, degrees: 0 });
  await assertBegunAnew(page);

  await page.click('#restore-postures');
  const { start, goal, cost, generation } = await read(page);
  assert.deepEqual(
    { start, goal, cost, generation },
    { start: first.start, goal: first.goal, cost: first.cost, generation: '0' },
  );
});

pageTest('start and goal stay within reach when they are dragged out of the plane', async (page) => {
  /** @param {string} id */
  const isInReach = (id) =>
    page.evaluate(async (name) => {
      const [plane, handle] = ['plane', name].map((one) => document.getElementById(one));
      if (!plane || !handle) throw new Error(`no ${name}`);
      const [around, box] = [plane, handle].map((element) => element.getBoundingClientRect());
      const [x, y] = [box.left + box.width / 2, box.top + box.height / 2];
      const isInside = x > around.left && x < around.right && y > around.top && y < around.bottom;
      return isInside && document.elementFromPoint(x, y) === handle;
    }, id);

  const { width, height } = await page.evaluate(() => ({ width: innerWidth, height: innerHeight }));
  for (const [end, x, y] of /** @type {const} */ ([
    ['goal', 2, 2],
    ['goal', width - 3, height - 3],
    ['start', 2, height - 3],
    ['start', width - 3, 2],
  ])) {
    const id = `${end}-position`;
    const what = `the ${end}, dragged to (${x}, ${y})`;
    const before = (await read(page))[end];
    const handle = await page.element(`#${id}`);
    await page.driver.actions().move({ origin: handle }).press().move({ x, y, duration: 30 }).perform();
    assert.ok(await isInReach(id), `${what}, while it is held`);
    await page.driver.actions().release().perform();
    assert.ok(await isInReach(id), what);
    assert.notDeepEqual((await read(page))[end], before);
    await assertBegunAnew(page);

    // It can be taken again from there.
    const away = (await read(page))[end];
    await dragBy(page, 'drag', id, x < 100 ? 40 : -40, y < 100 ? 40 : -40);
    assert.notDeepEqual((await read(page))[end], away);
  }
  await page.click('#restore-postures');
  await assertBegunAnew(page);

  await page.focus('#goal-position');
  await page.press(...Array(20).fill(Key.ARROW_UP));
  assert.equal((await read(page)).goal.y, 4);
  assert.ok(await isInReach('goal-position'), 'the goal, carried up by keys');
});

pageTest('what is dragged stays where a posture may be, where the plane shows more', async (page) => {
  await page.open('#lab&v=1&start=995,0,0&goal.x=960&goal.y=0');
  for (const id of ['start-position', 'goal-position']) {
    const handle = await page.element(`#${id}`);
    const x = (await page.evaluate(() => innerWidth)) - 3;
    await page.driver.actions().move({ origin: handle }).press().move({ x, y: 300, duration: 30 }).perform();
    await page.driver.actions().release().perform();
    assert.equal((await read(page))[id === 'start-position' ? 'start' : 'goal'].x, 1000, id);
  }
  assert.equal(await page.text('#message'), '');
  assert.deepEqual(await page.problems(), []);
});
