// Two hands, a palm beside the pen, a drag that a browser takes away: what is held goes on being held, and what ends has ended.
import assert from 'node:assert/strict';
import { Command, Name } from 'selenium-webdriver/lib/command.js';
import { pageTest } from '../harness/browsers.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** Where a finger goes, in shares of an element; or what it does there. @typedef {{ on: string, x: number, y: number } | 'down' | 'up' | 'wait'} Act */

/** Fingers that act together, act by act. @param {Page} page @param {readonly (readonly Act[])[]} fingers */
async function together(page, fingers) {
  const sequences = [];
  for (const [i, acts] of fingers.entries()) {
    const actions = [];
    for (const act of acts)
      if (typeof act === 'string')
        actions.push(
          {
            down: { type: 'pointerDown', button: 0 },
            up: { type: 'pointerUp', button: 0 },
            wait: { type: 'pause', duration: 30 },
          }[act],
        );
      else {
        const { left, top } = await page.evaluate(({ on, x, y }) => {
          const box = /** @type {Element} */ (document.querySelector(on)).getBoundingClientRect();
          return { left: box.left + x * box.width, top: box.top + y * box.height };
        }, act);
        actions.push({
          type: 'pointerMove',
          duration: 30,
          origin: 'viewport',
          x: Math.round(left),
          y: Math.round(top),
        });
      }
    sequences.push({ type: 'pointer', id: `finger ${i}`, parameters: { pointerType: 'touch' }, actions });
  }
  await page.driver.execute(new Command(Name.ACTIONS).setParameter('actions', sequences));
}

/** @param {Page} page @param {string} selector */
const shownBy = (page, selector) =>
  page.evaluate((wanted) => /** @type {HTMLInputElement} */ (document.querySelector(wanted)).value, selector);

pageTest('a setting that a finger takes there and back holds nothing up', async (page) => {
  if (page.engine !== 'chromium') return;
  await page.open('#lab');
  await page.click('#settings-button');
  const on = '#setting-weights-final-0-slider';
  await page.until('its slider', (slider) => document.querySelector(slider)?.checkVisibility(), on);
  const at = (/** @type {number} */ x) => ({ on, x, y: 0.5 });
  await together(page, [[at(0.3), 'down', at(0.4), at(0.5), 'up']]);
  const before = await shownBy(page, on);
  await together(page, [[at(0.5), 'down', at(0.7), at(0.5), 'up']]);
  assert.equal(await shownBy(page, on), before);
  await page.click('#run');
  await page.until('it evolves', () => Number(document.getElementById('generation')?.innerText) > 0);
});

pageTest('who holds the map holds it, whatever else comes down there', async (page) => {
  if (page.engine !== 'chromium') return;
  const on = '#landscape-map';
  const at = (/** @type {number} */ x, /** @type {number} */ y) => ({ on, x, y });
  const drag = /** @type {const} */ ([at(0.3, 0.3), 'down', at(0.5, 0.3), 'wait', 'wait', 'wait']);
  const palm = /** @type {const} */ (['wait', 'wait', 'wait', at(0.8, 0.7), 'down', 'up']);
  const gains = () =>
    page.evaluate(async () => {
      await pageFrames.settled();
      return [...document.querySelectorAll('#gains [type="text"]')].map((one) =>
        one instanceof HTMLInputElement ? one.value : '',
      );
    });
  const driven = [];
  for (const others of [[], [palm]]) {
    await page.open('#landscape');
    await page.until('the map', () => document.querySelector('#landscape-map canvas')?.checkVisibility());
    const before = await gains();
    await together(page, [[...drag, at(0.6, 0.5), 'up'], ...others]);
    driven.push(await gains());
    assert.notDeepEqual(driven.at(-1), before);
  }
  assert.deepEqual(driven[1], driven[0]);
});

