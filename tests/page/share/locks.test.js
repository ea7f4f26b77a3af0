// What an exercise locks cannot be done by a way round.
import assert from 'node:assert/strict';
import { linkOfStep, stepNamed } from '../../../www/lesson/path.js';
import { pageTest } from '../harness/browsers.js';
import { read, waysOf } from '../harness/reading.js';
import { follow } from '../whole/surround.js';

pageTest('a locked clock stands still, also for who moves over the curves', async (page) => {
  for (const view of ['time', 'stability'])
    for (const lock of ['lock', 'hide']) {
      await page.open(`#curves&v=1&view=${view}&${lock}=clock`);
      const clock = () =>
        page.evaluate(async () => {
          for (let frame = 0; frame < 2; frame += 1)
            await new Promise((resolve) => requestAnimationFrame(resolve));
          // The bar may be hidden: where the robot is, is said in words.
          return document.getElementById('plane-text')?.textContent;
        });
      const picture = view === 'time' ? '#curves-picture' : '#stability-picture';
      await page.until('the robot has arrived', () => {
        const [, now, end] =
          /([\d.]+) of ([\d.]+) s/.exec(document.getElementById('plane-text')?.textContent ?? '') ?? [];
        return now !== undefined && now === end;
      });
      const before = await clock();
      await page.drag(picture, [
        { x: 60, y: 60 },
        { x: 90, y: 60 },
      ]);
      assert.equal(await clock(), before, `${view}, ${lock}`);
    }
});

pageTest(
  'who may not open another part sees whole generations, not their phases in Generation',
  async (page) => {
    await page.open('#lab&v=1&lock=parts&task=Stay');
    await page.evaluate(() => {
      const pace = /** @type {HTMLSelectElement} */ (document.getElementById('pace'));
      pace.value = '0';
      pace.dispatchEvent(new Event('change'));
    });
    await page.click('#run');
    await page.until('evolution goes on', () => document.getElementById('generation')?.textContent !== '0');
    assert.deepEqual(
      await page.evaluate(() => [
        document.body.dataset.open,
        /** @type {HTMLSelectElement} */ (document.getElementById('pace')).value,
      ]),
      ['lab', '1'],
    );
  },
);

pageTest('start, goal and seed that are locked are locked in the settings too', async (page) => {
  await page.open('#lab&v=1&seed=7&lock=postures,seed&task=Stay');
  const before = await read(page);
  await page.click('#settings-button');
  await page.until('the settings are there', () => document.getElementById('setting-goal-x'));
  await page.evaluate(() => {
    for (const group of document.querySelectorAll('details')) group.open = true;
  });
  assert.deepEqual(
    await waysOf(
      page,
      '#setting-goal-x',
      '#setting-starts-0-x',
      '#setting-evolution-seed',
      '#settings-preset',
    ),
    Array(4).fill('locked'),
  );
  assert.deepEqual(await waysOf(page, '#setting-evolution-population'), ['free']);
  await page.evaluate(() => {
    const goal = /** @type {HTMLInputElement} */ (document.getElementById('setting-goal-x'));
    goal.value = '0.3';
    goal.dispatchEvent(new Event('change', { bubbles: true }));
  });
  assert.deepEqual(await read(page), before);
});

pageTest('the table of Training holds to what is locked', async (page) => {
  await page.open('#training&v=1&lock=gains,drives&task=Stay');
  const rows = ['paper-ep', 'paper-arbitrary'];
  const chosen = () => page.evaluate(() => document.querySelector('#training-table tr.chosen')?.id ?? 'none');
  const before = [await chosen(), (await read(page)).driver];
  for (const row of rows) await page.click(`#training-${row} .training-unseen`);
  assert.deepEqual([await chosen(), (await read(page)).driver], before);
  assert.deepEqual(
    await waysOf(page, ...rows.map((row) => `#training-${row} .training-name`)),
    rows.map(() => 'locked'),
  );
});

/** A step of the lesson with more keys. @param {string} name @param {string} more */
const stepWith = (name, more) => `${linkOfStep(stepNamed(name).number)}&${more}&task=Stay`;

pageTest('what drives from the lesson’s own views is locked with what it does', async (page) => {
  const entrants = ['ep', 'arbitrary', 'gentle', 'hand'];
  const names = entrants.map((name) => `.standing-name[data-entrant="${name}"]`);
  const driving = () =>
    page.evaluate(() =>
      [...document.querySelectorAll('.standing-name')].map((name) => name.getAttribute('aria-pressed')),
    );
  const [free, locked] = ['free', 'locked'];
  for (const [more, expected] of /** @type {const} */ ([
    ['lock=clock', [free, free, free, free]],
    ['lock=gains', [free, free, locked, locked]],
    ['hide=gains', [free, free, locked, locked]],
    ['lock=paper', [locked, locked, free, free]],
    ['lock=drives', [locked, locked, locked, locked]],
    ['hide=drives', [locked, locked, locked, locked]],
  ])) {
    await follow(page, stepWith('cost', more));
    await page.until('the drives stand there', () => document.querySelector('.standing-name'));
    assert.deepEqual(await waysOf(page, ...names), expected, more);
    // A press does what it looks like.
    const before = await driving();
    assert.equal(before[0], 'false', more);
    await page.click(names[0]);
    if (expected[0] === free)
      await page.until(
        'it drives',
        (name) => document.querySelector(`${name}[aria-pressed="true"]`),
        names[0],
      );
    else assert.deepEqual(await driving(), before, more);
    assert.deepEqual(await waysOf(page, ...names), expected, `${more}, once it is drawn anew`);
  }
  const again = '#near-goal button';
  for (const [more, expected] of [
    ['lock=seed', free],
    ['lock=clock', locked],
    ['hide=clock', 'hidden'],
  ]) {
    await follow(page, stepWith('disturbance', more));
    await page.until('the goal is there', () => document.querySelector('#near-goal svg'));
    assert.deepEqual(await waysOf(page, again), [expected], more);
  }
});

