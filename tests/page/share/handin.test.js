// Handing in: a receipt is made of what is on screen, and whoever opens it comes to the same.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { aimOf } from '../../../www/link/exercise.js';
import { measure } from '../../../www/share/handin/measure.js';
import words from '../../../www/share/handin/words/index.js';
import {
  exerciseId,
  exerciseLink,
  holds,
  isWhole,
  receiptOf,
  toldIn,
} from '../../../www/share/handin/receipt.js';
import { gainsOf } from '../../../www/run/drivers.js';
import { newWork } from '../../../www/run/state.js';
import { createEngine, evaluate, evolve, experiment, paper, simulate } from '../harness/core.js';
import { Key, pageTest } from '../harness/browsers.js';
import { frameOf, heardFrom, inHost, within } from '../harness/host.js';
import { test } from '../harness/once.js';
import { saved } from '../harness/saved.js';
import { serve } from '../harness/server.js';
import { holdWorkers, releaseWorkers } from '../harness/workers.js';

const engine = createEngine();
const tools = { engine, links, paper: paper() };

/** What the page holds once it has opened a link. @param {string} link */
async function opened(link) {
  const { opened: run, problems } = links.openLink(link, engine);
  assert.deepEqual(problems, [], link);
  const { parts, ...state } = run;
  const { population, statistics } = await engine.surveys.generation(state.experiment, state.generation);
  const history = Array.from({ length: state.generation + 1 }, () => statistics);
  return { ...state, slices: parts, population, history, work: newWork('') };
}

const exercise = 'lab&v=1&lock=postures,seed,settings&task=Park%20for%20less.&aim=J%3C8.1&points=9:0,7.75:10';
const byHand = '&drives=hand&gains=3.3,0.000069712345,4.5';

test('a receipt of gains by hand holds wherever it is opened, and says what the core comes to', async () => {
  const receipt = await receiptOf(tools, await opened(`${exercise}${byHand}&who=s4711`), {
    'drive.faster': { choice: 2, right: 2 },
    'law.sign': { choice: 0, right: 1 },
  });
  const { cost } = simulate(experiment('velocity-limits'), receipt.gains);
  assert.equal(receipt.cost, cost.total);
  assert.deepEqual(receipt.judged, {
    isMet: true,
    points: receipt.judged?.points,
    most: 10,
  });
  assert.equal(receipt.answers, 'drive.faster:2+,law.sign:0-');
  assert.match(receipt.link, /^[\w.,;=&%~-]+$/);

  const state = await opened(receipt.link);
  const told = toldIn(state.student.handin);
  assert.ok(told && isWhole(state, engine, links));
  assert.deepEqual([state.student.who, state.handGains, told.drives], ['s4711', receipt.gains, 0]);
  assert.ok(holds(told, await measure(engine, null, state.experiment, receipt.gains)));
  // A second receipt of the same is the same.
  assert.equal(
    (
      await receiptOf(tools, state, {
        'drive.faster': { choice: 2, right: 2 },
        'law.sign': { choice: 0, right: 1 },
      })
    ).link,
    receipt.link,
  );
});

test('a receipt of evolved gains names how they were found, and evolution finds them again', async () => {
  const link = 'lab&v=1&seed=7&generation=40&task=Evolve.&aim=J%3C8;drives%3C%3D1000';
  const receipt = await receiptOf(tools, await opened(link));
  const best = evolve(experiment({ evolution: { seed: 7 } }), 40);
  assert.deepEqual(receipt.gains, best.gains);
  assert.deepEqual(receipt.how, { driver: 'evolved', method: 'ep', seed: 7, generation: 40 });
  assert.equal(receipt.drives, 820);
  assert.equal(receipt.judged?.isMet, true);
  const { how, cost } = await receiptOf(tools, await opened(`${link}&evolution.method=de`));
  assert.deepEqual([how.method, Number.isFinite(cost)], ['de', true]);
  const state = await opened(link);
  const begun = performance.now() - 5 * 60_000;
  assert.equal((await receiptOf(tools, { ...state, work: { ...state.work, begun } })).minutes, 5);
  const over = await receiptOf(tools, await opened(link.replace('1000', '819')));
  assert.equal(over.judged?.isMet, false);
});

