import assert from 'node:assert/strict';
import { fileURLToPath } from 'node:url';
import { Key, engineTest, pageTest } from '../harness/browsers.js';
import { middleOf, read } from '../harness/reading.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const top = fileURLToPath(new URL('../../../', import.meta.url));

engineTest(
  'the page opens and works without errors, and asks no other host',
  async (page) => {
    assert.deepEqual(await page.problems(), []);
    const { generation, cost, finalTime } = await read(page);
    assert.equal(generation, '0');
    assert.ok(Number(cost) > 0 && finalTime > 0);
    const words = await page.evaluate(() => document.body.textContent);
    assert.ok(!words.includes('npm start'), 'the page still tells how to start it');
    for (const id of [
      'run',
      'run',
      'new-seed',
      'drives-paper-ep',
      'drives-hand',
      'preset-acceleration-limits',
      'play',
      'reset',
    ])
      await page.click(`#${id}`);
    assert.deepEqual(await page.problems(), []);
    const requests = await page.evaluate(() =>
      performance.getEntriesByType('resource').map(({ name }) => name),
    );
    assert.ok(requests.length > 0);
    assert.deepEqual(
      requests.filter((address) => new URL(address).origin !== new URL(page.site.address).origin),
      [],
    );
  },
  { moves: true },
);

engineTest(
  'Tab reaches every control in order and leaves the page, and each shows its focus',
  async (page) => {
    /** @type {Record<string, string>} */
    const focused = {};
    /** @type {string[]} */
    const reached = [];
    do {
      await page.press(Key.TAB);
      reached.push(await page.evaluate(() => document.activeElement?.id ?? ''));
      const [id] = reached.slice(-1);
      if (id !== '') focused[id] = (await focusMarks(page, [id]))[id];
      // A goal that is moved brings the button that moves it back.
      if (id === 'goal-position') await page.press(Key.ARROW_UP);
    } while (
      reached.length < 50 &&
      reached.at(-1) !== '' &&
      reached.indexOf(reached[reached.length - 1]) === reached.length - 1
    );
    const after = reached.pop();

    const controls = await page.evaluate(() => {
      /** @type {HTMLElement} */ (document.activeElement).blur();
      const all = /** @type {NodeListOf<HTMLInputElement>} */ (
        document.querySelectorAll('a[href], button, input, select, textarea, summary, [tabindex="0"]')
      );
      // Of radio buttons, Tab reaches the one that is chosen.
      return [...all]
        .filter((one) => one.checkVisibility() && !one.disabled && (one.type !== 'radio' || one.checked))
        .map(({ id }) => id);
    });
    assert.ok(controls.includes('restore-postures'));
    assert.deepEqual(reached, controls);
    assert.ok(after === '' || after === controls[0], `after the last control, Tab goes to ${after}`);

    const unfocused = await focusMarks(page, controls);
    for (const id of controls) {
      assert.notEqual(focused[id], unfocused[id], `${id} does not show its focus`);
      assert.notEqual(focused[id], 'none', `${id} has no mark of its focus`);
    }
  },
);

/** The outline and shadow of controls, or of what is seen in the place of one that is transparent. @param {Page} page @param {string[]} ids @returns {Promise<Record<string, string>>} */
const focusMarks = (page, ids) =>
  page.evaluate(
    (names) =>
      Object.fromEntries(
        names.map((name) => {
          const control = /** @type {HTMLElement} */ (document.getElementById(name));
          const isClear = getComputedStyle(control).opacity === '0';
          const face = isClear ? control.nextElementSibling : control;
          const { outlineStyle, outlineWidth, outlineColor, boxShadow } = getComputedStyle(face ?? control);
          const isOutlined =
            outlineStyle !== 'none' && outlineWidth !== '0px' && !/, 0\)$/.test(outlineColor);
          const outline = isOutlined ? `${outlineStyle} ${outlineWidth} ${outlineColor}` : 'none';
          return [name, boxShadow === 'none' ? outline : `${outline} ${boxShadow}`];
        }),
      ),
    ids,
  );

engineTest('the source of the page, served or opened as it is, says how to start it', async (page) => {
  const site = await serve(top);
  try {
    for (const address of [site.address, new URL('../../../index.html', import.meta.url).href]) {
      await page.visit(address);
      const text = await page.until('a sentence is there to read', () => {
        for (const wait of document.getAnimations()) wait.finish();
        const instead = document.getElementById('instead');
        const isSeen = instead?.checkVisibility({ visibilityProperty: true, opacityProperty: true });
        return isSeen && instead?.innerText;
      });
      assert.match(text, /npm start/);
      const shows = () => document.getElementById('instrument')?.checkVisibility();
      assert.equal(await page.evaluate(shows), false, 'controls that nothing drives are to be seen');
    }
  } finally {
    await site.close();
  }
});

