import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve, experiment, shown, simulate } from '../harness/core.js';
import { arrival, read, readEvolution, seedOne } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');

/** Presses "1 generation" by the keyboard. @param {Page} page @param {number} times */
async function step(page, times) {
  await page.focus('#one-generation');
  await page.press(...Array(times).fill(Key.ENTER));
}

/** @param {Page} page @param {number} generation */
const reaches = (page, generation) =>
  page.until(
    `generation ${generation}`,
    (wanted) => Number(document.getElementById('generation')?.innerText) >= wanted,
    generation,
  );

/** Waits until the frames of half a second have passed, in which an evolution that runs makes four generations. @param {Page} page */
const framesOfHalfASecond = (page) =>
  page.evaluate(async () => {
    const frame = () => /** @type {Promise<number>} */ (new Promise((done) => requestAnimationFrame(done)));
    const first = await frame();
    while ((await frame()) < first + 500);
  });

/** So that evolution does not pause by itself, at generation 100, before the test comes to it. @param {Page} page */
const inNoHurry = (page) => page.setPace(0.2);

pageTest('Run goes on by itself until Pause, however long that is pressed', async (page) => {
  await inNoHurry(page);
  await page.click('#run');
  await reaches(page, 2);
  const run = await page.element('#run');
  await page.driver.actions().move({ origin: run }).press().perform();
  await reaches(page, Number((await read(page)).generation) + 2);
  await page.driver.actions().release().perform();
  const paused = await readEvolution(page);
  await framesOfHalfASecond(page);
  assert.deepEqual(await readEvolution(page), paused);
  await page.click('#run');
  await reaches(page, Number(paused.generation) + 1);
});

pageTest(
  'generation 20 of a seed is the same whether it ran or was stepped, here and in Node',
  async (page) => {
    const first = await readEvolution(page);
    assert.deepEqual(first, seedOne(0));

    await inNoHurry(page);
    await page.click('#run');
    await reaches(page, 5);
    await page.click('#run');
    const ran = Number((await read(page)).generation);
    const end = Math.max(20, ran);
    await step(page, end - ran);
    assert.deepEqual(await readEvolution(page), seedOne(end));

    await page.click('#reset');
    assert.deepEqual(await readEvolution(page), first);
    await step(page, end);
    assert.deepEqual(await readEvolution(page), seedOne(end));
  },
);

pageTest('New seed takes another seed at generation 0, and Reset keeps it', async (page) => {
  await step(page, 2);
  await page.click('#new-seed');
  const { generation, seed, cost, gains } = await readEvolution(page);
  assert.equal(generation, '0');
  assert.notEqual(seed, '1');
  const evolution = { ...velocityLimits.evolution, seed: Number(seed) };
  assert.deepEqual({ cost, gains }, evolve({ ...velocityLimits, evolution }).shown);
  await step(page, 1);
  await page.click('#reset');
  assert.deepEqual(await readEvolution(page), { generation, seed, cost, gains });
});

pageTest('the fitness curve grows, and its text tells best and median', async (page) => {
  /** What the curve looks like, and what it says. */
  const curve = () =>
    page.evaluate(() => {
      const picture = /** @type {HTMLCanvasElement} */ (document.querySelector('#curve canvas')).toDataURL();
      return { picture, text: document.getElementById('curve')?.getAttribute('aria-label') ?? '' };
    });
  const before = await curve();
  await step(page, 20);
  const after = await curve();
  assert.notEqual(after.picture, before.picture);
  const [first, newest] = [evolve(velocityLimits), evolve(velocityLimits, 20)];
  for (const number of [first.shown.cost, first.median, newest.shown.cost, newest.median])
    assert.ok(after.text.includes(number), `${number} is not in: ${after.text}`);
});

pageTest("the robot's clock never touches evolution, nor evolution a robot that stands", async (page) => {
  await step(page, 3);
  const evolved = await readEvolution(page);
  /** @param {string} what */
  const untouched = async (what) => assert.deepEqual(await readEvolution(page), evolved, what);

  await page.focus('#scrub');
  await page.press(Key.END);
  await untouched('at the end');
  await page.press(Key.HOME, Key.ARROW_RIGHT, Key.ARROW_RIGHT);
  await untouched('scrubbed');
  await page.click('#speed option[value="2"]');
  await untouched('faster');
  await page.click('#play');
  await arrival(page);
  await untouched('arrived');
  await page.click('#speed option[value="0.25"]');
  await page.setPace(0.1);
  await page.click('#play');
  await page.until('the robots drive', () => document.querySelector('#play.playing'));
  await page.click('#play');
  await page.until('the robots stand', () => !document.querySelector('#play.playing'));
  await untouched('held on the way');

  const { time } = await read(page);
  await step(page, 1);
  assert.deepEqual([(await read(page)).generation, (await read(page)).time], ['4', time]);
});

pageTest('other limits change J and begin evolution again, which goes on under them', async (page) => {
  const first = await readEvolution(page);
  await step(page, 2);
  await page.click('#preset-acceleration-limits');
  const limited = experiment('acceleration-limits');
  const begun = evolve(limited).shown;
  assert.notEqual(begun.cost, first.cost);
  assert.deepEqual(await readEvolution(page), { generation: '0', seed: '1', ...begun });

  await step(page, 3);
  const third = evolve(limited, 3);
  assert.deepEqual(await readEvolution(page), { generation: '3', seed: '1', ...third.shown });

  // The same gains drive otherwise without the limits.
  await page.click('#drives-hand');
  assert.equal((await read(page)).cost, third.shown.cost);
  await page.click('#preset-velocity-limits');
  assert.equal((await read(page)).cost, shown(simulate(velocityLimits, third.gains).cost.total));

  await page.click('#drives-evolved');
  assert.deepEqual(await readEvolution(page), first);
});

pageTest('Run stays where it was pressed, and the page as large as it was', async (page) => {
  for (const [width, height] of [
    [1024, 768],
    [1280, 720],
    [1366, 768],
    [1440, 900],
  ]) {
    await page.resize(width, height);
    await page.open('#lab');
    const place = () =>
      page.evaluate(async () => {
        await pageFrames.settled();
        const { scrollWidth, scrollHeight } = document.documentElement;
        return [document.getElementById('run')?.getBoundingClientRect().top, scrollWidth, scrollHeight];
      });
    const before = await place();
    await page.click('#run');
    await reaches(page, 1);
    assert.deepEqual(await place(), before, `${width} × ${height}`);
    await page.click('#run');
    assert.deepEqual(await place(), before, `${width} × ${height}, paused`);
    await page.click('#reset');
    assert.deepEqual(await place(), before, `${width} × ${height}, begun again`);
  }
});
