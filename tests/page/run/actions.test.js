// What the controls do, without the controls.
import assert from 'node:assert/strict';
import { breathe } from '../../../www/kit/loop.js';
import { links } from '../../../www/lesson/links.js';
import { pageNames } from '../../../www/parts/parts.js';
import { noErrors } from '../../../www/run/first.js';
import { lastGeneration, pausesAt } from '../../../www/run/pace.js';
import { asked } from '../../../www/run/state.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('whatever it waits for, evolution pauses at the last generation that a link and a file can say, after which none comes', () => {
  const statistics = /** @type {any} */ ({ generation: lastGeneration, best: { cost: 8 } });
  for (const until of /** @type {const} */ ([
    { kind: 'every', value: 100 },
    { kind: 'generation', value: lastGeneration },
    { kind: 'cost', value: 7 },
  ])) {
    assert.ok(pausesAt(until, statistics), until.kind);
    assert.ok(!pausesAt(until, { ...statistics, generation: lastGeneration - 1 }), until.kind);
  }
  const { store, actions } = pageOf('lab');
  const history = Array(lastGeneration + 1).fill(store.get().history[0]);
  for (const ask of [actions.oneGeneration, actions.toggleEvolution]) {
    store.update({ history, generation: lastGeneration, message: '' });
    ask();
    actions.evolve(() => true);
    assert.deepEqual([store.get().generation, store.get().evolving], [lastGeneration, false]);
    assert.match(store.get().message, /^generation must be .* from 0 to 100000, not 100001$/);
  }
});

test('a generation to stop at is refused once it has passed, and beyond what a link can say', () => {
  const { store, actions } = pageOf('lab&generation=6');
  for (const text of ['6', '1', '0', '6.5', 'x', '', '100001', 'Infinity']) {
    actions.setUntil('generation', text);
    assert.match(store.get().untilError, /from 7 to 100000/, text);
    assert.equal(store.get().until.kind, 'every');
  }
  for (const text of ['7', '100000']) {
    actions.setUntil('generation', text);
    assert.deepEqual(
      [store.get().until, store.get().untilError],
      [{ kind: 'generation', value: Number(text) }, ''],
    );
  }
});

test('what was refused of the gains is gone with them when a link is opened', () => {
  const { store, actions, open } = pageOf('lab&drives=hand&gains=3,1,5');
  actions.typeGain(0, 'x');
  assert.match(store.get().gainErrors[0], /number/);
  open('lab&drives=hand&gains=3,1,4');
  assert.deepEqual(store.get().gainErrors, noErrors);
});

test('of what is typed a decimal comma and a minus sign are understood', () => {
  const { store, actions } = pageOf('lab&drives=hand&gains=3,1,5');
  actions.typeGain(0, '4,25');
  actions.typeGain(1, '−0.5');
  assert.deepEqual(store.get().handGains, [4.25, -0.5, 5]);
});

test('a start that a link tries is tried where one can be', () => {
  const start = { x: 2, y: 0, theta: 0 };
  assert.deepEqual(pageOf('robustness&from=2,0,0').store.get().trial.start, start);
  assert.equal(pageOf('curves&from=2,0,0').store.get().trial.start, null);
});

test('in every part a link tries what the link of what is on screen tries', () => {
  const { store, open } = pageOf('lab');
  for (const name of pageNames) {
    open(`${name}&v=1&from=2,0,0&under=slip,0.5,0.2,1`);
    const { trial } = store.get();
    open(links.linkOf(store.get(), experiment));
    assert.deepEqual(store.get().trial, trial, name);
  }
});

const usual = experiment('velocity-limits');
/** So many that they are computed elsewhere. */
const many = 2000;

