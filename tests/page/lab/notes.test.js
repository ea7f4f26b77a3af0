// What the pictures and the gains say to who cannot see them.
import assert from 'node:assert/strict';
import { evolutionNote } from '../../../www/lab/draw.js';
import { lastGeneration } from '../../../www/run/pace.js';
import { Key, pageTest } from '../harness/browsers.js';
import { evolve, experiment, shown, simulate } from '../harness/core.js';
import { hears } from '../harness/heard.js';
import { test } from '../harness/once.js';
import { arrival, read } from '../harness/reading.js';
import { pageOf } from '../run/page-of.js';

const velocityLimits = experiment('velocity-limits');

/** What is said of the plane and of the curve now, and whether the robots drive. @param {import('../harness/browsers.js').Page} page */
const said = (page) =>
  page.evaluate(() => ({
    plane: document.getElementById('plane-text')?.textContent ?? '',
    curve: document.getElementById('curve')?.getAttribute('aria-label') ?? '',
    drives: document.querySelector('#play.playing') !== null,
  }));

pageTest('what is said of the pictures is true also while robots drive', async (page) => {
  await arrival(page);
  await page.setPace(0.01);
  await page.click('#play');
  await page.focus('#one-generation');
  await page.press(Key.ENTER, Key.ENTER, Key.ENTER);
  const third = await said(page);
  assert.ok(third.drives);
  assert.match(third.plane, /best of generation 3\b/);
  assert.doesNotMatch(third.plane, /Shown at/);
  assert.ok(
    third.curve.includes('over 3 generations') && third.curve.includes(evolve(velocityLimits, 3).median),
  );

  await page.focus('#slider-kx');
  await page.press(Key.ARROW_RIGHT);
  assert.match((await said(page)).plane, /Driving: your gains/);
  await page.focus('#scrub');
  await page.press(Key.END);
  assert.match((await said(page)).plane, /Shown at ([\d.]+) of \1 s/);
});

pageTest('a gain that is moved by keys is told with its J, once it stands', async (page) => {
  await page.focus('#slider-kx');
  await page.press(...Array(5).fill(Key.ARROW_RIGHT));
  const gains = /** @type {[number, number, number]} */ ((await read(page)).gains.map(Number));
  const { cost, finalTime } = simulate(velocityLimits, gains);
  // Where keys come slowly, what stood between them is told too.
  await hears(page, `^J ${shown(cost.total)}, arrives after ${finalTime.toFixed(2)} s$`);
});

pageTest('what evolution pauses at is told, and how what was chosen drives', async (page) => {
  await page.open('#lab&v=1&generation=99');
  await page.click('#run');
  const { shown: best } = evolve(velocityLimits, 100);
  await hears(
    page,
    `^Generation 100: best J ${best.cost}[.] Paused at generation 100[.] Press Run to go on[.]$`,
  );
  await page.click('#drives-paper-arbitrary');
  await hears(page, `^J ${shown(simulate(velocityLimits, [10, 10, 10]).cost.total)}, arrives`);
  await page.click('#one-back');
  await hears(page, `^Generation 99: best J ${evolve(velocityLimits, 99).shown.cost}$`);
  await page.click('#drives-evolved');
  await hears(page, '^J [0-9.]+, arrives');
});

test('where evolution pauses Run is named, but not at the last generation', () => {
  const state = pageOf('lab&generation=100').store.get();
  const pausedAt = (/** @type {number} */ generation) => {
    const history = Array(generation).fill(state.history[0]);
    return evolutionNote({
      ...state,
      generation,
      history: [...history, { ...state.history[100], generation }],
    });
  };
  assert.match(pausedAt(lastGeneration - 100), /^Paused at generation 99900\. Press Run/);
  assert.match(pausedAt(lastGeneration), /drives so far took the best J from/);
});
