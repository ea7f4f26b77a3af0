import assert from 'node:assert/strict';
import { Key, pageTest } from '../harness/browsers.js';
import { Evolution, evolve, experiment } from '../harness/core.js';
import { readEvolution, seedOne } from '../harness/reading.js';

/** @typedef {import('../harness/browsers.js').Page} Page */

const velocityLimits = experiment('velocity-limits');

/** Presses a button by the keyboard. @param {Page} page @param {string} id @param {number} times */
async function press(page, id, times) {
  await page.focus(`#${id}`);
  await page.press(...Array(times).fill(Key.ENTER));
}

/** Waits until evolution has gone on and stopped by itself. @param {Page} page */
const rests = (page) =>
  page.until('evolution rests', () => {
    const text = (/** @type {string} */ id) => document.getElementById(id)?.textContent;
    return text('generation') !== '0' && text('run') === 'Run';
  });

/** Chooses an option as a person would by the keyboard. @param {Page} page @param {string} id @param {string} text */
const choose = (page, id, text) =>
  page.evaluate(
    (select, wanted) => {
      const element = /** @type {HTMLSelectElement} */ (document.getElementById(select));
      element.value = [...element.options].find((option) => option.text === wanted)?.value ?? wanted;
      element.dispatchEvent(new Event('change'));
    },
    id,
    text,
  );

/** Types over the value at which evolution pauses. @param {Page} page @param {...string} keys */
async function typeUntil(page, ...keys) {
  await page.until('the field is there', () => document.getElementById('until-value')?.hidden === false);
  await page.focus('#until-value');
  await page.press(...keys);
}

pageTest(
  'generations go back and forward to what they were, and evolution goes on from there',
  async (page) => {
    // Where there is one generation only, nothing is to be moved.
    await page.focus('#timeline');
    await page.press(Key.END, Key.ARROW_RIGHT);
    assert.deepEqual(await readEvolution(page), seedOne(0));
    const thumb = () => page.evaluate(() => Reflect.get(document.getElementById('timeline') ?? {}, 'value'));
    assert.deepEqual([await thumb(), await page.problems(), await page.text('#message')], ['0', [], '']);
    await press(page, 'one-generation', 8);
    assert.deepEqual(await readEvolution(page), seedOne(8));
    await press(page, 'one-back', 3);
    assert.deepEqual(await readEvolution(page), seedOne(5));
    await page.focus('#timeline');
    await page.press(Key.HOME);
    assert.deepEqual(await readEvolution(page), seedOne(0));
    await page.press(Key.ARROW_RIGHT, Key.ARROW_RIGHT);
    assert.deepEqual(await readEvolution(page), seedOne(2));
    await page.press(Key.END);
    assert.deepEqual(await readEvolution(page), seedOne(8));
    await press(page, 'one-back', 1);
    await press(page, 'one-generation', 3);
    assert.deepEqual(await readEvolution(page), seedOne(10));
  },
);

pageTest('evolution stops at the first J below the one that is asked for', async (page) => {
  const evolution = new Evolution(velocityLimits);
  let generation = 0;
  while (evolution.statistics().best.cost >= 7.9) {
    evolution.step();
    generation += 1;
  }
  await choose(page, 'until', 'until J is below');
  await typeUntil(page, '7', '.', '9', Key.ENTER);
  await choose(page, 'pace', '60 gen/s');
  await page.click('#run');
  await rests(page);
  assert.deepEqual(await readEvolution(page), seedOne(generation));
  const { cost } = evolution.statistics().best;
  const said = `Paused at generation ${generation}: J ${cost.toFixed(3)} is below 7.9.`;
  assert.equal(await page.text('#evolution-note'), said);
  await choose(page, 'pace', 'fastest');
  await page.click('#run');
  await page.until('it goes on', () => document.getElementById('generation')?.textContent === '100');
  assert.deepEqual(await readEvolution(page), seedOne(100));
});

pageTest(
  'where to stop is refused in sight when it is no number, and the last good one stays',
  async (page) => {
    await choose(page, 'until', 'until generation');
    await page.focus('#until-value');
    await page.press('x', Key.ENTER);
    const message = await page.until('it says why', () => document.getElementById('until-error')?.innerText);
    assert.match(message, /generation.*whole number from 1.*x/);
    // A link that is opened over it takes away both.
    await page.evaluate(() => {
      location.hash = 'lab&v=1&seed=3';
    });
    await page.until(
      'the message is gone',
      () =>
        document.getElementById('until-error')?.hidden &&
        /^\d+$/.test(/** @type {HTMLInputElement} */ (document.getElementById('until-value')).value),
    );
    await page.press('x', Key.ENTER);
    await page.until('it says why again', () => document.getElementById('until-error')?.innerText);
    await choose(page, 'until', 'pause every 100');
    await page.until('the message is gone', () => document.getElementById('until-error')?.hidden);
  },
);

/** From now on every phase that is shown is noted. @param {Page} page */
const notePhases = (page) =>
  page.evaluate(() => {
    /** @type {string[]} */
    const phases = [];
    const note = () => {
      const title = document.getElementById('generation-title')?.textContent;
      const phase = /** @type {HTMLInputElement | null} */ (
        document.querySelector('#generation-phases input:checked')
      )?.value;
      const now = `${title}: ${phase}`;
      // The part may still be on its way.
      if (document.body.dataset.open === 'generation' && phase && phases.at(-1) !== now) phases.push(now);
      requestAnimationFrame(note);
    };
    note();
    Object.assign(window, { phases });
  });

