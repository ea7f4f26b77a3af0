// The workers in real browsers: on the served site, and in the one file that is opened from a disk.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, stat, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { after } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';
import { build } from 'vite';
import { engineTest } from '../harness/browsers.js';
import { evolve, experiment, landscape } from '../harness/core.js';
import { onceOnly } from '../harness/once.js';
import { checked, read } from '../harness/reading.js';
import { serve } from '../harness/server.js';

/** @typedef {import('../../../www/core/engine.js').Engine} Engine */
/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {Window & { engine: Engine, collectedProblems: string[] }} EngineWindow */

const productFile = fileURLToPath(new URL('../../../dist/ep-locomotion.html', import.meta.url));
const velocityLimits = experiment('velocity-limits');
const map = {
  x: { gain: /** @type {const} */ ('kx'), from: 0.1, to: 10, count: 40, log: true },
  y: { gain: /** @type {const} */ ('ktheta'), from: 0, to: 10, count: 40 },
  gains: [3, 0.1, 5],
};
const expectedMap = [...landscape(velocityLimits, map)].map(String);

const folder = await mkdtemp(join(tmpdir(), 'ep-locomotion-'));
after(() => rm(folder, { recursive: true }));

/** The engine without the page, built as the page is. @param {'production' | 'offline'} mode */
async function buildEngine(mode) {
  const outDir = join(folder, mode);
  await build({
    configFile: fileURLToPath(new URL('../../../.tasks/vite.config.js', import.meta.url)),
    root: fileURLToPath(new URL('surveys/', import.meta.url)),
    mode,
    logLevel: 'warn',
    build: { outDir, emptyOutDir: false },
  });
  return outDir;
}
const builds = {
  served: onceOnly(() => buildEngine('production')),
  offline: onceOnly(() => buildEngine('offline')),
};

/** @param {Page} page @param {string} address */
async function openEngine(page, address) {
  await page.visit(address);
  await page.until('the engine is there', () => 'engine' in window);
}

/** Opens a copy of one file from the disk, with the collector of problems in it. @param {Page} page @param {string} file @param {(html: string) => string} [change] */
async function openFile(page, file, change = (html) => html) {
  // As the server adds them to what it sends.
  const scripts = ['collector.js', 'frames.js'].map(async (name) => {
    const script = await readFile(new URL(`../harness/${name}`, import.meta.url), 'utf8');
    return `<script>${script}</script>`;
  });
  const added = (await Promise.all(scripts)).join('');
  const copy = join(folder, 'opened.html');
  const html = (await readFile(file, 'utf8')).replace('<head>', () => `<head>${added}`);
  await writeFile(copy, change(html));
  await page.visit(`${pathToFileURL(copy).href}#lab`);
}

/** What the page asked for since it was opened, and what went wrong. @param {Page} page */
const traffic = (page) =>
  page.evaluate(() => ({
    requests: performance.getEntriesByType('resource').map(({ name }) => name),
    problems: /** @type {EngineWindow} */ (/** @type {unknown} */ (window)).collectedProblems,
  }));

/** A landscape and an evolution in the workers of the open page. @param {Page} page */
const survey = (page) =>
  page.evaluate(async (landscapeOf) => {
    const { engine } = /** @type {EngineWindow} */ (/** @type {unknown} */ (window));
    const preset = engine.experiment('velocity-limits');
    /** @type {number[]} */
    const told = [];
    const options = { onProgress: (/** @type {number} */ done) => told.push(done) };
    const [costs, evolved] = await Promise.all([
      engine.surveys.landscape(preset, landscapeOf, options),
      engine.surveys.evolve(preset, 20),
    ]);
    return { costs: Array.from(costs, String), hash: evolved.hash, told };
  }, map);

/** @param {Awaited<ReturnType<typeof survey>>} result */
function checkSurvey({ costs, hash, told }) {
  assert.deepEqual(costs, expectedMap);
  assert.equal(hash, evolve(velocityLimits, 20).hash);
  assert.deepEqual(
    told,
    [...told].sort((a, b) => a - b),
  );
  assert.equal(told.at(-1), 1);
}

engineTest('one, two and eight workers compute the same bits as Node', async (page) => {
  const site = await serve(await builds.served());
  try {
    for (const size of [1, 2, 8]) {
      await openEngine(page, site.address);
      // Asked for at the first survey.
      await page.evaluate((value) => {
        Object.defineProperty(navigator, 'hardwareConcurrency', { value });
      }, size);
      checkSurvey(await survey(page));
      const { requests, problems } = await traffic(page);
      assert.deepEqual([...problems, ...site.problems], []);
      assert.deepEqual(
        requests.filter((address) => !address.startsWith(new URL(site.address).origin)),
        [],
      );
    }
  } finally {
    await site.close();
  }
});

