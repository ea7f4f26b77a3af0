// Start and goal in the hand.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';

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