test('what was cut, changed or invented is known', async () => {
  const { link } = await receiptOf(tools, await opened(`${exercise}${byHand}&who=s4711`));
  for (const other of [link.slice(0, -1), link.replace('3.3', '3.4'), link.replace('s4711', 's4712')])
    assert.ok(!isWhole(await opened(other), engine, links), other);
  for (const nothing of [
    '',
    '1',
    '2~8~1/1~1~1~0~0~~0',
    '1~x~1/1~1~1~0~0~~0',
    '1~8~1~1~1~0~0~~0',
    '1~8~1/1~-1~1~0~0~~0',
    '<b>',
  ])
    assert.equal(toldIn(nothing), null, nothing);
  const told = toldIn('1~7.5~1/1~3~4~0.1.0~abcdef01~~00000000');
  assert.deepEqual([told?.cost, told?.drives, told?.minutes], [7.5, 3, 4]);
  assert.ok(told && !holds(told, { cost: 7.6, parked: 1, starts: 1, value: 7.6 }));
});

test('the exercise is the same for all who work on it, however they answer', async () => {
  const idOf = async (/** @type {string} */ link) =>
    exerciseId(exerciseLink(await opened(link), engine, links));
  const id = await idOf(exercise);
  for (const same of [
    `${exercise}${byHand}`,
    `${exercise}&generation=3&who=me`,
    exercise.replace('lab', 'landscape'),
  ])
    assert.equal(await idOf(same), id, same);
  for (const other of [
    `${exercise}&goal.x=1`,
    exercise.replace('8.1', '8.2'),
    exercise.replace('less', 'more'),
    `${exercise}&seed=2`,
  ])
    assert.notEqual(await idOf(other), id, other);
  // A seed that is not locked is the student's to choose.
  const free = exercise.replace('seed,', '');
  assert.equal(await idOf(`${free}&seed=2`), await idOf(free));
  const vary = `${exercise}&vary=goal,seed`;
  assert.equal(await idOf(`${vary}&who=a`), await idOf(`${vary}&who=b`));
});

test('what an aim wants is measured from its own starts', async () => {
  const own = experiment('velocity-limits');
  const gains = /** @type {const} */ ([3.2, 0.1, 5.2]);
  const of = (/** @type {string} */ aim, from = own) => measure(engine, aimOf(aim), from, gains);
  assert.deepEqual(await of('J<8'), {
    cost: evaluate(own, gains)[0],
    parked: 1,
    starts: 1,
    value: evaluate(own, gains)[0],
  });
  const circle = engine.startsOnCircle({ x: 2, y: 2, radius: 2.83, count: 32, seed: 1 });
  const arrived = circle.filter((start) => simulate(experiment({ starts: [start] }), gains).arrived).length;
  assert.ok(arrived > 0 && arrived < 32);
  assert.equal((await of('parks:28/32')).value, arrived);
  // An experiment with as many starts is the one that counts.
  const many = experiment({ starts: circle.slice(0, 5) });
  assert.deepEqual((await of('parks:1/5', many)).value, (await of('J<8', many)).parked);
  const { value } = await of('unseen:0.5');
  assert.ok(value > 0.05 && value < 0.95 && Number.isInteger(Math.round(1000 * value)));
  assert.equal((await of('J<8', many)).cost, evaluate(many, gains)[0]);
});

/** In the page: pauses evolution as soon as that can be pressed. */
const pausesAtOnce = `new MutationObserver((_, observer) => {
  const run = document.getElementById('run');
  if (run?.textContent !== 'Pause') return;
  observer.disconnect();
  run.click();
}).observe(document, { childList: true, characterData: true, subtree: true });`;

