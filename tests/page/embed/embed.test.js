// Figures in frames of another page: they fit, they leave the host alone, and they talk with it.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { addressOf } from '../../../www/kit/host.js';
import { frameText, sizes, wantedHeight } from '../../../www/embed/frame.js';
import { pageNames, parts } from '../../../www/parts/parts.js';
import { engineTest, pageTest } from '../harness/browsers.js';
import { evolve, experiment, historyOf, simulate } from '../harness/core.js';
import { ask, heardFrom, inHost, within } from '../harness/host.js';
import { test } from '../harness/once.js';
import { read } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

/** @param {Page} page @param {string} link @param {number} width @param {number} height @param {string} [more] */
const frameOf = (page, link, width, height, more = 'allow="fullscreen"') =>
  `<iframe src="${page.site.address}?embed#${link.replaceAll('&', '&amp;')}" width="${width}" height="${height}" style="border: 0" ${more}></iframe>`;

test('the text of a frame says where, how large and what, and nothing in it ends a value', () => {
  const address = addressOf('https://host/ep/?lang=ko&embed#lab', 'lab&v=1&pin1=a"b<c', true);
  assert.equal(address, 'https://host/ep/?embed&lang=ko#lab&v=1&pin1=a%22b%3Cc');
  assert.equal(addressOf(address, 'curves', false), 'https://host/ep/?lang=ko#curves');
  assert.equal(addressOf('file:///home/me/ep.html', 'lab', true), 'file:///home/me/ep.html?embed#lab');
  const text = frameText({ address, title: 'a "title" & <more>', width: 640, height: 420 });
  assert.equal(
    text,
    '<iframe src="https://host/ep/?embed&amp;lang=ko#lab&amp;v=1&amp;pin1=a%22b%3Cc" title="a &quot;title&quot; &amp; &lt;more>" width="640" height="420" style="border: 0; max-width: 100%" loading="lazy" allow="fullscreen"></iframe>',
  );
});

test('the height that is asked for depends on the width alone, and has bounds', () => {
  for (const page of pageNames)
    for (const lesson of [0, 3]) {
      const heights = [100, 400, 640, 800, 1200, 3000].map((width) =>
        wantedHeight(parts, page, lesson, width),
      );
      assert.ok(heights.every(Number.isInteger));
      assert.deepEqual(
        heights,
        [...heights].sort((a, b) => a - b),
      );
      assert.ok(heights[0] >= 300 && heights[5] <= 720, `${page}: ${heights}`);
    }
});

/** The picture of each part, and what one presses first. */
/** @type {Record<string, string[]>} */
const essentials = {
  lab: ['#plane', '#run'],
  park: ['.park-plane', '#park-evolve'],
  generation: ['#generation-picture', '#generation-next'],
  curves: ['#curves-picture', '#play'],
  landscape: ['#landscape-map', '#run'],
  robustness: ['#robustness-map', '#robustness-quantity'],
  training: ['#training-unseen', '#training-evolve'],
  disturbance: ['#remains', '#disturbance-kind'],
  luck: ['#luck-curve', '#luck-run'],
};

