// Start and goal in the hand.
import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { fields } from '../harness/core.js';
import { middleOf, read } from '../harness/reading.js';
import { endSurrounding, follow, surround } from '../whole/surround.js';

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

pageTest('a press that trembles, or that Escape takes back, leaves the run as it was', async (page) => {
  await page.open('#lab&v=1&generation=12');
  const before = await read(page);
  for (const part of ['position', 'heading']) {
    const { x, y } = await middleOf(page, `goal-${part}`, `goal-${part}`);
    await page.drag(`#goal-${part}`, [
      { x, y },
      { x: x + 1, y: y + 1 },
    ]);
    const { goal, generation } = await read(page);
    assert.deepEqual({ goal, generation }, { goal: before.goal, generation: '12' }, part);
  }
  const { x, y } = await middleOf(page, 'goal-position', 'goal-position');
  const origin = await page.element('#goal-position');
  const hand = page.driver.actions();
  await hand
    .move({ origin })
    .press()
    .move({ x: Math.round(x) + 40, y: Math.round(y) + 30 })
    .perform();
  await page.until('another run has begun', () => document.body.innerText.includes('begins again'));
  await page.press(Key.ESCAPE);
  await page.driver.actions().release().perform();
  await page.until('it is back', () => !document.body.innerText.includes('begins again'));
  const after = await read(page);
  assert.deepEqual(after, before);
});

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

/** How each posture is said to stand, and how its knob is drawn, in degrees. @param {import('../harness/browsers.js').Page} page */
const headings = (page) =>
  page.evaluate(() =>
    ['start', 'goal'].map((end) => {
      const [position, heading] = ['position', 'heading'].map((part) => {
        const handle = /** @type {Element} */ (document.getElementById(`${end}-${part}`));
        const { left, right, top, bottom } = handle.getBoundingClientRect();
        return { x: (left + right) / 2, y: (top + bottom) / 2, said: Number(handle.ariaValueNow) };
      });
      const drawn = (Math.atan2(position.y - heading.y, heading.x - position.x) * 180) / Math.PI;
      return { end, drawn, said: heading.said };
    }),
  );

pageTest(
  'the knob of start and goal is drawn where they point, on any screen, and a touch hardly turns them',
  async (page) => {
    if (page.engine !== 'chromium') return;
    try {
      await page.open('#lab&v=1');
      for (const [link, ...size] of /** @type {const} */ ([
        ['lesson&step=5', 1280, 585],
        ['lesson&step=12', 1366, 650],
        ['lesson&step=2', 1280, 585],
        ['lesson&step=1', 683, 680],
        ['lab&v=1', 960, 1000],
        ['lab&v=1', 390, 760],
        ['lab&v=1&goal.theta=90deg&pin1=first~5,1,5', 1097, 530],
        ['lab&v=1&start=0,0,-90deg;1,1,1;-2,0,2&goal.theta=130deg', 800, 600],
      ])) {
        const view = `${link} at ${size.join('×')}`;
        await surround(page, size);
        await follow(page, link);
        for (const { end, drawn, said } of await headings(page))
          assert.ok(Math.abs(drawn - said) < 1, `${view}, ${end}: ${drawn}° for ${said}°`);

        const [, before] = await headings(page);
        const { x, y } = await middleOf(page, 'goal-heading', 'goal-heading');
        await page.drag('#goal-heading', [
          { x, y },
          { x: x + 1, y: y + 2 },
        ]);
        const [, after] = await headings(page);
        const turned = Math.abs(after.said - before.said);
        assert.ok(turned > 0 && turned < 5, `${view}: from ${before.said}° to ${after.said}°`);
      }
    } finally {
      await endSurrounding(page);
    }
  },
);
