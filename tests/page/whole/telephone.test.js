// On a telephone one sees what one does, however it is held.
import assert from 'node:assert/strict';
import { pageNames } from '../../../www/parts/parts.js';
import { Key, engineTest } from '../harness/browsers.js';
import { experiment, shown, simulate } from '../harness/core.js';
import { read } from '../harness/reading.js';

engineTest('on a telephone held sideways the robots stay beside all that is scrolled', async (page) => {
  await page.resize(740, 340);
  await page.open('#lab&aim=J%3C8&task=Park.');
  await page.until('the aim is there', () => document.getElementById('aim')?.checkVisibility());
  for (const part of pageNames.filter((name) => name !== 'park')) {
    // Its name may be out of sight in their row.
    await page.evaluate((name) => document.getElementById(`page-${name}`)?.click(), part);
    await page.until(`${part} is open`, (name) => document.body.dataset.open === name, part);
    const { planeHeight, ...rest } = await page.evaluate(async () => {
      scrollTo({ top: document.documentElement.scrollHeight, behavior: 'instant' });
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const boxOf = (/** @type {string} */ selector) =>
        /** @type {Element} */ (document.querySelector(selector)).getBoundingClientRect();
      const [aim, robots, readings, plane] = ['#aim', '.robot', '.readings', '#plane'].map(boxOf);
      return {
        isWhole: robots.top >= aim.bottom && robots.bottom <= innerHeight,
        isBeside: robots.right <= readings.left,
        isTooWide: document.documentElement.scrollWidth > innerWidth,
        planeHeight: plane.height,
      };
    });
    assert.deepEqual(rest, { isWhole: true, isBeside: true, isTooWide: false }, part);
    assert.ok(planeHeight >= 180, `${part}: a plane of ${planeHeight} px`);
  }
});

engineTest('there the words of a step stand beside its figure, all of which is in sight', async (page) => {
  await page.resize(740, 360);
  for (const step of [1, 3, 10, '1&task=Drive.&aim=J%3C9']) {
    await page.open(`#lesson&step=${step}`);
    const { isBeside, cut } = await page.evaluate(async () => {
      const [figure, words] = ['.figure', '#lesson'].map(
        (selector) => /** @type {Element} */ (document.querySelector(selector)),
      );
      scrollTo({ top: document.documentElement.scrollHeight / 2, behavior: 'instant' });
      await new Promise((resolve) => requestAnimationFrame(resolve));
      const box = figure.getBoundingClientRect();
      const isIn = (/** @type {DOMRect} */ { top, bottom, left, right }) =>
        top >= box.top - 1 && bottom <= box.bottom + 1 && left >= box.left - 1 && right <= box.right + 1;
      return {
        isBeside:
          box.top >= 0 && box.bottom <= innerHeight && box.right <= words.getBoundingClientRect().left,
        cut: [...figure.querySelectorAll('#plane, #gains input, #run, #pushes, .map')]
          .filter((one) => one.checkVisibility() && !isIn(one.getBoundingClientRect()))
          .map(({ id }) => id),
      };
    });
    assert.ok(isBeside, `step ${step}`);
    assert.deepEqual(cut, [], `step ${step}`);
  }
});

engineTest(
  'on one held upright the robots stay above what is scrolled, and J beside the sliders',
  async (page) => {
    await page.resize(500, 640);
    for (const part of ['lab', 'landscape', 'generation', 'luck']) {
      await page.open(`#${part}&v=1`);
      await page.until(`${part} is there`, (name) => document.body.dataset.open === name, part);
      const { robots, last } = await page.evaluate(async () => {
        scrollTo({ top: document.documentElement.scrollHeight, behavior: 'instant' });
        await new Promise((resolve) => requestAnimationFrame(resolve));
        const boxOf = (/** @type {Element} */ one) => one.getBoundingClientRect();
        const shown = [...document.querySelectorAll('.readings > *')].filter((one) => one.checkVisibility());
        return {
          robots: boxOf(/** @type {Element} */ (document.querySelector('.robot'))),
          last: Math.max(...shown.map((one) => boxOf(one).bottom)),
        };
      });
      assert.ok(robots.top >= 0 && robots.bottom <= 340, `${part}: ${JSON.stringify(robots)}`);
      assert.ok(last > robots.bottom + 200, `${part}: ${last} below ${robots.bottom}`);
    }
    await page.open('#lab&v=1&drives=hand&gains=3,2,5');
    await page.focus('#slider-ky');
    await page.press(Key.ARROW_RIGHT);
    const { gains } = await read(page);
    const { cost } = simulate(experiment('velocity-limits'), /** @type {any} */ (gains.map(Number)));
    await page.until(
      'J is beside it',
      (text) => {
        const j = /** @type {HTMLElement} */ (document.getElementById('gains-cost'));
        const { top, bottom } = j.getBoundingClientRect();
        const robots = /** @type {Element} */ (document.querySelector('.robot')).getBoundingClientRect();
        return j.innerText === text && top >= robots.bottom && bottom <= innerHeight;
      },
      `J ${shown(cost.total)}`,
    );
  },
);

engineTest('who turns it goes on reading where they were', async (page) => {
  await page.resize(500, 640);
  await page.open('#lesson&step=4');
  /** Once nothing moves: the first piece of the words that is in sight, and how far the page is scrolled. */
  const reading = () =>
    page.evaluate(async () => {
      for (let i = 0; i < 12; i += 1) await new Promise((resolve) => requestAnimationFrame(resolve));
      const lesson = /** @type {Element} */ (document.getElementById('lesson'));
      const { left, width } = lesson.getBoundingClientRect();
      const seen = Array.from({ length: innerHeight / 12 }, (_, i) =>
        document.elementFromPoint(left + width / 2, 12 * i)?.closest('#lesson :is(p, li, button)'),
      );
      return { first: seen.find((one) => one)?.textContent ?? '', scrolled: scrollY };
    });
  await page.evaluate(() => scrollTo({ top: 2000, behavior: 'instant' }));
  const before = await reading();
  assert.equal(before.scrolled, 2000);
  await page.resize(740, 360);
  await page.until('it is held sideways', () => matchMedia('(max-height: 480px)').matches);
  const turned = await reading();
  assert.equal(turned.first, before.first);
  assert.notEqual(turned.scrolled, 2000, 'there it stands elsewhere');
  // A sheet that was opened meanwhile lies over the words.
  await page.evaluate(() => document.getElementById('keep-button')?.click());
  await page.until('the sheet is open', () => document.querySelector('dialog[open]'));
  await page.resize(500, 640);
  await page.until('it is held upright', () => matchMedia('(min-height: 600px)').matches);
  await page.click('#keep-close');
  const after = await reading();
  assert.equal(after.first, before.first);
  assert.ok(Math.abs(after.scrolled - 2000) < 40, `${after.scrolled}`);
});
