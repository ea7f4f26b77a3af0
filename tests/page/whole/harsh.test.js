// Where a page is not at ease: without storage or an origin, out of sight, in another country, for a very long time.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { fileURLToPath } from 'node:url';
import { createAccumulator, createFrameLoop } from '../../../www/kit/loop.js';
import { engineTest } from '../harness/browsers.js';
import { inHost, within } from '../harness/host.js';
import { test } from '../harness/once.js';

engineTest('a frame without an origin, where all storage is forbidden, drives and computes', async (page) => {
  const file = '/dist/ep-locomotion.html?embed#landscape&v=1&seed=7';
  const html = `<iframe sandbox="allow-scripts" src="${file}" width="1000" height="800"></iframe>`;
  await inHost(page, html, async () => {
    await within(page, 0, async () => {
      const refused = await page.evaluate(() => {
        /** @param {() => unknown} look */
        const nameOfError = (look) => {
          try {
            look();
          } catch (error) {
            return error instanceof DOMException ? error.name : String(error);
          }
        };
        return [() => localStorage, () => sessionStorage, () => document.cookie].map(nameOfError);
      });
      assert.deepEqual(refused, Array(3).fill('SecurityError'));
      await page.until('the workers have computed the landscape', () =>
        /drives in \d/.test(document.getElementById('landscape-note')?.innerText ?? ''),
      );
    });
  });
});

/** @typedef {{ generation: number, time: number }} Seen */
/** @typedef {{ seen: Seen[] }} Watched */

engineTest(
  'out of sight nothing moves, in sight again nothing catches up; resets leave nothing behind',
  async (page) => {
    // The others' drivers show every window at once, or draw once a second what is hidden; an engine without its browser hides none.
    if (page.engine !== 'chromium') return;
    await page.open();
    await page.evaluate(() => {
      /** @type {Seen[]} */
      const seen = [];
      const text = (/** @type {string} */ id) => document.getElementById(id)?.textContent ?? '';
      const look = () =>
        seen.push({ generation: Number(text('generation')), time: Number.parseFloat(text('clock')) });
      Object.assign(window, { seen });
      document.addEventListener('visibilitychange', () => {
        look();
        // After the first frame of the page that has a time before it.
        if (!document.hidden) requestAnimationFrame(() => requestAnimationFrame(look));
      });
    });
    await page.click('#run');
    const own = await page.driver.getWindowHandle();
    await page.driver.switchTo().newWindow('tab');
    await page.until('some time is over', () => performance.now() > 1500);
    await page.driver.close();
    await page.driver.switchTo().window(own);
    const [hidden, shown, after] = await page.until('it is in sight again', () => {
      const { seen } = /** @type {Watched} */ (/** @type {unknown} */ (window));
      return seen.length === 3 && seen;
    });
    assert.deepEqual(shown, hidden, 'something moved out of sight');
    // A frame makes up for a quarter of a second, not for more: here with eight generations a second, at most twice.
    assert.ok(after.generation - shown.generation <= 5, JSON.stringify({ shown, after }));
    assert.ok(after.time - shown.time <= 0.51, JSON.stringify({ shown, after }));

    await page.click('#run');
    const elements = await page.evaluate(async () => {
      const press = (/** @type {string} */ id) => document.getElementById(id)?.click();
      const counts = [];
      for (let reset = 1; reset <= 100; reset += 1) {
        for (const id of ['one-generation', 'reset']) press(id);
        if (reset % 25 > 0) continue;
        await new Promise((resolve) => requestAnimationFrame(() => requestAnimationFrame(resolve)));
        counts.push(document.querySelectorAll('*').length);
      }
      return counts;
    });
    assert.deepEqual(elements, Array(4).fill(elements[0]));
  },
  { moves: true },
);

