// An aim within so many drives: what was driven counts on, whatever becomes of the page.
import assert from 'node:assert/strict';
import { links } from '../../../www/lesson/links.js';
import { withExercise } from '../../../www/link/link.js';
import { caughtUp, drivesOf, newWork } from '../../../www/run/state.js';
import { exerciseLink, receiptOf } from '../../../www/share/handin/receipt.js';
import { createTask, driveInLab, linkInLab } from '../../../www/parts/park/task.js';
import { experiment, paper, simulate } from '../harness/core.js';
import { Key, pageTest } from '../harness/browsers.js';
import { hears } from '../harness/heard.js';
import { test } from '../harness/once.js';
import { pageOf } from '../run/page-of.js';
import { engine, opened } from './hand-ins.js';

const tools = { engine, links, paper: paper() };
const free = 'lab&v=1&drives=hand&gains=3.3,0,4.5&task=Few.&aim=J%3C9';
const budget = free.replace('J%3C9', 'J%3C9;drives%3C%3D3');

test('a link says what was driven where so many drives are allowed, and nowhere else', async () => {
  for (const [link, tries, generation, said] of /** @type {const} */ ([
    [budget, 2, 0, 2],
    [budget, 0, 0, 0],
    [free, 2, 0, 0],
    // Evolution is asked again how many it took.
    [`${budget.replace('&drives=hand', '')}&generation=4`, 2, 4, 2],
  ])) {
    const state = await opened(link);
    const work = { ...newWork(''), tries };
    const written = links.linkOf({ ...state, generation, work }, experiment);
    const again = await opened(written);
    assert.equal(again.student.spent, said, written);
    assert.equal(/&spent=/.test(written), said > 0);
    // Neither the exercise nor what a lecturer makes of it has it.
    assert.doesNotMatch(exerciseLink({ ...state, work }, engine, links), /spent/);
  }
  // As Park leads into the lab, with a run of its own.
  const state = await opened(budget);
  assert.match(links.linkOf({ ...state, generation: 9 }, experiment), /&generation=9&/);
  assert.match(links.openLink(`${budget}&spent=-1`, engine).problems[0], /spent.*whole number/);
});

/** All that was driven on a page so far. @param {ReturnType<typeof pageOf>['store']} store */
const drivenOn = (store) => drivesOf({ ...store.get(), driver: 'hand' });

/** What is driven again for the link. @param {ReturnType<typeof pageOf>['store']} store */
function madeAgain(store) {
  const { history, generation } = store.get();
  return generation > 0 ? history[generation].evaluations : 0;
}

test('where nobody may evolve, the exercise as it was given has its generation again', () => {
  const { store, actions } = pageOf('lab&v=1&generation=5&lock=run&task=Few.&aim=J%3C8');
  const shown = () => [store.get().generation, store.get().population[0].cost];
  const given = shown();
  assert.equal(given[0], 5);
  for (const back of [actions.backToExercise, actions.undo]) {
    actions.changeSetting('goal.x', 1.5, false);
    assert.equal(store.get().generation, 0);
    back();
    assert.deepEqual(shown(), given);
  }
  // Where it may, evolution begins again.
  const free = pageOf('lab&v=1&generation=5&task=Few.&aim=J%3C8');
  free.actions.changeSetting('goal.x', 1.5, false);
  free.actions.backToExercise();
  assert.equal(free.store.get().generation, 0);
});

test('what was driven for generations counts on where a step of the lesson, or another run, is opened', () => {
  const { store, actions, open } = pageOf('lab&v=1&task=Few.&aim=J%3C8;drives%3C%3D400');
  for (let i = 0; i < 10; i += 1) actions.forward();
  const before = drivenOn(store);
  assert.ok(before > 100, `${before} drives`);
  for (const link of [links.linkOfStep(1), 'lab&v=1&seed=9']) {
    open(withExercise(link, store.get(), experiment));
    assert.equal(drivenOn(store), before, link);
  }
});

/** Catching up with generation 40, as after a reload, it has come to generation 4. @param {ReturnType<typeof pageOf>['store']} store */
function atGenerationFour(store) {
  const history = store.get().history.slice(0, 5);
  store.update({ history, generation: 4, evolving: true, catchingUp: { newest: 40, generation: 40 } });
}

test('the link of a run that is still made again counts none of that: who opens it makes it all', () => {
  const link = 'lab&v=1&generation=40&task=Few.&aim=J%3C8;drives%3C%3D4000&spent=5';
  const { store } = pageOf(link);
  atGenerationFour(store);
  assert.equal(links.linkOf(caughtUp(store.get()), experiment), link);
});

test('what is given up while it is made again, as after a reload, was driven all the same', () => {
  for (const giveUp of /** @type {((page: ReturnType<typeof pageOf>) => void)[]} */ ([
    ({ actions }) => actions.newSeed(),
    ({ actions }) => actions.reset(),
    ({ actions }) => actions.pauseEvolution(),
    ({ actions }) => actions.setPace(4),
    ({ actions }) => actions.showGeneration(0),
    ({ actions }) => actions.showGeneration(2),
    ({ actions }) => actions.choosePreset('acceleration-limits'),
    ({ open, store }) => open(withExercise(links.linkOfStep(1), store.get(), experiment)),
  ])) {
    for (const isPausedBefore of [false, true]) {
      const page = pageOf('lab&v=1&task=Few.&aim=J%3C8;drives%3C%3D4000&spent=5&generation=40');
      const { store, actions } = page;
      const before = drivenOn(store);
      assert.equal(before, 5 + 41 * 20);
      atGenerationFour(store);
      assert.equal(drivenOn(store), before);
      if (isPausedBefore) actions.pauseEvolution();
      giveUp(page);
      assert.equal(drivenOn(store), before, `${giveUp}`);
      assert.match(links.linkOf(store.get(), experiment), RegExp(`&spent=${before - madeAgain(store)}(&|$)`));
    }
  }
});