engineTest('the page is never wider than a telephone', async (page) => {
  // In a frame, because not every engine's window can be so narrow.
  for (const [width, hash] of /** @type {const} */ ([
    [390, '#lab'],
    [320, '#lab'],
    // One long word, in what is wrong and in a task.
    [320, `#lab&v=1&goal.x=${'m'.repeat(150)}`],
    [320, `#lab&v=1&lang=ko&task=${'m'.repeat(96)}`],
  ])) {
    await page.evaluate(
      (pixels, link) => {
        document.querySelector('iframe')?.remove();
        const frame = document.createElement('iframe');
        const src = new URL(link, location.href);
        Object.assign(frame, { src, width: String(pixels), height: '844', frameBorder: '0' });
        document.body.append(frame);
      },
      width,
      hash,
    );
    const size = await page.until('the narrow page is ready', () => {
      const root = document.querySelector('iframe')?.contentDocument?.documentElement;
      return root?.dataset.ready === 'true' && { window: root.clientWidth, page: root.scrollWidth };
    });
    assert.ok(size.window <= width && size.page <= size.window, `${hash}: ${JSON.stringify(size)}`);
  }
});

pageTest('nothing is in the way of assistive technology', async (page) => {
  await page.focus('#gain-ky');
  await page.press('x', Key.ENTER);
  await page.click('#run');
  await page.until('generation 2', () => Number(document.getElementById('generation')?.innerText) >= 2);
  await page.click('#run');
  await page.focus('#goal-position');
  await page.press(Key.ARROW_UP);
  await read(page);
  assert.deepEqual(await page.obstacles(), []);
});

pageTest('on a telephone the name of the open part is in sight, whichever it is', async (page) => {
  await page.resize(390, 844);
  for (const name of ['park', 'training', 'luck']) {
    await page.open(`#${name}`);
    const isInSight = await page.evaluate((open) => {
      const [link, nav] = [`page-${open}`, 'pages'].map((id) =>
        /** @type {HTMLElement} */ (document.getElementById(id)).getBoundingClientRect(),
      );
      return link.left >= nav.left - 1 && link.right <= nav.right + 1;
    }, name);
    assert.ok(isInSight, name);
  }
});

pageTest('the postures in words give way to a start that stands below them', async (page) => {
  await page.resize(1280, 720);
  for (const [start, isLeft] of /** @type {const} */ ([
    ['0,0,0', false],
    ['4.3,0,0', true],
  ])) {
    await page.open(`#lab&v=1&start=${start}`);
    await page.until(
      `they stand on the ${isLeft ? 'left' : 'right'}`,
      (wanted) => {
        const [notes, plane, handle] = ['postures', 'plane', 'start-position'].map((id) =>
          /** @type {HTMLElement} */ (document.getElementById(id)).getBoundingClientRect(),
        );
        const onLeft = (notes.left + notes.right) / 2 < (plane.left + plane.right) / 2;
        const isFree = handle.right < notes.left || handle.left > notes.right;
        return isFree && onLeft === wanted;
      },
      isLeft,
    );
  }
  assert.deepEqual(await page.problems(), []);
});

engineTest(
  'a drag ends where its pointer is lost, also when the goal leaves the page meanwhile',
  async (page) => {
    const hold = async () => {
      await page.evaluate(() => {
        const note = (/** @type {PointerEvent} */ { pointerId }) =>
          Object.assign(document.documentElement.dataset, { pointerId });
        addEventListener('pointerdown', note, { once: true });
      });
      const handle = await page.element('#goal-position');
      const actions = page.driver.actions().move({ origin: handle }).press();
      await actions.move({ origin: handle, x: -60, y: 30 }).perform();
    };
    const goTo = (/** @type {string} */ hash) =>
      page.evaluate((to) => {
        location.hash = to;
      }, hash);
    await page.open('#lab&v=1');
    await hold();
    await page.evaluate(() => {
      const { pointerId } = document.documentElement.dataset;
      document.getElementById('goal-position')?.releasePointerCapture(Number(pointerId));
    });
    // Nothing is held any more, which some browsers tell only then.
    const { x } = await middleOf(page, 'goal-position');
    await page.driver.actions().move({ x: 40, y: 40 }).release().perform();
    await page.until('it is written', () => /goal\.x=/.test(location.hash));
    assert.equal((await middleOf(page, 'goal-position')).x, x);

    await goTo('lab&v=1');
    await page.until('the goal is back', () => document.getElementById('goal-position')?.checkVisibility());
    await hold();
    await goTo('lab&v=1&task=x&hide=postures');
    await page.until('no goal is there', () => !document.getElementById('goal-position'));
    await page.driver.actions().release().perform();
    await goTo('lab&v=1&seed=3');
    await page.until('the goal is back', () => document.getElementById('goal-position')?.checkVisibility());
    await page.click('#run');
    await page.until('it evolves, and says so', () => /generation=/.test(location.hash));
    assert.match(await page.evaluate(() => location.hash), /^#lab&v=1&seed=3&generation=\d+$/);
    assert.deepEqual(await page.problems(), []);
  },
);