/** Waits until a phase was shown; returns all that were up to it, for a slow driver may hear of it late. @param {Page} page @param {string} last */
const phasesUntil = (page, last) =>
  page.until(
    `${last} is shown`,
    (phase) => {
      const { phases } = /** @type {{ phases: string[] }} */ (/** @type {unknown} */ (window));
      return phases.includes(phase) && phases.slice(0, phases.indexOf(phase) + 1);
    },
    last,
  );

/** What the page says of its run: how far it is, and its hash. @param {Page} page */
async function fingerprint(page) {
  await page.click('#keep-button');
  const text = await page.text('#keep-status');
  await page.click('#keep-close');
  return text;
}

pageTest('one phase at a time Run plays the generations, and comes to the same', async (page) => {
  await page.setPace(6);
  await choose(page, 'until', 'until generation');
  await typeUntil(page, '1', Key.ENTER);
  await choose(page, 'pace', 'one phase at a time');
  await notePhases(page);
  await page.click('#run');
  await page.until('the part is open', () => document.body.dataset.open === 'generation');
  await phasesUntil(page, 'Generation 1: parents');
  const first = [
    'Generation 0: parents',
    'Generation 0: survivors',
    ...['parents', 'mutation', 'drive', 'tournament', 'ranking', 'survivors'].map(
      (phase) => `Generation 1: ${phase}`,
    ),
  ];
  assert.deepEqual(await phasesUntil(page, 'Generation 1: survivors'), first);
  await page.until('it rests', () => document.getElementById('run')?.textContent === 'Run');
  assert.match(await fingerprint(page), new RegExp(evolve(velocityLimits, 1).hash));

  // Over what it was told to stop at, until it is paused: by the button, by leaving, or by a step by hand.
  await page.click('#run');
  assert.deepEqual(await phasesUntil(page, 'Generation 2: parents'), [...first, 'Generation 2: parents']);
  await page.click('#generation-next');
  assert.equal(await page.text('#run'), 'Run');
  await page.click('#run');
  await phasesUntil(page, 'Generation 2: drive');
  await page.click('#page-lab');
  assert.equal(await page.text('#run'), 'Run');
  const paused = await readEvolution(page);
  // The phases go on until they are left, on a busy machine into a later generation.
  const generation = Number(paused.generation);
  assert.ok(generation >= 2);
  assert.deepEqual(paused, seedOne(generation));
  await page.click('#one-generation');
  assert.deepEqual(await readEvolution(page), seedOne(generation + 1));
  assert.match(await fingerprint(page), new RegExp(evolve(velocityLimits, generation + 1).hash));
});

pageTest('the pace is changed while evolution runs, also in the generation part', async (page) => {
  await choose(page, 'pace', '1 gen/s');
  await page.click('#run');
  await page.until('generation 1', () => document.getElementById('generation')?.textContent !== '0');
  await notePhases(page);
  await choose(page, 'pace', 'one phase at a time');
  await page.until('the part is open', () => document.body.dataset.open === 'generation');
  const [shown] = await page.until('a phase is shown', () => {
    const { phases } = /** @type {{ phases: string[] }} */ (/** @type {unknown} */ (window));
    return phases.length > 1 && phases;
  });
  assert.match(shown, /^Generation [1-9]\d*: parents$/);
  assert.equal(await page.text('#run'), 'Pause');
  await choose(page, 'pace', 'fastest');
  await page.until('evolution rests', () => document.getElementById('run')?.textContent === 'Run');
  assert.equal(await page.text('#generation-title'), 'Generation 100');
  assert.match(await fingerprint(page), new RegExp(evolve(velocityLimits, 100).hash));
});

pageTest('from the phases that Run plays, "back" leads to where it was pressed', async (page) => {
  await choose(page, 'pace', 'one phase at a time');
  await page.click('#run');
  await page.until('the part is open', () => document.body.dataset.open === 'generation');
  await page.until('its address is there', () => location.hash.startsWith('#generation'));
  assert.equal(await page.text('#run'), 'Pause');
  await page.driver.navigate().back();
  await page.until('the lab is open', () => document.body.dataset.open === 'lab');
  assert.equal(await page.text('#run'), 'Run');
  assert.deepEqual(await readEvolution(page), seedOne(0));
});

pageTest(
  'what runs on beside Park is paused in the head, also where the lab was never seen',
  async (page) => {
    await page.open('#lab&v=1');
    await choose(page, 'pace', '1 gen/s');
    // Nothing has evolved that would have to be caught up with.
    await page.setPace(0.01);
    await page.click('#run');
    await page.click('#page-park');
    const canPause = () => document.getElementById('pause-evolution')?.checkVisibility();
    await page.until('it can be paused', canPause);
    // The page is loaded again, and goes on.
    await page.click('#language');
    await page.until('it is Korean', () => document.documentElement.lang === 'ko');
    await page.until('it can be paused', canPause);
    await page.click('#pause-evolution');
    await page.until('it is', () => document.getElementById('pause-evolution')?.hidden);
  },
);
