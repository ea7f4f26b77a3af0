// Start and goal in the hand.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { fields } from '../harness/core.js';

pageTest(
  'what is moved alone becomes whole centimetres, what is turned alone whole degrees',
  async (page) => {
    const goal = async () => {
      const text = await page.until(
        'it is written',
        () => /goal\.theta=/.test(location.hash) && location.hash,
      );
      const value = (/** @type {string} */ name) =>
        Number(new URLSearchParams(text).get(`goal.${name}`) ?? 2);
      return [value('x'), value('y'), value('theta')];
    };
    await page.open('#lab&v=1&goal.x=1.125&goal.theta=0.3927');
    await page.focus('#goal-position');
    await page.press(Key.ARROW_UP);
    await page.until('it is moved', () => /goal\.y=/.test(location.hash));
    assert.deepEqual(await goal(), [1.125, 2.1, 0.3927]);
    await page.focus('#goal-heading');
    await page.press(Key.ARROW_LEFT);
    await page.until('it is turned', () => !/goal\.theta=0\.3927/.test(location.hash));
    assert.deepEqual((await goal()).slice(0, 2), [1.125, 2.1]);
  },
);

pageTest(
  'start and goal are sliders, which say where they stand, and keep what they are called',
  async (page) => {
    await page.open('#lab');
    const said = (/** @type {string} */ id) =>
      page.evaluate((id) => {
        const { role, ariaLabel, ariaValueText, ariaValueNow } = /** @type {Element} */ (
          document.getElementById(id)
        );
        return { role, ariaLabel, ariaValueText, ariaValueNow: Number(ariaValueNow) };
      }, id);
    const range = fields().find(({ path }) => path === 'goal.x');
    assert.deepEqual(
      await page.evaluate(() => {
        const { ariaValueMin, ariaValueMax } = /** @type {Element} */ (
          document.getElementById('goal-position')
        );
        return [Number(ariaValueMin), Number(ariaValueMax)];
      }),
      [range?.min, range?.max],
    );
    for (const end of ['start', 'goal'])
      for (const part of ['position', 'heading']) {
        const id = `${end}-${part}`;
        const before = await said(id);
        assert.equal(before.role, 'slider', id);
        await page.focus(`#${id}`);
        await page.press(Key.ARROW_RIGHT);
        const after = await said(id);
        assert.equal(after.ariaLabel, before.ariaLabel, id);
        const text = await page.text(`#${end}-text`);
        assert.ok(
          after.ariaValueText && text.includes(after.ariaValueText),
          `${after.ariaValueText}: ${text}`,
        );
        const step = part === 'heading' ? -5 : 0.1;
        assert.ok(Math.abs(after.ariaValueNow - before.ariaValueNow - step) < 1e-6, id);
      }
  },
);
