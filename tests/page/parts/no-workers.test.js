// Where no worker can be started the parts say so, wait for nothing, and try again when they are opened again.
import assert from 'node:assert/strict';
import { pageTest } from '../harness/browsers.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { samples } from './samples.js';
import { allowWorkers, blockWorkers } from '../harness/workers.js';
import * as disturbanceEn from '../../../www/parts/disturbance/words/en.js';
import * as disturbanceKo from '../../../www/parts/disturbance/words/ko.js';
import * as landscapeEn from '../../../www/parts/landscape/words/en.js';
import * as landscapeKo from '../../../www/parts/landscape/words/ko.js';
import { parts } from '../../../www/parts/parts.js';
import { createSurveyRequests } from '../../../www/parts/robustness/request.js';
import { robustnessSlice } from '../../../www/parts/robustness/state.js';
import * as robustnessEn from '../../../www/parts/robustness/words/en.js';
import * as robustnessKo from '../../../www/parts/robustness/words/ko.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../www/core/engine.js').Engine} Engine */
/** @typedef {import('../../../www/run/store.js').Store} Store */
/** @typedef {import('../../../www/parts/robustness/grid.js').Grid} Grid */
/** @typedef {import('../../../www/parts/robustness/request.js').Spec} Spec */

/** Of the parts that ask for workers when they are opened, what they say once it is computed. */
const ready = parts.flatMap(({ name }) => {
  const { computed } = samples[name];
  return computed ? [{ name, ...computed }] : [];
});

const failure = /This could not be computed: No worker can be started: (Error: )?blocked/;

/** What a part says, once a text stands in it, or in that place of it. @param {Page} page @param {string} name @param {string} wanted @param {string} [place] */
const said = (page, name, wanted, place = `section[data-page="${name}"]`) =>
  page.until(
    `${place} says ${wanted}`,
    (part, text, selector) =>
      document.querySelector(selector)?.textContent?.includes(text) &&
      /** @type {HTMLElement} */ (document.querySelector(`section[data-page="${part}"]`)).innerText,
    name,
    wanted,
    place,
  );

/** How many workers were wanted in vain. @param {Page} page @returns {Promise<number>} */
const refused = (page) =>
  page.evaluate(async () => {
    // After what comes of a failure was drawn.
    await pageFrames.settled();
    return /** @type {{ refused: number }} */ (/** @type {unknown} */ (window)).refused;
  });

pageTest('no other part asks for workers when it is opened', async (page) => {
  await page.open('#lab');
  await blockWorkers(page);
  for (const { name } of parts.filter((part) => !samples[part.name].computed)) {
    await page.click(`#page-${name}`);
    await page.until('it is open', (part) => document.querySelector(`section[data-page="${part}"]`), name);
    assert.equal(await refused(page), 0, `${name}: \`computed\` of tests/page/parts/samples/${name}.js`);
  }
});

for (const { name, place, text: wanted } of ready)
  pageTest(`${name} tries workers that could not be started again when it is opened again`, async (page) => {
    await page.open('#lab');
    await blockWorkers(page);
    await page.click(`#page-${name}`);
    const text = await said(page, name, 'blocked');
    assert.match(text, failure);
    assert.doesNotMatch(text, /the robots are driving …|: …/);
    const once = await refused(page);
    assert.ok(once > 0);
    assert.equal(await refused(page), once);

    // One more opening, one more time.
    await page.click('#page-lab');
    await page.click(`#page-${name}`);
    await page.until(
      'it was tried again',
      (count) => /** @type {{ refused: number }} */ (/** @type {unknown} */ (window)).refused >= count,
      2 * once,
    );
    assert.equal(await refused(page), 2 * once);

    await allowWorkers(page);
    await page.click('#page-lab');
    await page.click(`#page-${name}`);
    assert.doesNotMatch(await said(page, name, wanted, place), /blocked/);
  });

pageTest('Training waits for nothing after a cancel either', async (page) => {
  await page.open('#lab');
  await blockWorkers(page);
  await page.click('#page-training');
  await said(page, 'training', 'blocked');
  await allowWorkers(page);
  // At once, for it may soon have evolved.
  await page.evaluate(() => {
    const evolve = /** @type {HTMLElement} */ (document.getElementById('training-evolve'));
    evolve.click();
    evolve.click();
  });
  const { computed } = samples.training;
  assert.ok(computed);
  assert.doesNotMatch(
    await said(page, 'training', computed.text, computed.place),
    /blocked|the robots are driving …/,
  );
});

test('Robustness says no more that something failed once what it compares is there too', async () => {
  /** @type {Record<string, object>} */
  const slices = {};
  let isBlocked = true;
  const store = /** @type {Store} */ (
    /** @type {unknown} */ ({
      get: () => ({ slices }),
      keep: (/** @type {string} */ name, /** @type {object} */ slice) => {
        slices[name] = slice;
      },
    })
  );
  const surveys = {
    channel: () => null,
    /** @param {unknown} _ @param {Grid & { gains: number[] }} grid */
    async robustness(_, { x, y, headings, gains }) {
      if (isBlocked && gains[0] === 2) throw new Error('blocked');
      const count = x.count * y.count * headings;
      const [cost, finalTime] = [new Float64Array(count), new Float64Array(count)];
      return { cost, finalTime, arrived: new Uint8Array(count) };
    },
  };
  const requests = createSurveyRequests(/** @type {Engine} */ (/** @type {unknown} */ ({ surveys })), store);
  const [own, rival] = [1, 2].map(
    (kx) => /** @type {Spec} */ ({ experiment: experiment('velocity-limits'), gains: [kx, 1, 1], half: 4 }),
  );
  const seen = async () => {
    for (let frame = 0; frame < 5; frame += 1) {
      requests.follow(own, rival, false);
      await new Promise(setImmediate);
    }
    const { message, rival: found } = robustnessSlice.of(store.get());
    return { message, isThere: found !== null };
  };
  assert.deepEqual(await seen(), { message: 'blocked', isThere: false });
  isBlocked = false;
  requests.retry();
  assert.deepEqual(await seen(), { message: '', isThere: true });
});

test('what is said of a failure tells a last result from none', () => {
  for (const words of [landscapeEn, robustnessEn, disturbanceEn])
    assert.deepEqual(
      [true, false].map((kept) => /^This could not be computed: no$/.test(words.failed('no', kept))),
      [false, true],
    );
  for (const words of [landscapeKo, robustnessKo, disturbanceKo])
    assert.deepEqual(
      [true, false].map((kept) => /^계산하지 못했습니다: no$/.test(words.failed('no', kept))),
      [false, true],
    );
});
