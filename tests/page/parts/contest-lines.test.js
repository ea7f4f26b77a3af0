// The two lines of the contest's picture, target and budget, as they are dragged, pressed and moved by keys.
import assert from 'node:assert/strict';
import { standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { Key, engineTest } from '../harness/browsers.js';
import { link, openContest, readTable, runContest, withoutVerdict } from './contest-page.js';
import { expectedTable, small } from './contests.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** Where the handle of a line stands, and what it says. @param {Page} page @param {string} id */
const handle = (page, id) =>
  page.evaluate((name) => {
    const element = /** @type {HTMLElement} */ (document.getElementById(name));
    const { left, top, width, height } = element.getBoundingClientRect();
    return {
      x: left + width / 2,
      y: top + height / 2,
      now: Number(element.getAttribute('aria-valuenow')),
      text: element.getAttribute('aria-valuetext') ?? '',
    };
  }, id);

/** Presses on a handle and moves by so much. @param {Page} page @param {string} id @param {number} dx @param {number} dy @param {'mouse' | 'touch'} kind */
const dragHandle = (page, id, dx, dy, kind) =>
  page.evaluate(
    async (name, right, down, pointerType) => {
      const element = /** @type {HTMLElement} */ (document.getElementById(name));
      const { left, top, width, height } = element.getBoundingClientRect();
      const at = { clientX: left + width / 2, clientY: top + height / 2 };
      const send = (/** @type {string} */ type, /** @type {object} */ point) =>
        element.dispatchEvent(
          new PointerEvent(type, {
            ...point,
            pointerId: 1,
            pointerType,
            button: 0,
            buttons: 1,
            bubbles: true,
            cancelable: true,
          }),
        );
      // A pointer that is made up cannot be captured.
      let captured = Number.NaN;
      element.setPointerCapture = (id) => {
        captured = id;
      };
      element.hasPointerCapture = (id) => id === captured;
      send('pointerdown', at);
      for (const part of [0.5, 1])
        send('pointermove', { clientX: at.clientX + part * right, clientY: at.clientY + part * down });
      send('pointerup', at);
      await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
    },
    id,
    dx,
    dy,
    kind,
  );

engineTest(
  'target and budget are dragged by mouse and finger, and moved by keys; the table follows',
  async (page) => {
    await openContest(page, `${link}&target=7.9`);
    await runContest(page);
    for (const kind of /** @type {const} */ (['mouse', 'touch'])) {
      const before = await handle(page, 'contest-target-line');
      await dragHandle(page, 'contest-target-line', 0, -20, kind);
      const after = await handle(page, 'contest-target-line');
      assert.ok(
        after.now > before.now && Math.abs(before.y - 20 - after.y) < 2,
        JSON.stringify([before, after]),
      );
      const typed = await page.evaluate(() =>
        Number(/** @type {HTMLInputElement} */ (document.getElementById('contest-target')).value),
      );
      assert.equal(typed, after.now);
      assert.deepEqual(withoutVerdict(await readTable(page)), expectedTable(small, after.now));
    }
    // A press on the picture means the target, but for one beside the other line.
    const picture = await page.evaluate(() => {
      const { left, top } = /** @type {Element} */ (
        document.querySelector('#contest-chart canvas')
      ).getBoundingClientRect();
      return { left, top };
    });
    const pressBeside = async (/** @type {string} */ id, /** @type {number[][]} */ ...steps) => {
      const { x, y } = await handle(page, id);
      const places = steps.map(([dx, dy]) => ({ x: x - picture.left + dx, y: y - picture.top + dy }));
      await page.drag('#contest-chart canvas', places);
    };
    const low = await handle(page, 'contest-target-line');
    await pressBeside('contest-target-line', [60, 30]);
    const pressed = await handle(page, 'contest-target-line');
    assert.ok(Math.abs(low.y + 30 - pressed.y) < 2, JSON.stringify([low, pressed]));
    const right = await handle(page, 'contest-until-line');
    await pressBeside('contest-until-line', [-5, 40], [-30, 40], [-40, 40]);
    const left = await handle(page, 'contest-until-line');
    assert.ok(Math.abs(right.x - 40 - left.x) < 4, JSON.stringify([right, left]));
    assert.equal((await handle(page, 'contest-target-line')).now, pressed.now);
    await page.click('#contest-whole');
    const { now: target } = await handle(page, 'contest-target-line');
    const whole = await handle(page, 'contest-until-line');
    assert.equal(whole.now, 1000);
    await dragHandle(page, 'contest-until-line', -60, 0, 'touch');
    const until = await handle(page, 'contest-until-line');
    assert.ok(until.now < 900 && until.now > 50, JSON.stringify(until));
    const expected = standingsOf(small, { target, until: until.now }).lines.map(
      ({ reached }) => `${reached} of 15`,
    );
    assert.deepEqual(
      (await readTable(page)).map(({ cells }) => cells[0]),
      expected,
    );
    await page.evaluate(() => document.getElementById('contest-until-line')?.focus());
    await page.press(Key.ARROW_RIGHT);
    await page.until(
      'a key moves it on',
      (was) => Number(document.getElementById('contest-until-line')?.getAttribute('aria-valuenow')) > was,
      until.now,
    );
    const { x } = await handle(page, 'contest-until-line');
    await page.evaluate(() => {
      const left = () => new KeyboardEvent('keydown', { key: 'ArrowLeft' });
      for (let i = 0; i < 5; i += 1) document.getElementById('contest-until-line')?.dispatchEvent(left());
    });
    const moved = x - (await handle(page, 'contest-until-line')).x;
    assert.ok(Math.abs(moved - 15) < 3, `five keys within a frame are five steps of 3 pixels, not ${moved}`);
    const ends = () =>
      page.evaluate(() => {
        const line = document.getElementById('contest-until-line');
        return ['now', 'min', 'max'].map((name) => Number(line?.getAttribute(`aria-value${name}`)));
      });
    for (const [key, end] of /** @type {const} */ ([
      [Key.END, 2],
      [Key.HOME, 1],
    ])) {
      await page.press(key);
      const values = await ends();
      assert.equal(values[0], values[end]);
    }
    await page.click('#contest-whole');
    await page.until(
      'it is read to the end',
      () => document.getElementById('contest-until-line')?.getAttribute('aria-valuenow') === '1000',
    );
    assert.deepEqual(await page.problems(), []);
  },
);