/** In the frame: what of a figure has no place. @param {readonly string[]} selectors */
function misplaced([picture, control]) {
  const problems = [];
  const { clientWidth: width, clientHeight: height, scrollWidth, scrollHeight } = document.documentElement;
  if (scrollWidth > width || scrollHeight > height)
    problems.push(`${scrollWidth} × ${scrollHeight} in ${width} × ${height}`);
  const boxOf = (/** @type {Element} */ element) => element.getBoundingClientRect();
  /** @param {DOMRect} box */
  const isInside = (box) =>
    box.left >= 0 && box.top >= 0 && box.right <= width + 0.5 && box.bottom <= height + 0.5;
  for (const selector of [picture, control, '#embed-full', '#embed-screen']) {
    const element = document.querySelector(selector);
    if (!element?.checkVisibility()) problems.push(`${selector} is not in sight`);
    else if (!isInside(boxOf(element)))
      problems.push(`${selector} sticks out: ${JSON.stringify(boxOf(element))}`);
  }
  const { width: wide, height: high } = boxOf(/** @type {Element} */ (document.querySelector(picture)));
  if (wide < 170 || high < 130) problems.push(`${picture} is small: ${wide} × ${high}`);
  // No control lies on another, but those on the plane.
  const controls = [...document.querySelectorAll('button, select, input, a')].filter(
    (one) => one.checkVisibility({ opacityProperty: false }) && !one.closest('.plane, .segmented'),
  );
  const boxes = controls.map((one) => ({ name: one.id || one.className, box: boxOf(one) }));
  for (const [i, { name, box }] of boxes.entries()) {
    if (!isInside(box)) problems.push(`${name} sticks out`);
    if (box.height < 24) problems.push(`${name} is only ${box.height} high`);
    for (const other of boxes.slice(i + 1))
      if (
        box.left < other.box.right - 1 &&
        other.box.left < box.right - 1 &&
        box.top < other.box.bottom - 1 &&
        other.box.top < box.bottom - 1
      )
        problems.push(`${name} lies on ${other.name}`);
  }
  for (const face of document.querySelectorAll('button, .segmented span, #embed-full'))
    if (face.checkVisibility() && face.scrollWidth > face.clientWidth + 1)
      problems.push(`${face.id || face.parentElement?.parentElement?.id} is cut: ${face.textContent}`);
  return problems;
}

for (const [[width, height], language] of /** @type {const} */ ([
  [sizes[0], 'en'],
  [sizes[0], 'ko'],
  [sizes[1], 'ko'],
  [sizes[2], 'en'],
]))
  (width === sizes[0][0] ? engineTest : pageTest)(
    `every part finds its place in ${width} × ${height}, in ${language}`,
    async (page) => {
      const links = pageNames.map((name) => `${name}&v=1${language === 'en' ? '' : `&lang=${language}`}`);
      await inHost(page, links.map((link) => frameOf(page, link, width, height)).join(''), async () => {
        /** @type {Record<string, string[]>} */
        const problems = {};
        for (const [frame, name] of pageNames.entries()) {
          const found = await within(page, frame, () => page.evaluate(misplaced, essentials[name]));
          if (found.length > 0) problems[name] = found;
        }
        assert.deepEqual(problems, {});
        // At the height that it asks for it fits as well.
        await page.evaluate(() => {
          const { heard } = /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
            /** @type {unknown} */ (window)
          );
          for (const [i, frame] of document.querySelectorAll('iframe').entries()) {
            const said = heard.filter((one) => one.frame === i && one.data.type === 'height').at(-1);
            frame.height = said?.data.height;
          }
        });
        for (const [frame, name] of pageNames.entries()) {
          const wanted = wantedHeight(parts, name, 0, width);
          await within(page, frame, async () => {
            await page.until(`${name} has its height`, (expected) => innerHeight === expected, wanted);
            assert.deepEqual(await page.evaluate(misplaced, essentials[name]), [], `${name} at ${wanted}`);
          });
        }
      });
    },
  );

pageTest('a step of the lesson stands beside its figure, without the way to other steps', async (page) => {
  const html = [400, 640, 800].map((width) => frameOf(page, 'lesson&step=2', width, 420)).join('');
  await inHost(page, html, async () => {
    for (const frame of [0, 1, 2])
      await within(page, frame, async () => {
        assert.deepEqual(
          await page.evaluate(() => ({
            title: document.querySelector('#lesson h2')?.textContent !== '',
            plane: document.getElementById('plane')?.checkVisibility(),
            others: [...document.querySelectorAll('.lesson-head, .lesson-foot, .masthead')].some((one) =>
              one.checkVisibility(),
            ),
            wide: document.documentElement.scrollWidth > innerWidth,
            full: document.getElementById('embed-full')?.getAttribute('href')?.includes('lesson=2'),
          })),
          { title: true, plane: true, others: false, wide: false, full: true },
        );
        const beside = await page.evaluate(() => {
          const [plane, words] = ['plane', 'lesson-title'].map((id) =>
            /** @type {HTMLElement} */ (document.getElementById(id)).getBoundingClientRect(),
          );
          return words.left > plane.right && words.top < innerHeight;
        });
        assert.equal(beside, frame > 0);
      });
  });
});

const three = ['lab&v=1&seed=7', 'landscape&v=1', 'generation&v=1&generation=3'];