pageTest('what stays of a hidden group is locked', async (page) => {
  await page.open('#landscape&v=1&hide=gains&task=Stay');
  await page.until('the map is there', () => document.getElementById('landscape-map'));
  assert.deepEqual(await waysOf(page, '#gains', '#landscape-map'), ['hidden', 'locked']);
  // A picture cannot be disabled: who presses it is told why nothing happens.
  const alight = await page.evaluate(async () => {
    const reason = /** @type {HTMLElement} */ (document.getElementById('exercise-locks'));
    const map = /** @type {HTMLElement} */ (document.getElementById('landscape-map'));
    const counts = [reason.getAnimations().length];
    const press = (/** @type {string} */ key) =>
      map.dispatchEvent(new KeyboardEvent('keydown', { key, bubbles: true, cancelable: true }));
    press('ArrowUp');
    /** @type {Animation | undefined} */
    let light;
    // The second one lights it anew.
    for (let i = 0; i < 2; i += 1) {
      const before = light;
      press('Enter');
      for (; !light || light === before; [light] = reason.getAnimations())
        await new Promise((resolve) => requestAnimationFrame(resolve));
      // It does not go out before it is counted.
      light.pause();
    }
    return [...counts, reason.getAnimations().length];
  });
  assert.deepEqual(alight, [0, 1]);
});

pageTest(
  'a lock holds where a view frees its control as the locks change, and ends as the view has it',
  async (page) => {
    await page.open('#park&v=1&lock=run&task=Stay');
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['locked']);
    // Whose sliders are locked may press it at once.
    await follow(page, 'park&v=1&lock=gains,run&task=Stay');
    await page.until('the sliders are locked', () => document.querySelector('#park-gains[data-locked]'));
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['locked']);
    await follow(page, 'park&v=1&lock=gains&task=Stay');
    await page.until('it is free', () => !document.querySelector('#park-evolve[data-locked]'));
    assert.deepEqual(await waysOf(page, '#park-evolve'), ['free']);

    await page.open('#lab&v=1&lock=share&task=Stay');
    assert.deepEqual(await waysOf(page, '#keep-button'), ['locked']);
    await page.evaluate(() => {
      const button = /** @type {HTMLButtonElement} */ (document.getElementById('keep-button'));
      for (const isDisabled of [false, true, false]) button.disabled = isDisabled;
    });
    assert.deepEqual(await waysOf(page, '#keep-button'), ['locked']);
    await follow(page, 'lab&v=1&task=Stay');
    await page.until('it is free', () => !document.querySelector('#keep-button[data-locked]'));
    assert.deepEqual(await waysOf(page, '#keep-button'), ['free']);
  },
);

pageTest(
  'on a narrow screen the aim stays in sight, and the locks come into it when they refuse',
  async (page) => {
    await page.resize(600, 800);
    await page.open('#landscape&v=1&lock=gains&task=Park.&aim=J%3C9');
    await page.until('it is measured', () => document.querySelector('#aim .aim-value'));
    await page.until('the map is there', () => document.getElementById('landscape-map'));
    const inSight = (/** @type {string} */ id) =>
      page.evaluate((one) => {
        const box = /** @type {HTMLElement} */ (document.getElementById(one)).getBoundingClientRect();
        return box.height > 0 && box.top >= 0 && box.bottom <= innerHeight;
      }, id);
    await page.evaluate(() => document.getElementById('landscape-map')?.scrollIntoView({ block: 'center' }));
    assert.deepEqual(
      [await inSight('aim'), await inSight('hand-in'), await inSight('exercise-locks')],
      [true, true, false],
    );
    // A tap, of which the light lasts for two seconds, however late the frames are.
    const seen = await page.evaluate(async () => {
      const map = /** @type {HTMLElement} */ (document.getElementById('landscape-map'));
      const { x, y } = map.getBoundingClientRect();
      const locks = /** @type {HTMLElement} */ (document.getElementById('exercise-locks'));
      for (const type of ['pointerdown', 'pointerup', 'click'])
        map.dispatchEvent(
          new PointerEvent(type, {
            bubbles: true,
            clientX: x + 90,
            clientY: y + 90,
            pointerId: 1,
            button: 0,
          }),
        );
      while (locks.getAnimations().length === 0) await new Promise(requestAnimationFrame);
      return locks.getBoundingClientRect().top >= 0;
    });
    assert.equal(seen, true);
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('what is locked at the head has its lock in sight', async (page) => {
  await page.open('#lab&v=1&task=Few.&lock=settings,share');
  await page.until('they are locked', () => document.querySelectorAll('.tools [data-locked]').length > 1);
  const seen = await page.evaluate(() =>
    [...document.querySelectorAll('.tools [data-locked]')].map((button) => {
      const { visibility, height } = getComputedStyle(button, '::after');
      return [button.id, visibility, height];
    }),
  );
  for (const [id, visibility, height] of seen)
    assert.deepEqual([visibility, height], ['visible', '12px'], id);
});