test('what is changed while an experiment is being computed is changed in that one, each a step of undo', async () => {
  const { store, actions } = pageOf('lab');
  const told = () => {
    const { experiment: now, preset } = asked(store.get());
    const { evolution, weights, goal, limits } = now;
    return [evolution.population, weights.penalty, goal.x, goal.y, evolution.seed, preset, limits.speed];
  };
  const moments = [told()];
  for (const change of [
    () => actions.changeSetting('evolution.population', many, false),
    () => actions.changeSetting('weights.penalty', 10, false),
    () => actions.movePosture('goal', { ...actions.postureOf('goal'), x: 1 }, false),
    () => actions.movePosture('goal', { ...actions.postureOf('goal'), y: 1 }, false),
    () => actions.useSeed(7),
    () => actions.choosePreset('acceleration-limits'),
  ]) {
    change();
    moments.push(told());
    assert.equal(store.get().computing?.what, 'begin');
    assert.deepEqual(store.get().experiment, usual);
  }
  assert.deepEqual(moments.at(-1)?.slice(0, 6), [many, 10, 1, 1, 7, 'acceleration-limits']);
  await actions.whenIdle();
  assert.equal(store.get().computing, null);
  assert.equal(store.get().population.length, many);
  for (const moment of moments.toReversed()) {
    assert.deepEqual(told(), moment);
    actions.undo();
    await actions.whenIdle();
  }
  assert.deepEqual(store.get().experiment, usual);
});

test('what is set back while it is being computed is back', async () => {
  const { store, actions } = pageOf('lab');
  actions.changeSetting('evolution.population', many, false);
  actions.changeSetting('evolution.population', usual.evolution.population, false);
  await actions.whenIdle();
  assert.deepEqual([store.get().experiment, store.get().computing], [usual, null]);
});

test('a drag is one step of undo, however much of it is still being computed when it ends', async () => {
  for (const waits of [[], [0], [1], [0, 1, 2]]) {
    const { store, actions } = pageOf('lab');
    for (const [i, population] of [many - 2, many - 1, many].entries()) {
      actions.changeSetting('evolution.population', population, true);
      if (waits.includes(i)) await actions.whenIdle();
      assert.ok(asked(store.get()).dragging);
    }
    actions.releaseSetting();
    assert.ok(!asked(store.get()).dragging);
    await actions.whenIdle();
    const { experiment: now, versions, dragging } = store.get();
    assert.deepEqual([now.evolution.population, versions.past.length, dragging], [many, 1, false]);
    actions.undo();
    assert.deepEqual(store.get().experiment, usual);
  }
});

test('Run, Pause and one generation are of the experiment that is being computed', async () => {
  const { store, actions } = pageOf('lab');
  const began = async () => {
    await actions.whenIdle();
    const { experiment: now, evolving } = store.get();
    return [now.evolution.population, evolving];
  };
  actions.changeSetting('evolution.population', many - 1, false);
  actions.toggleEvolution();
  assert.deepEqual(await began(), [many - 1, true]);
  actions.changeSetting('evolution.population', many, false);
  actions.pauseEvolution();
  assert.deepEqual(await began(), [many, false]);
  // As it is chosen, a seed pauses; Run is pressed after that.
  actions.toggleEvolution();
  actions.useSeed(7);
  assert.equal(store.get().evolving, false);
  actions.toggleEvolution();
  assert.deepEqual(await began(), [many, true]);
  actions.changeSetting('weights.penalty', 10, false);
  actions.oneGeneration();
  assert.deepEqual(await began(), [many, false]);
  await actions.whenIdle();
  assert.deepEqual([store.get().generation, store.get().experiment.weights.penalty], [1, 10]);
});

test('a press on a handle that moves nothing leaves what is being computed as it was asked for', async () => {
  const { store, actions } = pageOf('lab');
  actions.changeSetting('evolution.population', many, false);
  actions.choosePreset('acceleration-limits');
  actions.releasePosture();
  await actions.whenIdle();
  assert.deepEqual([store.get().restart, store.get().preset], ['limits', 'acceleration-limits']);
});

test('one generation that waited for what is stopped is given up with it', async () => {
  const { store, actions } = pageOf(`lab&population=${many}`);
  await actions.whenIdle();
  // So far that generation 0 has to be computed again.
  while (store.get().generation < 30) {
    actions.forward();
    await actions.whenIdle();
  }
  actions.reset();
  assert.ok(store.get().computing);
  actions.oneGeneration();
  actions.stopComputing();
  await actions.whenIdle();
  await breathe();
  assert.deepEqual([store.get().generation, store.get().computing], [30, null]);
  assert.match(store.get().message, /^Stopped/);
});

