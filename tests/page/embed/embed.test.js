// Figures in frames of another page: they fit, they leave the host alone, and they talk with it.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { addressOf } from '../../../www/kit/host.js';
import { wantedHeight } from '../../../www/embed/frame.js';
import { frameText } from '../../../www/embed/frame-line.js';
import { links } from '../../../www/lesson/links.js';
import { stepNames } from '../../../www/lesson/path.js';
import { named, pageNames, parts } from '../../../www/parts/parts.js';
import { engineTest, pageTest, patience } from '../harness/browsers.js';
import { evolve, experiment, historyOf } from '../harness/core.js';
import { ask, heardFrom, frameOf, inHost, within } from '../harness/host.js';
import { test } from '../harness/once.js';
import { read } from '../harness/reading.js';
import { clockOf, course } from './course.js';

test('the text of a frame says where, how large and what, and nothing in it ends a value', () => {
  const address = addressOf('https://host/ep/?lang=ko&embed#lab', 'lab&v=1&pin1=a"b<c', true);
  assert.equal(address, 'https://host/ep/?embed&lang=ko#lab&v=1&pin1=a%22b%3Cc');
  assert.equal(addressOf(address, 'curves', false), 'https://host/ep/?lang=ko#curves');
  assert.equal(
    addressOf('https://host/ep/?who=me&lang=ko#lab', 'lab&task=Park&who=s1', false),
    'https://host/ep/?lang=ko#lab&task=Park&who=s1',
  );
  assert.equal(addressOf('file:///home/me/ep.html', 'lab', true), 'file:///home/me/ep.html?embed#lab');
  // What programs that find addresses in a text leave out of them, or take for emphasis.
  assert.equal(
    addressOf('https://host/', 'lab&pin1=me~1,2,3&task=Park%20(all)!%20*Who*~', false),
    'https://host/#lab&pin1=me~1,2,3&task=Park%20%28all%29%21%20%2AWho%2A%7E',
  );
  for (const end of '.,;_')
    assert.match(addressOf('https://host/', `lab&task=it${end}`, false), /it%(2C|2E|3B|5F)$/);
  const text = frameText({ address, title: 'a "title" & <more>', width: 640, height: 420 });
  assert.equal(
    text,
    '<iframe src="https://host/ep/?embed&amp;lang=ko#lab&amp;v=1&amp;pin1=a%22b%3Cc" title="a &quot;title&quot; &amp; &lt;more&gt;" width="640" height="420" style="border: 0; max-width: 100%" loading="lazy" allow="fullscreen; clipboard-write"></iframe>',
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
      assert.ok(heights[0] >= (lesson > 0 ? 640 : 300) && heights[5] <= 720, `${page}: ${heights}`);
    }
});

test('what a link says, every part and every step stand in the documents', async () => {
  const [readme, embedding, exercises] = await Promise.all(
    ['README.md', 'docs/embedding.md', 'docs/exercises.md'].map((name) =>
      readFile(new URL(`../../../${name}`, import.meta.url), 'utf8'),
    ),
  );
  const [listed] = embedding.match(/Parts are [^;]*/) ?? [''];
  for (const name of pageNames) {
    const line = `- **${named[name].name}**`;
    assert.ok(readme.includes(line), `README.md has no line “${line}” that says what ${name} is`);
    assert.ok(listed.includes(`\`${name}\``), `docs/embedding.md does not list ${name}`);
  }
  const [steps] = embedding.match(/Steps have names: [^.]*/) ?? [''];
  for (const name of stepNames)
    assert.ok(steps.includes(`\`${name}\``), `docs/embedding.md does not list the step ${name}`);
  const told = [...`${embedding}\n${exercises}`.matchAll(/^\|([^|]*)\|/gm)].map(([, keys]) => keys).join();
  // Of four pins the table names the first and the last.
  for (const { key } of links.keys.filter((one) => !/^pin[23]$/.test(one.key)))
    assert.ok(told.includes(`\`${key}\``), `no table of docs/ says what ${key} is`);

  // A key of a part that takes certain words only says which, where it refuses another.
  for (const { key, slice, read } of parts.flatMap((part) => part.keys ?? [])) {
    const row = embedding.split('\n').find((line) => line.split('|')[1]?.includes(`\`${key}\``));
    const opened = /** @type {any} */ ({ parts: { [slice.name]: slice.first } });
    const words = wordsOf(() => read(opened, 'unheard-of', /** @type {any} */ (null)));
    const told = row?.split(/[^\w.-]+/) ?? [];
    for (const word of words)
      assert.ok(told.includes(word), `docs/embedding.md does not say that ${key} may be ${word}`);
    if (key === 'phase') assert.equal(words.length, 6);
  }
});

/** The words of which one is asked for. @param {() => unknown} ask @returns {string[]} */
function wordsOf(ask) {
  try {
    ask();
  } catch (error) {
    return /one of (.*), but was/.exec(String(error))?.[1].split(', ') ?? [];
  }
  return [];
}

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
          patience,
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

pageTest('a figure that is used has its keys, tells each generation, and is alone in it', async (page) => {
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

/** In a figure. Firefox and Safari need no leave for it, and tell of none. */
const mayCopy = () => Reflect.get(document, 'featurePolicy')?.allowsFeature('clipboard-write') !== false;

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
    assert.ok(await within(page, 0, () => page.evaluate(mayCopy)));
  });
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