test('a frame after an hour without one makes up for a quarter of a second', (t) => {
  /** @type {((now: number) => void)[]} */
  const due = [];
  const { requestAnimationFrame: before } = globalThis;
  globalThis.requestAnimationFrame = (callback) => due.push(callback);
  t.after(() => {
    globalThis.requestAnimationFrame = before;
  });
  /** @type {number[]} */
  const frames = [];
  const loop = createFrameLoop((seconds) => frames.push(seconds) > 0);
  loop.request();
  for (const now of [1000, 1016, 3_601_016, 3_601_032]) due.shift()?.(now);
  assert.deepEqual(frames, [0, 0.016, 0.25, 0.016]);
  const { take } = createAccumulator();
  assert.deepEqual(
    frames.map((seconds) => take(seconds, 60)),
    [0, 0, 15, 1],
  );
});

/** A run, what is saved of it and what is said of it, by a process of its own. @param {Record<string, string>} env */
function runIn(env) {
  const script = `
    const { liveOf } = await import('../lesson/live.js');
    const { stability, Evolution } = await import('../harness/core.js');
    const { driveCsv, generationsCsv } = await import('../../../www/share/csv.js');
    const { links } = await import('../../../www/lesson/links.js');
    const { lab } = await import('../../../www/words/index.js');
    const { engine, state, scene, gains } = liveOf('lab&seed=7&generation=30&start=0.1,-1.25,30deg&drives=hand&gains=3.5,0.1,1234.5');
    const evolution = new Evolution(state.experiment);
    for (let i = 0; i < 30; i++) evolution.step();
    console.log(JSON.stringify({
      locale: new Intl.NumberFormat().resolvedOptions().locale,
      offset: new Date(2026, 0).getTimezoneOffset(),
      run: [
        evolution.hash(),
        generationsCsv(state, ['origin']),
        driveCsv(scene.driving, stability(scene.experiment, gains), ['origin']),
        links.linkOf(state, engine.experiment),
        lab.costText(12.5), lab.grouped(118098), lab.numberOf('1234,5'),
      ],
    }));`;
  return printedBy(script, env);
}

/** What a script prints, by a process of its own. @param {string} script @param {Record<string, string>} [env] */
function printedBy(script, env = {}) {
  const cwd = fileURLToPath(new URL('.', import.meta.url));
  const args = ['--expose-gc', '--input-type=module', '-e', script];
  return JSON.parse(
    execFileSync(process.execPath, args, { cwd, env: { ...process.env, ...env } }).toString(),
  );
}

test('neither the language of the machine nor its time zone changes a number, a table or a link', () => {
  const here = runIn({ TZ: 'UTC', LC_ALL: 'en_US.UTF-8' });
  const there = runIn({ TZ: 'Pacific/Apia', LC_ALL: 'ar_EG.UTF-8' });
  assert.notEqual(here.locale, there.locale);
  assert.notEqual(here.offset, there.offset);
  assert.deepEqual(there.run, here.run);
});

test('a long evolution keeps little of each generation, and of an evolution that is over nothing stays', () => {
  // Nobody else has left anything there.
  const { before, once, twice } = printedBy(`
    const { Evolution, experiment, memory } = await import('../harness/core.js');
    const sizes = () => {
      gc();
      return { core: memory.buffer.byteLength, heap: process.memoryUsage().heapUsed };
    };
    const long = () => {
      const evolution = new Evolution(experiment('velocity-limits'));
      for (let i = 0; i < 5000; i += 1) evolution.step();
      evolution.free();
      for (let reset = 0; reset < 200; reset += 1) new Evolution(experiment('velocity-limits')).free();
    };
    const before = sizes();
    long();
    const once = sizes();
    long();
    console.log(JSON.stringify({ before, once, twice: sizes() }));`);
  // A vector that grows may be there twice.
  assert.ok(once.core - before.core < 5000 * 2000, `${once.core - before.core} bytes in the core`);
  assert.equal(twice.core, once.core);
  assert.ok(twice.heap - once.heap < 1e6, `${twice.heap - once.heap} bytes in JavaScript`);
});