test('what is stopped leaves nothing of what was asked for', async () => {
  const { store, actions } = pageOf('lab&generation=3');
  const { experiment: before, versions } = store.get();
  actions.changeSetting('evolution.population', many, true);
  actions.changeSetting('weights.penalty', 10, true);
  actions.stopComputing();
  actions.releaseSetting();
  const now = asked(store.get());
  assert.deepEqual([now.experiment, now.versions, now.generation], [before, versions, 3]);
  assert.match(now.message, /^Stopped: what was here before stays/);
  actions.oneGeneration();
  assert.equal(store.get().generation, 4);
});

test('each press on back leads one generation back, also while one is being computed', async () => {
  const { store, actions } = pageOf(`lab&population=${many}`);
  await actions.whenIdle();
  for (let i = 0; i < 3; i += 1) {
    actions.forward();
    await actions.whenIdle();
  }
  actions.oneBack();
  actions.oneBack();
  assert.deepEqual([store.get().generation, store.get().computing?.generation], [3, 1]);
  await actions.whenIdle();
  assert.equal(store.get().generation, 1);
});

test('a seed is shown at its generation, and what has evolved from it stays', async () => {
  const { store, actions } = pageOf('lab&generation=3');
  const seen = async () => {
    actions.evolve(() => store.get().catchingUp !== null);
    await actions.whenIdle();
    const { experiment: now, generation, history, evolving } = store.get();
    return [now.evolution.seed, generation, history.length - 1, evolving];
  };
  const [first] = store.get().history;
  actions.showSeed(1, 12);
  assert.deepEqual(await seen(), [1, 12, 12, false]);
  actions.showSeed(1, 5);
  assert.deepEqual(await seen(), [1, 5, 12, false]);
  assert.equal(store.get().history[0], first);
  actions.showSeed(7, 8);
  assert.deepEqual(await seen(), [7, 8, 8, false]);
  assert.notDeepEqual(store.get().history[0], first);
  // In what is being set.
  actions.changeSetting('evolution.population', many, false);
  actions.showSeed(7, 1);
  await actions.whenIdle();
  while (store.get().catchingUp) await seen();
  assert.deepEqual([store.get().population.length, ...(await seen())], [many, 7, 1, 1, false]);
});

/** Presses Run, and says where evolution pauses. @param {ReturnType<typeof pageOf>} page */
function runOf({ store, actions }) {
  actions.toggleEvolution();
  let left = 200;
  actions.evolve(() => left-- > 0);
  return store.get().generation;
}

test('past the J that it was to come below, evolution pauses as usual', () => {
  const page = pageOf('lab');
  const { store, actions } = page;
  actions.setUntil('cost', '8');
  const reached = runOf(page);
  assert.ok(reached < 100);
  assert.deepEqual(
    store.get().history.map(({ best }) => best.cost < 8),
    [...Array(reached).fill(false), true],
  );
  assert.equal(runOf(page), 100);
  assert.deepEqual(store.get().until, { kind: 'every', value: 100 });
  // Asked for where it is reached already, and from before.
  actions.setUntil('cost', '8');
  assert.equal(runOf(page), 200);
  actions.setUntil('cost', '8');
  actions.showGeneration(0);
  assert.equal(runOf(page), reached);
});

test('past the generation that it was to stop at, evolution pauses as usual, and says so', () => {
  const page = pageOf('lab&generation=6');
  const { store, actions } = page;
  actions.setUntil('generation', '8');
  const run = () => runOf(page);
  assert.equal(run(), 8);
  assert.equal(store.get().until.value, 8);
  // From before it, it is where evolution stops again.
  actions.reset();
  assert.equal(run(), 8);
  assert.equal(run(), 100);
  assert.deepEqual(store.get().until, { kind: 'every', value: 100 });
});

test('Run that is pressed while a link still begins is not taken back', async () => {
  const { store, actions } = pageOf('lab&population=1200');
  assert.equal(store.get().computing?.what, 'begin');
  actions.toggleEvolution();
  await actions.whenIdle();
  assert.deepEqual([store.get().experiment.evolution.population, store.get().evolving], [1200, true]);
});