/** Runs an evolution, and ends its worker from elsewhere as soon as it is under way. @param {Page} page @param {number} generations */
const evolveDespite = (page, generations) =>
  page.evaluate(async (count) => {
    const { engine } = /** @type {EngineWindow} */ (/** @type {unknown} */ (window));
    /** @type {Worker[]} */
    const workers = [];
    const { Worker } = window;
    window.Worker = class extends Worker {
      /** @param {ConstructorParameters<typeof Worker>} parts */
      constructor(...parts) {
        super(...parts);
        workers.push(this);
        // It begins with that.
        if (workers.length === 1)
          this.addEventListener('message', ({ data }) => data.life && this.terminate());
      }
    };
    const preset = engine.experiment('velocity-limits');
    const { hash } = await engine.surveys.evolve(preset, count);
    window.Worker = Worker;
    return { hash, workers: workers.length };
  }, generations);

engineTest('work is ended, superseded, aborted and refused, and the workers go on', async (page) => {
  const site = await serve(await builds.served());
  try {
    await openEngine(page, site.address);
    const enough = 3000;
    assert.deepEqual(await evolveDespite(page, enough), {
      hash: evolve(velocityLimits, enough).hash,
      workers: 2,
    });
    const ends = await page.evaluate(async (landscapeOf) => {
      const { engine } = /** @type {EngineWindow} */ (/** @type {unknown} */ (window));
      const { surveys } = engine;
      const preset = engine.experiment('velocity-limits');
      /** @param {Promise<unknown>} promise */
      const end = (promise) =>
        promise.then(
          () => 'done',
          (error) => `${error.name}: ${error.message}`,
        );
      const channel = surveys.channel();
      const requests = [1, 2, 3].map(() => end(surveys.landscape(preset, landscapeOf, { channel })));
      const control = new AbortController();
      const onProgress = () => control.abort();
      const endless = end(surveys.evolve(preset, 1e7, { signal: control.signal, onProgress }));
      const refused = end(surveys.landscape({ ...preset, horizon: -1 }, landscapeOf));
      return Promise.all([...requests, endless, refused]);
    }, map);
    assert.deepEqual(ends.slice(0, 4), [
      'AbortError: A newer request took its place',
      'AbortError: A newer request took its place',
      'done',
      'AbortError: The job was aborted',
    ]);
    assert.match(ends[4], /^Error: horizon must be .* but was -1$/);
    checkSurvey(await survey(page));
    assert.deepEqual([...(await traffic(page)).problems, ...site.problems], []);
  } finally {
    await site.close();
  }
});

engineTest('one file from a disk computes in workers and asks nobody for anything', async (page) => {
  await openFile(page, join(await builds.offline(), 'ep-locomotion.html'));
  await page.until('the engine is there', () => 'engine' in window);
  checkSurvey(await survey(page));
  assert.equal(await page.evaluate(() => document.title), '</script><!--<script>');
  assert.deepEqual(await traffic(page), { requests: [], problems: [] });
});

engineTest('where workers are forbidden, a job says that they cannot be started', async (page) => {
  await openFile(page, join(await builds.offline(), 'ep-locomotion.html'), (html) =>
    html.replace('worker-src blob:', "worker-src 'none'"),
  );
  await page.until('the engine is there', () => 'engine' in window);
  const message = await page.evaluate(() => {
    const { engine } = /** @type {EngineWindow} */ (/** @type {unknown} */ (window));
    return engine.surveys.evolve(engine.experiment('velocity-limits'), 1).catch((error) => error.message);
  });
  assert.match(message, /^No worker can be started[.:].*worker-src/s);
});

engineTest('the whole page in one file from a disk drives, evolves and draws its landscape', async (page) => {
  const { size } = await stat(productFile);
  assert.ok(size <= 1.65e6, `the one file has ${size} bytes, of 1 650 000 that it may`);
  await openFile(page, productFile);
  await page.until('the page is ready', () => document.documentElement.dataset.ready === 'true');
  await page.click('#one-generation');
  const { generation, cost, gains } = await read(page);
  assert.deepEqual({ generation, cost, gains }, { generation: '1', ...evolve(velocityLimits, 1).shown });
  await page.evaluate(() => {
    location.hash = 'landscape';
  });
  await page.until('the workers have computed the landscape', () =>
    /drives in \d/.test(document.getElementById('landscape-note')?.innerText ?? ''),
  );
  await page.click('#keys-button');
  await page.click('#keys-checks');
  await checked(page);
  assert.match(await page.text('#checks-summary'), /^All \d+ checks passed/);
  assert.deepEqual(await traffic(page), { requests: [], problems: [] });
});
