// What a host asks of a figure, and what it is told.
import assert from 'node:assert/strict';
import { wantedHeight } from '../../../www/embed/frame.js';
import { parts } from '../../../www/parts/parts.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment, historyOf, simulate } from '../harness/core.js';
import { ask, heardFrom, frameOf, inHost, serveHost, within } from '../harness/host.js';
import { serve } from '../harness/server.js';
import { clockOf, course } from './course.js';

/** @typedef {import('../harness/host.js').Heard} Heard */

pageTest(
  'what a figure tells of its drive are the gains that drive, also where one robot of many is chosen',
  async (page) => {
    await inHost(page, frameOf(page, 'generation&v=1&seed=7&generation=5', 640, 420), async () => {
      const { drive } = await ask(page, 0, { type: 'read' });
      const { cost } = simulate(experiment({ evolution: { seed: 7 } }), drive.gains);
      assert.equal(drive.cost.total, cost.total);
    });
  },
);

pageTest('the host sets experiments and reads what comes of them', async (page) => {
  await inHost(page, course(page), async () => {
    const [first] = await heardFrom(page, 0);
    assert.equal(first.type, 'ready');
    assert.equal(first.ep, 1);
    assert.equal(first.experiment.evolution.seed, 7);

    const linked = await ask(page, 0, { type: 'set', link: 'https://host/#lab&v=1&seed=9&generation=4' });
    assert.deepEqual(
      [linked.type, linked.generation, linked.generations, linked.problems],
      ['state', 4, 4, []],
    );
    const seed9 = experiment({ evolution: { seed: 9 } });
    assert.equal(linked.hash, evolve(seed9, 4).hash);
    assert.deepEqual(linked.statistics, historyOf(seed9, 4)[4]);

    const goal = { x: 1.5, y: 1, theta: 0.5 };
    const moved = experiment({ goal, evolution: { seed: 3 } });
    const set = await ask(page, 0, {
      type: 'set',
      experiment: { goal, evolution: { seed: 3 } },
      gains: [4, 1, 6],
    });
    assert.deepEqual(set.experiment, JSON.parse(JSON.stringify(moved)));
    const { cost, arrived, finalTime } = simulate(moved, [4, 1, 6]);
    assert.deepEqual(set.drive, { gains: [4, 1, 6], cost: { ...cost }, arrived, finalTime });
    assert.equal(set.generations, 0);

    const stepped = await ask(page, 0, { type: 'step', generations: 200 });
    assert.equal(stepped.generations, 200);
    assert.equal(stepped.hash, evolve(moved, 200).hash);
    const told = (await heardFrom(page, 0)).filter(({ type }) => type === 'generation').slice(-201);
    assert.deepEqual(
      told.map(({ ep, type, ...statistics }) => statistics),
      historyOf(moved, 200),
    );
    await within(page, 0, async () => {
      await page.until('generation 200', () => document.getElementById('generation')?.innerText === '200');
      assert.deepEqual(await page.evaluate(() => document.activeElement === document.body), true);
    });
    assert.deepEqual(await clockOf(page, 0), { stands: true, atEnd: true });

    const running = await ask(page, 2, { type: 'run' });
    assert.equal(running.evolving, true);
    const held = await ask(page, 2, { type: 'pause' });
    assert.equal(held.evolving, false);
  });
});

pageTest('what the host has wrong is told, and nothing else is answered', async (page) => {
  await inHost(page, frameOf(page, 'lab&v=1', 640, 420), async () => {
    for (const [message, said] of /** @type {const} */ ([
      [{ ep: 2, type: 'read' }, /version 1 .* not 2/],
      [{ type: 'reed' }, /one of set, step, run, pause, read, not “reed”/],
      [{ type: 'toString' }, /not “toString”/],
      [{ type: '__proto__' }, /type must be/],
      [{ type: null }, /type must be/],
      [{ type: 'set' }, /a link.*or an experiment/],
      [{ type: 'set', link: 7 }, /a link.*or an experiment/],
      [{ type: 'set', experiment: { goal: { x: 1e9 } } }, /goal\.x must be/],
      [{ type: 'set', experiment: { flavour: 'red' } }, /flavour/],
      [
        { type: 'set', experiment: { evolution: { population: 2000 }, horizon: 1000, sampleTime: 1e-4 } },
        /./,
      ],
      [{ type: 'set', experiment: {}, gains: [1, 2] }, /gains must be three numbers/],
      [{ type: 'set', experiment: {}, generation: 1.5 }, /generation must be a whole number from 0/],
      [{ type: 'step', generations: 1e9 }, /generations must be a whole number from 1 to 10000/],
    ])) {
      const answer = await ask(page, 0, message);
      assert.equal(answer.type, 'error', JSON.stringify(message));
      assert.match(answer.message, said);
    }
    const { problems, experiment: opened } = await ask(page, 0, {
      type: 'set',
      link: 'lab&seed=5&goal.x=1000000&flavour=red',
    });
    assert.equal(problems.length, 2);
    assert.equal(opened.evolution.seed, 5);

    // What others say: a learning platform's answer, an extension, a figure's own sibling.
    const before = (await heardFrom(page, 0)).length;
    await page.evaluate(() => {
      const frame = document.querySelector('iframe')?.contentWindow;
      for (const message of [
        { subject: 'lti.frameResize.response' },
        'text',
        null,
        7,
        [1],
        { type: 'read', id: 'without ep' },
      ])
        frame?.postMessage(message, '*');
      const other = document.createElement('iframe');
      other.srcdoc =
        '<script>parent.frames[0].postMessage({ ep: 1, type: "set", link: "lab&seed=66" }, "*")</script>';
      document.body.append(other);
      return new Promise((resolve) => other.addEventListener('load', resolve));
    });
    const { experiment: still } = await ask(page, 0, { type: 'read' });
    assert.equal(still.evolution.seed, 5);
    assert.equal((await heardFrom(page, 0)).length, before + 1);
  });
});

