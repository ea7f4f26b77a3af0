// Exercises: a link with a task, in which controls are locked or hidden.
import assert from 'node:assert/strict';
import { parts } from '../../../www/parts/parts.js';
import { sizes, wantedHeight } from '../../../www/embed/frame.js';
import { mostOfTask } from '../../../www/run/exercise.js';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve, experiment } from '../harness/core.js';
import { ask, heardFrom, inHost, within } from '../harness/host.js';
import { middleOf, read, waysOf } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Goes on by another address, without loading the page again. @param {Page} page @param {string} link */
const follow = (page, link) =>
  page.evaluate(async (hash) => {
    location.hash = hash;
    for (let frame = 0; frame < 2; frame += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
  }, link);

const task = 'Park <b>it</b> in 6 s & no ky.';

pageTest('an exercise is made by pressing, and holds against pointer, keys and drag', async (page) => {
  await page.open('#lab&v=1&seed=7&generation=2&drives=hand&gains=4,0.5,6');
  await page.click('#keep-button');
  await page.click('#keep-exercise');
  await page.press(...task);
  await page.focus('#maker-gains-free');
  await page.press(Key.ARROW_RIGHT);
  assert.deepEqual(await waysOf(page, '#slider-kx', '#gain-ky'), ['locked', 'locked']);
  for (const [group, way] of Object.entries({
    paper: 'hidden',
    postures: 'locked',
    run: 'locked',
    settings: 'locked',
    parts: 'hidden',
  }))
    await page.click(`#maker-${group}-${way}`);
  // It tells the paper's gains.
  assert.deepEqual(await waysOf(page, '#page-lesson', '#maker-lesson-locked', '#maker-lesson-hidden'), [
    'hidden',
    'disabled',
    'free',
  ]);
  const link = await page.until('the link has it all', () => {
    const { value } = /** @type {HTMLInputElement} */ (document.getElementById('maker-link'));
    return /lock=.*settings&hide=paper,parts&task=/.test(value) && value;
  });
  assert.match(link, /#lab&.*&lock=gains,postures,run,settings&hide=paper,parts&task=Park%20/);
  const frame = await page.evaluate(
    () => /** @type {HTMLInputElement} */ (document.getElementById('maker-frame')).value,
  );
  const source = new URL(/src="([^"]+)"/.exec(frame)?.[1].replaceAll('&amp;', '&') ?? '');
  assert.equal(source.search, '?embed');
  assert.equal(source.hash, new URL(link).hash);
  assert.deepEqual(await page.obstacles(), []);
  // What is in the making is in no address, and closing the panel ends it.
  await page.press(Key.ESCAPE);
  assert.deepEqual(await waysOf(page, '#slider-kx', '#run', '#page-luck', '#exercise'), [
    'free',
    'free',
    'free',
    'hidden',
  ]);

  await follow(page, new URL(link).hash);
  assert.equal(await page.text('#task'), task);
  assert.equal(await page.text('#task-label'), 'Task from this link');
  assert.match(await page.text('#exercise'), /Locked by this link: gains, start and goal, running evolution/);
  assert.deepEqual(await waysOf(page, '#slider-kx', '#gain-ktheta', '#goal-heading', '#run', '#timeline'), [
    ...Array(5).fill('locked'),
  ]);
  assert.deepEqual(await waysOf(page, '#until', '#settings-button', '#preset input', '#page-lesson'), [
    ...Array(3).fill('locked'),
    'hidden',
  ]);
  assert.deepEqual(
    await waysOf(page, '#drives-paper-ep', '#page-luck', '#settings'),
    Array(3).fill('hidden'),
  );
  assert.deepEqual(await waysOf(page, '#drives-evolved', '#play', '#keep-button'), Array(3).fill('free'));

  const before = await read(page);
  const slider = await page.evaluate(() => {
    const { width, height } = /** @type {Element} */ (
      document.getElementById('slider-kx')
    ).getBoundingClientRect();
    return { width, height };
  });
  const at = (/** @type {number} */ share) => ({ x: share * slider.width, y: slider.height / 2 });
  await page.drag('#slider-kx', [at(0.43), at(0.6), at(0.9)]);
  await page.touchDrag('#slider-kx', [at(0.43), at(0.6), at(0.9)]);
  for (const id of ['slider-ky', 'gain-kx', 'goal-position', 'timeline']) {
    await page.focus(`#${id}`);
    await page.press(Key.ARROW_RIGHT, Key.ARROW_UP, '9', Key.ENTER);
  }
  const goal = await middleOf(page, 'goal-position');
  await page.drag('#plane-robots', [goal, { x: goal.x - 80, y: goal.y + 60 }]);
  await page.click('#run');
  await page.evaluate(() => /** @type {HTMLElement} */ (document.activeElement).blur());
  await page.press('r', 'n', 'b', 's');
  await page.driver.actions().keyDown(Key.CONTROL).sendKeys('z').keyUp(Key.CONTROL).perform();
  // As a screen reader would, past all keys.
  await page.evaluate(() => {
    const kx = /** @type {HTMLInputElement} */ (document.getElementById('slider-kx'));
    kx.value = '9';
    kx.dispatchEvent(new Event('input', { bubbles: true }));
    kx.value = '4';
  });
  assert.deepEqual(await read(page), before);
  assert.deepEqual(
    await page.evaluate(() => [document.body.dataset.open, 'lesson' in document.body.dataset]),
    ['lab', false],
  );
  assert.deepEqual(await page.obstacles(), []);
  assert.deepEqual(await page.problems(), []);

  await page.click('#exercise-leave');
  await page.until('the whole page is open', () => document.getElementById('exercise')?.hidden);
  assert.deepEqual(
    await waysOf(page, '#slider-kx', '#run', '#drives-paper-ep', '#page-luck', '#page-lesson'),
    [...Array(5).fill('free')],
  );
  assert.deepEqual(await read(page), before);
  await page.press('n');
  assert.equal((await read(page)).generation, '3');
});

pageTest('an exercise stays through parts, steps and undo, and maps hold to it', async (page) => {
  await page.open('#landscape&v=1&goal.x=1.5&lock=gains&task=Stay');
  const opened = await read(page);
  const cost = () => page.text('#cost-total');
  const first = await cost();
  await page.until('the map is there', () => document.getElementById('landscape-map'));
  await page.drag('#landscape-map', [
    { x: 150, y: 100 },
    { x: 200, y: 120 },
  ]);
  await page.focus('#landscape-map');
  await page.press(Key.ARROW_UP, Key.ENTER);
  assert.deepEqual([await cost(), (await read(page)).driver], [first, 'evolved']);
  assert.deepEqual(await waysOf(page, '#landscape-map'), ['locked']);
  // Undo leads through what was done here, and no further.
  await page.focus('#goal-position');
  await page.press(Key.ARROW_LEFT);
  assert.notDeepEqual((await read(page)).goal, opened.goal);
  const control = (/** @type {string} */ key) =>
    page.driver.actions().keyDown(Key.CONTROL).sendKeys(key).keyUp(Key.CONTROL).perform();
  for (let i = 0; i < 3; i += 1) await control('z');
  assert.deepEqual((await read(page)).goal, opened.goal);

  await page.click('#page-lab');
  await page.until('the lab is open', () => document.body.dataset.open === 'lab');
  assert.deepEqual(await waysOf(page, '#slider-kx', '#run'), ['locked', 'free']);
  await page.click('#page-lesson');
  await page.until('the lesson is open', () => 'lesson' in document.body.dataset);
  await page.click('.step-on');
  await page.until('the next step', () =>
    /&lesson=2&lock=gains&task=Stay&given=velocity-limits/.test(location.hash),
  );
  assert.deepEqual(await waysOf(page, '#exercise-locks'), ['free']);

  await follow(page, 'lab&v=1&lock=parts,lesson,share,clock&hide=seed');
  for (const id of ['page-luck', 'page-lesson', 'keep-button']) {
    await page.focus(`#${id}`);
    await page.press(Key.ENTER);
    await page.click(`#${id}`);
  }
  assert.deepEqual(await page.evaluate(() => [document.body.dataset.open, location.hash.split('&')[0]]), [
    'lab',
    '#lab',
  ]);
  assert.deepEqual(await waysOf(page, '#new-seed', '#play', '#keep', '#task', '#pages a:last-child'), [
    'hidden',
    'locked',
    'hidden',
    'hidden',
    'locked',
  ]);
  await follow(page, `lab&v=1&lock=gains,doors&task=${'x'.repeat(mostOfTask + 1)}`);
  assert.match(await page.text('#message'), /lock was used in part.*“doors”.*task was left out.*at most 300/);
  // What can be read of it holds.
  assert.deepEqual(await waysOf(page, '#slider-kx', '#run'), ['locked', 'free']);
});

pageTest('in a frame the task is beside the figure, and its host may do what is locked', async (page) => {
  const link = 'lab&v=1&seed=7&lock=run,postures&hide=clock&task=Wait%20for%20the%20lecture.';
  const [small, medium] = sizes;
  const html = [medium, small]
    .map(
      ([width, height]) =>
        `<iframe src="${page.site.address}?embed#${link.replaceAll('&', '&amp;')}" width="${width}" height="${height}"></iframe>`,
    )
    .join('');
  /** @type {number[]} */
  const heights = [];
  await inHost(page, html, async () => {
    for (const frame of [0, 1])
      await within(page, frame, async () => {
        assert.deepEqual(await waysOf(page, '#run', '#goal-position', '#play'), [
          'locked',
          'locked',
          'hidden',
        ]);
        assert.deepEqual(
          await page.evaluate(() => {
            const boxOf = (/** @type {string} */ id) =>
              /** @type {Element} */ (document.getElementById(id)).getBoundingClientRect();
            const [task, plane, run] = ['task', 'plane', 'run'].map(boxOf);
            const { scrollWidth, scrollHeight } = document.documentElement;
            return {
              fits: scrollWidth <= innerWidth && scrollHeight <= innerHeight && run.bottom < innerHeight,
              inOrder: task.bottom <= plane.top && plane.bottom <= run.top,
              large: plane.height > 110,
            };
          }),
          { fits: true, inOrder: true, large: true },
        );
        assert.equal(await page.text('#task'), 'Wait for the lecture.');
        const room = await page.evaluate(() => (document.getElementById('exercise')?.offsetHeight ?? 0) + 6);
        heights.push(wantedHeight(parts, 'lab', 0, await page.evaluate(() => innerWidth)) + room);
        if (frame === 1) assert.deepEqual(await page.obstacles(), []);
        await page.click('#run');
        await page.press('n', 'r');
        await page.focus('#embed-full');
        const whole = String(
          await page.evaluate(() => document.getElementById('embed-full')?.getAttribute('href')),
        );
        assert.equal(new URL(whole).hash, '#lab&v=1&seed=7');
        assert.equal(await page.text('#embed-full'), 'Open the page without the task');
      });
    // It asks for room for its task, too.
    for (const frame of [0, 1])
      assert.equal(
        (await heardFrom(page, frame)).filter(({ type }) => type === 'height').at(-1).height,
        heights[frame],
      );
    assert.equal((await ask(page, 0, { type: 'read' })).generations, 0);
    assert.equal(
      (await ask(page, 0, { type: 'step', generations: 3 })).hash,
      evolve(experiment({ evolution: { seed: 7 } }), 3).hash,
    );
    const set = await ask(page, 0, { type: 'set', experiment: { goal: { x: 1, y: 1, theta: 0 } } });
    assert.deepEqual(
      [set.experiment.goal, set.link.includes('&lock=postures,run&')],
      [{ x: 1, y: 1, theta: 0 }, true],
    );
    await ask(page, 1, { type: 'set', link: 'lab&v=1&seed=7' });
    await within(page, 1, async () => {
      assert.deepEqual(await waysOf(page, '#run', '#exercise'), ['free', 'hidden']);
    });
  });
});