/** A long page with three figures and a field in which one writes. @param {Page} page */
const course = (page) =>
  `<input id="field"><script>document.getElementById('field').focus()</script>
   ${three.map((link) => frameOf(page, link, 640, 420)).join('<p>…</p>')}<div style="height: 3000px"></div>`;

/** What moves in a figure. @param {Page} page @param {number} frame */
const clockOf = (page, frame) =>
  within(page, frame, () =>
    page.evaluate(async () => {
      const texts = [];
      for (let i = 0; i < 5; i += 1) {
        await new Promise((resolve) => requestAnimationFrame(resolve));
        texts.push(document.getElementById('clock')?.textContent ?? '');
      }
      const [now, end] = texts[0].match(/\d+\.\d+/g) ?? [];
      return { stands: new Set(texts).size === 1, atEnd: now === end };
    }),
  );

engineTest('three figures leave focus, keys and wheel to their host until they are used', async (page) => {
  await inHost(page, course(page), async () => {
    const focused = () => page.evaluate(() => document.activeElement?.id);
    assert.equal(await focused(), 'field');
    await page.press('r', 'n', 'p', '?');
    assert.equal(
      await page.evaluate(() => /** @type {HTMLInputElement} */ (document.getElementById('field')).value),
      'rnp?',
    );
    for (const frame of [0, 1, 2]) {
      const { generation, evolving } = await ask(page, frame, { type: 'read' });
      assert.deepEqual({ generation, evolving }, { generation: frame === 2 ? 3 : 0, evolving: false });
    }
    assert.equal(await focused(), 'field');

    for (const frame of [0, 1]) {
      // The browser gives a wheel to what it has drawn there.
      const before = await page.evaluate(async (number) => {
        document.querySelectorAll('iframe')[number].scrollIntoView();
        for (const _ of [1, 2]) await new Promise((resolve) => requestAnimationFrame(resolve));
        return scrollY;
      }, frame);
      // WebKit's driver turns no wheel over a frame. The types know nothing of wheels.
      if (page.engine !== 'webkit') {
        // Before the browser has the frame where it is drawn, a wheel goes nowhere.
        await page.driver.wait(
          async () => {
            await /** @type {any} */ (page.driver.actions()).scroll(300, 200, 0, 150).perform();
            return page.evaluate((y) => scrollY > y, before);
          },
          45_000,
          'the host scrolls under the wheel',
        );
      }
      assert.equal(await focused(), 'field');
      assert.equal(
        await within(page, frame, () =>
          page.evaluate(() => {
            const picture = document.querySelector('#landscape-map, #plane');
            const wheel = new WheelEvent('wheel', { deltaY: 100, bubbles: true, cancelable: true });
            return (picture?.dispatchEvent(wheel) ?? false) && scrollY === 0;
          }),
        ),
        true,
      );
      // One driver gives the focus to the frame into which it looks.
      await page.focus('#field');
    }
    for (const frame of [0, 1, 2])
      assert.deepEqual(await clockOf(page, frame), { stands: true, atEnd: true }, `frame ${frame}`);
  });
});

engineTest('a figure that is used has its keys, tells each generation, and is alone in it', async (page) => {
  await inHost(page, course(page), async () => {
    await within(page, 0, async () => {
      await page.click('#one-generation');
      await page.press('n', 'n');
      await page.until('generation 3', () => document.getElementById('generation')?.innerText === '3');
    });
    const seed7 = experiment({ evolution: { seed: 7 } });
    const told = (await heardFrom(page, 0)).filter(({ type }) => type === 'generation');
    assert.deepEqual(
      told.map(({ ep, type, ...statistics }) => statistics),
      historyOf(seed7, 3),
    );
    assert.equal((await ask(page, 1, { type: 'read' })).generations, 0);
    assert.equal((await ask(page, 2, { type: 'read' })).generation, 3);

    // The host's “back” leads where it led before.
    const length = await page.evaluate(() => history.length);
    await within(page, 0, async () => {
      await page.click('#run');
      await page.until('it evolves', () => Number(document.getElementById('generation')?.innerText) > 3);
      await page.click('#run');
      await page.until('the address has followed', () => /generation=\d/.test(location.hash));
    });
    assert.equal(await page.evaluate(() => history.length), length);
  });
});