engineTest(
  'the height is told at once and whenever the width changes, to learning platforms too',
  async (page) => {
    await inHost(page, frameOf(page, 'lab&v=1', 400, 300), async () => {
      const heights = async () =>
        (await heardFrom(page, 0)).filter(
          ({ type, subject }) => type === 'height' || subject === 'lti.frameResize',
        );
      await page.until('a height is told', () =>
        /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
          /** @type {unknown} */ (window)
        ).heard.some(({ data }) => data.subject === 'lti.frameResize'),
      );
      assert.deepEqual(await heights(), [
        { ep: 1, type: 'height', height: 300 },
        { subject: 'lti.frameResize', height: 300 },
      ]);
      await page.evaluate(() => {
        /** @type {HTMLIFrameElement} */ (document.querySelector('iframe')).width = '800';
      });
      const height = wantedHeight(parts, 'lab', 0, 800);
      await page.until(
        'the new height is told',
        (expected) =>
          /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
            /** @type {unknown} */ (window)
          ).heard.some(({ data }) => data.subject === 'lti.frameResize' && data.height === expected),
        height,
      );
      assert.equal((await heights()).length, 4);
      // Another height alone is no reason to ask for another one.
      await page.evaluate(async () => {
        const frame = /** @type {HTMLIFrameElement} */ (document.querySelector('iframe'));
        for (const high of ['700', '350', '512']) {
          frame.height = high;
          await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
        }
      });
      await within(page, 0, () => page.until('the frame has its last height', () => innerHeight === 512));
      await ask(page, 0, { type: 'read' });
      assert.equal((await heights()).length, 4);
    });
  },
);

pageTest('a host that scrolls only at one of two heights is asked for one of them', async (page) => {
  // As a page does whose bar comes with the height of the figure, and takes some of its width.
  const html = `${frameOf(page, 'lab&v=1', 900, 420)}<script>
    addEventListener('message', ({ data }) => {
      if (data.type === 'height') document.querySelector('iframe').width = data.height > 570 ? 885 : 900;
    });
  </script>`;
  await inHost(page, html, async () => {
    await within(page, 0, () => page.until('the bar is there', () => innerWidth === 885));
    const heights = async () =>
      (await heardFrom(page, 0)).flatMap(({ height, ep }) => (ep ? height : []) ?? []);
    await page.evaluate(() => new Promise((resolve) => setTimeout(resolve, 300)));
    assert.deepEqual(await heights(), [wantedHeight(parts, 'lab', 0, 900)]);
    // A part of its own has a height of its own.
    await ask(page, 0, { type: 'set', link: 'curves&v=1' });
    const own = wantedHeight(parts, 'curves', 0, 885);
    await page.until(
      'its height is told',
      (expected) =>
        Reflect.get(window, 'heard').some((/** @type {Heard} */ { data }) => data.height === expected),
      own,
    );
  });
});

pageTest('a figure answers its host while its part is still on its way', async (page) => {
  let arrive = () => {};
  /** @type {Promise<void>} */
  const onItsWay = new Promise((resolve) => {
    arrive = resolve;
  });
  const site = await serve(undefined, {
    send: (name, content) =>
      /page-.*\.js$/.test(name) && content.includes('id="landscape-map"')
        ? onItsWay.then(() => content)
        : content,
  });
  const host = await serveHost(`<iframe src="${site.address}?embed#landscape"></iframe>`);
  try {
    await page.visit(host.address);
    await page.until('it answers', () => {
      document.querySelector('iframe')?.contentWindow?.postMessage({ ep: 1, type: 'read', id: 'early' }, '*');
      const { heard } = /** @type {{ heard: Heard[] }} */ (/** @type {unknown} */ (window));
      return heard.some(({ data }) => data.id === 'early' && data.type === 'state');
    });
    const told = await heardFrom(page, 0);
    assert.ok(!told.some(({ type }) => type === 'ready'), 'its part was there');
    arrive();
    await page.until('it is ready', () => {
      const { heard } = /** @type {{ heard: Heard[] }} */ (/** @type {unknown} */ (window));
      return heard.some(({ data }) => data.type === 'ready');
    });
  } finally {
    arrive();
    await page.leave();
    await Promise.all([host.close(), site.close()]);
  }
});