pageTest(
  'a receipt whose run is paused on its way is not called broken, and is judged once it is there',
  async (page) => {
    const { link } = await receiptOf(
      tools,
      await opened('lab&v=1&task=Evolve.&aim=J%3C8&generation=2000&who=s4711'),
    );
    const site = await serve(undefined, { before: pausesAtOnce });
    try {
      await page.visit(`${site.address}#${link}`);
      await page.until('what there is to do is there', () => document.getElementById('hand-in'));
      const generation = Number(await page.text('#generation'));
      assert.ok(generation > 0 && generation < 2000, `paused at ${generation}`);
      assert.equal(await page.evaluate(() => document.querySelectorAll('.work-said').length), 0);
    } finally {
      await page.leave();
      await site.close();
    }
    await page.open(`#${link}`);
    assert.match(
      await page.until('it is judged', () => document.querySelector('.work-said')?.textContent),
      /s4711/,
    );
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('what is still computed when the sheet is closed is not handed in', async (page) => {
  await inHost(page, frameOf(page, `${exercise}${byHand}&who=s4711`, 640, 420), async () => {
    const inFigure = (/** @type {() => Promise<void>} */ body) => within(page, 0, body);
    await inFigure(async () => {
      await page.until('its work is there', () => document.getElementById('hand-in'));
      await holdWorkers(page);
    });
    await page.evaluate(() =>
      document
        .querySelector('iframe')
        ?.contentWindow?.postMessage(
          { ep: 1, type: 'set', link: 'lab&v=1&population=2000&who=s4711&task=x' },
          '*',
        ),
    );
    await inFigure(async () => {
      await page.until('it computes', () => document.getElementById('computing')?.checkVisibility());
      await page.until('it can be handed in', () => document.getElementById('hand-in'));
      await page.click('#hand-in');
      await page.until('the sheet waits', () => document.getElementById('handin-status'));
      await page.click('#handin-close');
      await page.click('#computing button');
      await page.until('it has stopped', () => document.getElementById('computing')?.hidden);
      await releaseWorkers(page);
      await page.click('#hand-in');
      await page.until('the receipt is there', () => document.getElementById('handin-text'));
    });
    const handed = (await heardFrom(page, 0)).filter(({ type }) => type === 'handin');
    assert.equal(handed.length, 1);
  });
});

pageTest('whatever an aim wants is measured while one drives, with the gains as they are', async (page) => {
  for (const aim of [
    'aim=parks:28/32',
    'aim=parks:2/2&start=0,0,0;1,0,90deg',
    'aim=unseen:0.6',
    'aim=J<9&start=0,0,0;1,0,90deg',
  ]) {
    const link = `lab&v=1&task=Park.&${aim}`;
    await page.open(`#${link}`);
    for (const driver of /** @type {const} */ (['evolved', 'paper-ep'])) {
      await page.click(`#drives-${driver}`);
      const state = await opened(`${link}&drives=${driver}`);
      const { aim: asked } = state.exercise;
      const { value } = await measure(engine, asked, state.experiment, gainsOf(state, driver, paper()));
      const { wanted } = /** @type {NonNullable<typeof asked>} */ (asked);
      await page.until(
        `${aim}: ${driver} is measured`,
        (text) => document.querySelector('.aim:not(.late) .aim-value')?.textContent === text,
        words.valueText(wanted, value),
      );
    }
    assert.deepEqual(await page.problems(), [], aim);
  }
});

pageTest('a name stays that for which something is drawn, also with what nobody sees in it', async (page) => {
  await page.open(`#${exercise}&vary=goal&who=s47%E2%81%A311`);
  await page.until('it can be handed in', () => document.getElementById('hand-in'));
  await page.click('#hand-in');
  await page.until('the receipt is there', () => document.getElementById('handin-text'));
  await page.click('#handin-make');
  const link = await page.until(
    'it is there again',
    () => /** @type {HTMLInputElement | null} */ (document.getElementById('handin-link'))?.value,
  );
  assert.match(link, /&who=s47%E2%81%A311&handin=/);
  assert.deepEqual(await page.problems(), []);
});

pageTest('a receipt is one person’s: where the name is corrected it is made anew', async (page) => {
  await page.open(`#${exercise}${byHand}`);
  await page.until('it can be handed in', () => document.getElementById('hand-in'));
  await page.click('#hand-in');
  await page.until('it asks who', () => document.activeElement?.id === 'handin-who');
  await page.press(...'kim', Key.ENTER);
  await page.until('the receipt is there', () => document.getElementById('handin-text'));
  assert.equal(await page.text('#handin-status'), 'The receipt is made.');
  await page.press(...'berly');
  await page.until('it is none any more', () => !document.getElementById('handin-text'));
  await page.press(Key.ENTER);
  await page.until('there is another', () =>
    /Name: kimberly\n/.test(
      /** @type {HTMLTextAreaElement | null} */ (document.getElementById('handin-text'))?.value ?? '',
    ),
  );
  // Not every browser lets a page copy by itself.
  const [text, link, ...copied] = await page.evaluate(async () => {
    const texts = ['handin-text', 'handin-link'].map(
      (id) => /** @type {HTMLTextAreaElement} */ (document.getElementById(id)).value,
    );
    const writeText = async (/** @type {string} */ text) => void texts.push(text);
    Object.defineProperty(navigator, 'clipboard', { value: { writeText }, configurable: true });
    for (const id of ['handin-copy', 'handin-copy-link']) document.getElementById(id)?.click();
    await new Promise((resolve) => requestAnimationFrame(resolve));
    return texts;
  });
  assert.deepEqual(copied, [text, link]);
  assert.equal(await page.text('#handin-status'), 'Copied.');
  assert.equal(await saved(page, '#handin-save'), `${text}\n`);
  assert.deepEqual(await page.obstacles(), []);
  assert.deepEqual(await page.problems(), []);
});