engineTest('the host sets experiments and reads what comes of them', async (page) => {
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

engineTest(
  'the full page opens with the run of the figure, and the figure fills the screen',
  async (page) => {
    const frames = [frameOf(page, 'lab&v=1&seed=7', 640, 420), frameOf(page, 'lab', 640, 420, '')];
    await inHost(page, frames.join(''), async () => {
      const full = await within(page, 0, async () => {
        await page.click('#one-generation');
        await page.focus('#embed-full');
        return page.evaluate(() => {
          const { href, target, rel } = /** @type {HTMLAnchorElement} */ (
            document.getElementById('embed-full')
          );
          return { href, target, rel };
        });
      });
      assert.deepEqual(full, {
        href: `${page.site.address}#lab&v=1&seed=7&generation=1`,
        target: '_blank',
        rel: 'noopener',
      });
      assert.equal(
        await within(page, 1, () => page.evaluate(() => document.getElementById('embed-screen') !== null)),
        false,
        'no button for what the host has not allowed',
      );
      await within(page, 0, async () => {
        await page.click('#embed-screen');
        await page.until('the figure fills the screen', () => document.fullscreenElement !== null);
        await page.until('it says how to leave', () =>
          document.getElementById('embed-screen')?.getAttribute('aria-label')?.startsWith('Leave'),
        );
        await page.click('#embed-screen');
        await page.until('it has left the full screen', () => document.fullscreenElement === null);
      });
    });
  },
);

pageTest('the dialog writes a frame that shows the present state', async (page) => {
  await page.open('#landscape&v=1&seed=7&generation=5&x=ky');
  const wanted = await read(page);
  await page.click('#keep-button');
  await page.click('#embed-size-400x300');
  const text = await page.evaluate(
    () => /** @type {HTMLTextAreaElement} */ (document.getElementById('embed-text')).value,
  );
  assert.match(text, /^<iframe src="http:\/\/localhost:\d+\/some\/course\/ep\/\?embed#landscape&amp;v=1/);
  assert.match(text, /title="Evolving a robot’s controller: Landscape" width="400" height="300"/);
  await page.click('#embed-copy');
  await page.until('it says whether it was copied', () =>
    /copied|selected/.test(document.getElementById('keep-status')?.textContent ?? ''),
  );
  assert.deepEqual(await page.obstacles(), []);
  await inHost(page, text, async () => {
    const { link, experiment: shown, generation } = await ask(page, 0, { type: 'read' });
    assert.equal(link, 'landscape&v=1&seed=7&generation=5&x=ky');
    assert.equal(shown.evolution.seed, Number(wanted.seed));
    assert.equal(generation, 5);
  });
});

pageTest('nothing in a figure is in the way of assistive technology', async (page) => {
  for (const link of [...pageNames.map((name) => `${name}&v=1`), 'lesson&step=2']) {
    await page.open(`?embed#${link}`);
    await page.resize(640, 420);
    if (link.startsWith('disturbance'))
      await page.until('the errors are known', () => document.getElementById('remains-caption')?.textContent);
    assert.deepEqual(await page.obstacles(), [], link);
  }
});

engineTest('the one file is a figure too, from a disk', async (page) => {
  const folder = await mkdtemp(join(tmpdir(), 'host-'));
  try {
    const file = pathToFileURL(fileURLToPath(new URL('../../../dist/ep-locomotion.html', import.meta.url)));
    const html = `<!doctype html><title>Host</title><script>
        heard = []; addEventListener('message', ({ data }) => heard.push({ frame: 0, data }));
      </script><iframe src="${file}?embed#lab&amp;seed=7" width="640" height="420"></iframe>`;
    await writeFile(join(folder, 'host.html'), html);
    await page.visit(pathToFileURL(join(folder, 'host.html')).href);
    await page.until('the figure is ready', () =>
      /** @type {{ heard: import('../harness/host.js').Heard[] }} */ (
        /** @type {unknown} */ (window)
      ).heard.some(({ data }) => data.type === 'ready'),
    );
    const { hash } = await ask(page, 0, { type: 'step', generations: 20 });
    assert.equal(hash, evolve(experiment({ evolution: { seed: 7 } }), 20).hash);
  } finally {
    await rm(folder, { recursive: true });
  }
});