test('a try is from as many starts as there were then, whatever is set later', () => {
  const eight = Array.from({ length: 8 }, (_, i) => `${i},1,0`).join(';');
  const { store, actions } = pageOf(`lab&v=1&start=${eight}&task=Few.&aim=J%3C8;drives%3C%3D400`);
  for (let i = 0; i < 3; i += 1) {
    actions.driveGains([3 + i, 1, 5], 'hand');
    actions.driveAgain();
  }
  assert.equal(drivenOn(store), 24);
  actions.backToPreset();
  assert.equal(store.get().experiment.starts.length, 1);
  assert.equal(drivenOn(store), 24);
  actions.driveGains([4, 4, 4], 'hand');
  actions.driveAgain();
  assert.equal(drivenOn(store), 25);
  // The gains, then the preset.
  actions.undo();
  actions.undo();
  assert.equal(store.get().experiment.starts.length, 8);
  assert.equal(drivenOn(store), 25);
  assert.match(links.linkOf(store.get(), experiment), /&spent=25/);
});

test('what was evolved before one says who one is counts too', () => {
  const { store, actions } = pageOf('lab&v=1&vary=goal&task=Few.&aim=J%3C8;drives%3C%3D400');
  for (let i = 0; i < 10; i += 1) actions.forward();
  const before = drivenOn(store);
  actions.setWho('s1');
  assert.equal(store.get().history.length, 1);
  assert.equal(drivenOn(store), before);
});

test('what was driven in the lab counts on where Park leads there', () => {
  const { store, actions, open } = pageOf('lab&v=1&task=Few.&aim=J%3C8;drives%3C%3D4000');
  for (let i = 0; i < 10; i += 1) actions.forward();
  const before = drivenOn(store);
  const state = store.get();
  const run = driveInLab({ ...state, page: 'park' }, createTask(engine).experiment(1), [3, 1, 5]);
  open(linkInLab(state, { ...run, generation: 4 }, { engine, links }) ?? '');
  actions.showGeneration(0);
  assert.ok(store.get().history.length > 4);
  assert.equal(drivenOn(store), before + (store.get().history.at(-1)?.evaluations ?? 0));
});

test('a receipt that is opened counts on from what it says', async () => {
  const state = await opened(budget);
  const receipt = await receiptOf(tools, { ...state, work: { ...newWork(''), tries: 3 } });
  assert.deepEqual([receipt.drives, receipt.judged?.isMet], [3, true]);
  const again = await opened(receipt.link);
  const { spent } = again.student;
  const next = await receiptOf(tools, { ...again, work: { ...newWork('', 0, spent), tries: 1 } });
  assert.deepEqual([next.drives, next.judged?.isMet], [4, false]);
});

pageTest(
  'drives that were made are counted on after a reload, and a receipt is judged by its own',
  async (page) => {
    const drives = (/** @type {string} */ text) =>
      page.until(
        text,
        (wanted) => document.querySelector('.aim:not(.late) .aim-drives')?.textContent === wanted,
        text,
      );
    await page.open(`#${budget}`);
    await drives('0 of 3 drives');
    for (const digit of ['2', '4']) {
      await page.focus('#gain-kx');
      await page.evaluate(() => /** @type {HTMLInputElement} */ (document.activeElement).select());
      await page.press('3', '.', digit, Key.ENTER);
    }
    await drives('2 of 3 drives');
    await page.driver.navigate().refresh();
    await drives('2 of 3 drives');
    const four = await receiptOf(tools, { ...(await opened(budget)), work: { ...newWork(''), tries: 4 } });
    await page.open(`#${four.link}`);
    await page.until('it is checked', () => document.querySelector('.work-said'));
    await drives('4 of 3 drives');
    assert.match(await page.text('#aim'), /not met, too many drives/);
    // What is driven after it counts on.
    await page.click('#one-generation');
    await drives(`${4 + 40} of 3 drives`);
    // Of what was cut nobody knows what it was.
    await page.open(`#${four.link.replace('gains=3.3', 'gains=3.2')}`);
    await page.until('it is checked', () => document.querySelector('.work-said.bad'));
    assert.equal(await page.text('#aim'), 'J below 9, within 3 drives');
    assert.deepEqual(await page.problems(), []);
  },
);

pageTest('how the aim stands, and that the budget is spent, is said', async (page) => {
  await page.open(`#${budget.replace('drives%3C%3D3', 'drives%3C%3D2')}`);
  await page.until('the aim is judged', () => document.querySelector('.aim-drives'));
  await page.focus('#gain-ky');
  const drive = async (/** @type {string} */ ky) => {
    await page.press(...ky, Key.ENTER);
    await page.focus('#gain-kx');
    await page.focus('#gain-ky');
  };
  await drive('1');
  const { cost } = simulate(experiment('velocity-limits'), [3.3, 1, 4.5]);
  await hears(page, `(^|\\. )${cost.total < 9 ? '' : 'not yet '}met, 1 of 2 drives$`);
  await drive('0');
  await drive('0.1');
  await hears(page, 'not met, too many drives, 3 of 2 drives$');
});

pageTest('while generations are counted, what they come to is heard', async (page) => {
  await page.open('#lab&v=1&task=Few.&aim=J%3C5;drives%3C%3D4000');
  await page.until('the aim is judged', () => document.querySelector('.aim-drives'));
  // It pauses by itself in a generation that comes late enough.
  await page.setPace(0.2);
  await page.click('#run');
  await hears(page, '^Generation [1-9][0-9]*: best J');
  await page.click('#run');
  await hears(page, 'not yet met, [0-9]+ of 4000 drives$');
});