pageTest(
  'a palm beside what moves a gain makes no drive of it, and parts no thumb from its number',
  async (page) => {
    if (page.engine !== 'chromium') return;
    await page.open('#lesson&step=1');
    await page.until('the gains', () => document.querySelector('#slider-kx')?.checkVisibility());
    const on = '#slider-kx';
    const at = (/** @type {number} */ x) => ({ on, x, y: 0.5 });
    const elsewhere = { on: '#lesson h2', x: 0.3, y: 0.5 };
    await together(page, [
      [at(0.5), 'down', at(0.6), at(0.65), 'wait', 'wait', at(0.7), at(0.75), at(0.8), 'up'],
      ['wait', 'wait', 'wait', elsewhere, 'down', 'up'],
    ]);
    await page.until('it is counted', () =>
      /\b1 drive\b/.test(document.getElementById('lesson')?.innerText ?? ''),
    );

    await together(page, [
      [at(0.2), 'down', 'wait', 'wait', 'wait', 'up'],
      ['wait', 'wait', elsewhere, 'down', 'up'],
    ]);
    await page.evaluate(() => pageFrames.settled());
    assert.equal(Number(await shownBy(page, on)), Number(await shownBy(page, '#gain-kx')));
  },
);

pageTest('one hand holds the goal, another turns it', async (page) => {
  if (page.engine !== 'chromium') return;
  await page.open('#lab');
  const goal = (/** @type {number} */ x) => ({ on: '#goal-position', x, y: 0.5 });
  const at = (/** @type {number} */ x, /** @type {number} */ y) => ({ on: '#goal-heading', x, y });
  // It trembles.
  await together(page, [
    [goal(0.5), 'down', ...[0.6, 0.7, 0.6, 0.7, 0.6, 0.7, 0.6].map(goal), 'up'],
    ['wait', 'wait', at(0.5, 0.5), 'down', at(-0.5, 0), at(-1, -0.2), at(-2, -0.5), 'up'],
  ]);
  const theta = await page.until(
    'the goal is turned',
    () => /goal\.theta=([-\d.]+)/.exec(location.hash)?.[1],
  );
  assert.ok(Number(theta) > 0.9, `${theta}`);
});

pageTest('a drag of a gain that a browser takes away was a drive', async (page) => {
  await page.open('#lab&v=1&drives=hand&gains=3.3,0,4.5&task=Few.&aim=J%3C9;drives%3C%3D3');
  await page.until('the aim', () => document.querySelector('.aim-drives'));
  await page.evaluate(() => {
    const slider = /** @type {HTMLInputElement} */ (document.getElementById('slider-kx'));
    slider.value = '4';
    for (const kind of ['input', 'pointercancel']) slider.dispatchEvent(new Event(kind, { bubbles: true }));
  });
  await page.until(
    'it is counted',
    () => document.querySelector('.aim:not(.late) .aim-drives')?.textContent === '1 of 3 drives',
  );
});

pageTest(
  'a finger that only scrolls lets the drive be as it is',
  async (page) => {
    await page.open('#lab');
    const clock = () => /** @type {HTMLInputElement} */ (document.getElementById('scrub')).value;
    await page.until('the robot has arrived', () => {
      const scrub = /** @type {HTMLInputElement | null} */ (document.getElementById('scrub'));
      return scrub && scrub.value === scrub.max && document.getElementById('play')?.textContent;
    });
    const before = await page.evaluate(clock);
    await page.evaluate(async () => {
      document.getElementById('slider-kx')?.dispatchEvent(new Event('pointercancel', { bubbles: true }));
      await new Promise(requestAnimationFrame);
      await new Promise(requestAnimationFrame);
    });
    assert.equal(await page.evaluate(clock), before);
  },
  { moves: true },
);

pageTest('a pen that scrolls the page moves no slider', async (page) => {
  await page.open('#lab');
  const seen = await page.evaluate(async () => {
    const slider = /** @type {HTMLInputElement} */ (document.getElementById('slider-kx'));
    const before = slider.value;
    const send = (/** @type {string} */ kind) =>
      slider.dispatchEvent(new PointerEvent(kind, { bubbles: true, pointerId: 7, pointerType: 'pen' }));
    send('pointerdown');
    slider.value = '9';
    slider.dispatchEvent(new Event('input', { bubbles: true }));
    send('pointercancel');
    await pageFrames.settled();
    return { before, after: slider.value, driver: document.querySelector('#drives :checked')?.id };
  });
  assert.equal(seen.after, seen.before);
  assert.equal(seen.driver, 'drives-evolved');
});
