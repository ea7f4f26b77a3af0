// How a figure answers its host: in which order, and where drives cannot be had, or the core has failed.
import assert from 'node:assert/strict';
import { Pending } from '../../../www/core/pending.js';
import { breathe } from '../../../www/kit/loop.js';
import { experiment, historyOf, simulate } from '../harness/core.js';
import { test } from '../harness/once.js';
import { slowEngine } from '../harness/slow-engine.js';
import { figureOf } from './figure.js';

test('a link that is still being computed is what a figure is ready with, and goes on from', async () => {
  const { engine, open } = slowEngine();
  const { messages, said, asked } = figureOf({ link: 'lab&v=1&population=2000&seed=7', engine });
  const ready = messages.ready();
  const stepped = asked({ type: 'step' });
  open();
  await ready;
  assert.deepEqual([said[0].type, said[0].link], ['ready', 'lab&v=1&population=2000&seed=7']);
  assert.equal((await stepped).link, 'lab&v=1&population=2000&seed=7&generation=1');
});

test('a host’s set stays asked for, whatever its user presses meanwhile, and what was set before is not its past', async () => {
  const { engine, open } = slowEngine();
  const { messages, actions, asked, store } = figureOf({ engine });
  await messages.ready();
  await asked({ type: 'set', link: 'lab' });
  actions.changeSetting('evolution.population', 1999, false);
  const answer = asked({ type: 'set', link: 'lab&v=1&population=2000' });
  while (store.get().computing?.next) await breathe();
  actions.pauseEvolution();
  open();
  assert.equal((await answer).link, 'lab&v=1&population=2000');
  assert.deepEqual(
    store.get().versions.past.map(({ experiment: { evolution } }) => evolution.population),
    [20],
  );
});

test('what could not be driven is answered by why, and no drive is told that belongs to something else', async () => {
  const { messages, actions, said, held, asked } = figureOf();
  await messages.ready();
  assert.equal(said[0].type, 'ready');
  const set = await asked({ type: 'set', experiment: {}, gains: [4, 1, 6] });
  assert.deepEqual([set.type, set.drive.gains], ['state', [4, 1, 6]]);

  held.error = new Error('A worker was lost');
  said.length = 0;
  actions.slideGain(0, 5);
  messages.announce();
  for (const message of [
    { type: 'read' },
    { type: 'set', experiment: {}, gains: [3, 1, 6] },
    { type: 'step' },
    { type: 'read' },
  ]) {
    const answer = await asked(message);
    assert.deepEqual([answer.type, answer.message], ['error', 'A worker was lost'], JSON.stringify(message));
  }
  assert.deepEqual(
    said.filter(({ type }) => type === 'drive'),
    [],
  );

  // What drives again is told again.
  held.error = null;
  const again = await asked({ type: 'set', experiment: {}, gains: [4, 1, 6] });
  assert.equal(again.drive.cost.total, simulate(experiment({}), [4, 1, 6]).cost.total);
  assert.deepEqual(again.drive.gains, [4, 1, 6]);
});

test('a figure of which the first drive cannot be had says why, and goes on', async () => {
  const { messages, said, held, asked } = figureOf();
  held.error = new Error('A worker was lost');
  messages.hear({ ep: 1, type: 'set', experiment: { horizon: 9 } });
  await asked({ type: 'read' });
  said.length = 0;
  await messages.ready();
  assert.deepEqual(said[0], { type: 'error', message: 'A worker was lost' });
  held.error = null;
  assert.equal((await asked({ type: 'set', experiment: {} })).type, 'state');
});

test('what the host sets is no drive of the user, however long it takes', async () => {
  const { messages, said, held, seen, asked } = figureOf();
  await messages.ready();
  let arrive = () => {};
  held.error = new Pending(new Promise((resolve) => (arrive = () => resolve(null))));
  const answer = asked({ type: 'set', experiment: {}, gains: [4, 1, 6] });
  while (!seen().isComputing) await breathe();
  held.error = null;
  arrive();
  assert.deepEqual((await answer).drive.gains, [4, 1, 6]);
  messages.announce();
  assert.deepEqual(
    said.filter(({ type }) => type === 'drive'),
    [],
  );
});

test('where the core has failed each question is answered by that, also what is being computed', async () => {
  const { messages, said, held, seen, asked: ask } = figureOf();
  await messages.ready();
  held.error = new Pending(new Promise(() => {}));
  const open = [{ type: 'set', experiment: { horizon: 9 } }, { type: 'read' }, { type: 'step' }].map(ask);
  // The first is under way.
  while (!seen().isComputing) await breathe();
  said.length = 0;
  messages.fail('it has stopped');
  messages.fail('it has stopped');
  for (const { type, message } of await Promise.all([...open, ask({ type: 'run' })]))
    assert.deepEqual([type, message], ['error', 'it has stopped']);
  messages.announce();
  assert.equal(said.length, 4);
  assert.match((await ask({ type: 'reed' })).message, /not “reed”/);

  // Who was to be ready says so by itself, once.
  const late = figureOf();
  late.held.error = new Pending(new Promise(() => {}));
  const asked = late.asked({ type: 'set', experiment: { horizon: 9 } });
  const ready = late.messages.ready();
  late.messages.fail('it has stopped');
  await ready;
  assert.equal((await asked).type, 'error');
  assert.deepEqual(
    late.said.filter(({ id }) => id === undefined),
    [{ type: 'error', message: 'it has stopped' }],
  );
});

test('of a core that fails under a question the page is told once', async (t) => {
  const { messages, held, asked } = figureOf();
  await messages.ready();
  /** @type {unknown[]} */
  const reported = [];
  const report = (/** @type {unknown} */ error) => {
    reported.push(error);
    messages.fail('it has stopped');
  };
  Object.assign(globalThis, { reportError: report });
  t.after(() => Reflect.deleteProperty(globalThis, 'reportError'));
  held.error = new WebAssembly.RuntimeError('unreachable');
  const questions = [{ type: 'set', experiment: { horizon: 9 } }, { type: 'read' }, { type: 'step' }];
  for (const { type } of await Promise.all(questions.map(asked))) assert.equal(type, 'error');
  assert.deepEqual(reported, [held.error]);
});

test('fields that are left out are those of the figure’s preset, and a run that is spread stays what it is', async () => {
  const { messages, asked } = figureOf({
    link: 'lab&v=1&preset=acceleration-limits&seed=7&population=40&limits.speed=1',
  });
  await messages.ready();
  const { experiment: run } = await asked({ type: 'read' });
  // As postMessage has it: nothing tells from which preset a copy is.
  const { link, experiment: kept } = await asked({
    type: 'set',
    experiment: structuredClone({ ...run, goal: { x: 3, y: 1, theta: 0 } }),
  });
  assert.equal(
    link,
    'lab&v=1&preset=acceleration-limits&goal.x=3&goal.y=1&goal.theta=0deg&limits.speed=1&population=40&seed=7',
  );
  assert.deepEqual(kept.limits, run.limits);
  const { experiment: anew } = await asked({ type: 'set', experiment: { goal: { x: 3 } } });
  assert.deepEqual(anew, experiment('acceleration-limits', { goal: { x: 3 } }));
  const { experiment: slow } = await asked({
    type: 'set',
    experiment: structuredClone({ ...run, limits: { speed: 0.5 } }),
  });
  assert.deepEqual(slow.limits, { ...experiment('acceleration-limits').limits, speed: 0.5 });
});

/** As many as no figure comes to at once: the most of a step, and of a set. */
const many = 10_000;
const most = 100_000;

test('a pause ends what was asked before it, which tells how far it came, and the answers stay in their order', async () => {
  const { messages, asked, said, store } = figureOf({ link: 'lab&v=1&seed=7' });
  await messages.ready();
  const stepped = asked({ type: 'step', generations: many });
  const waiting = asked({ type: 'step', generations: many });
  while (store.get().generation === 0) await breathe();
  said.length = 0;
  const paused = asked({ type: 'pause' });
  const answers = await Promise.all([stepped, waiting, paused]);
  const { generations } = answers[0];
  assert.ok(generations > 0 && generations < many);
  assert.deepEqual(
    answers.map((answer) => [answer.type, answer.generations, answer.problems, answer.evolving]),
    Array(3).fill(['state', generations, [], false]),
  );
  assert.deepEqual(
    said.map(({ id }) => id).filter((id) => id !== undefined),
    [1, 2, 3],
  );
  // What is asked after it goes on.
  const further = await asked({ type: 'step', generations: 2 });
  assert.equal(further.generations, generations + 2);

  const set = asked({ type: 'set', experiment: {}, gains: [4, 1, 6], generation: most });
  while (!store.get().catchingUp) await breathe();
  const [left] = await Promise.all([set, asked({ type: 'pause' })]);
  assert.deepEqual([left.type, left.drive.gains, left.evolving], ['state', [4, 1, 6], false]);
  assert.ok(left.generations < most && left.generation === left.generations);
});

test('what only reads, or is refused, waits for no generation, and reads nothing older than what was set', async () => {
  const { messages, asked, store } = figureOf({ link: 'lab&v=1&seed=7' });
  await messages.ready();
  const set = asked({ type: 'set', link: `lab&v=1&seed=9&generation=${most}` });
  const { experiment: begun, generations } = await asked({ type: 'read' });
  assert.equal(begun.evolution.seed, 9);
  assert.ok(generations < most);
  const { type, message } = await asked({ type: 'step', generations: 0 });
  assert.deepEqual([type, /^generations must be/.test(message)], ['error', true]);
  assert.ok(store.get().catchingUp);
  await Promise.all([set, asked({ type: 'pause' })]);

  // What is refused when its turn comes keeps nobody waiting either.
  const refused = asked({ type: 'set', experiment: { flavour: 'red' } });
  assert.equal((await asked({ type: 'read' })).experiment.evolution.seed, 9);
  assert.match((await refused).message, /flavour/);
});

test('what was set begins all the same when a pause ends it', async () => {
  const { engine, open } = slowEngine();
  const { messages, asked, store } = figureOf({ engine });
  await messages.ready();
  const set = asked({ type: 'set', link: 'lab&v=1&population=2000&generation=50' });
  while (!store.get().computing) await breathe();
  const paused = asked({ type: 'pause' });
  open();
  const answers = await Promise.all([set, paused]);
  for (const { experiment: begun, generations, evolving } of answers) {
    assert.equal(begun.evolution.population, 2000);
    assert.ok(generations < 50 && !evolving);
  }
});

test('of a run that goes on the drive is told with the generation that it belongs to', async () => {
  // Each of its first generations has another best.
  const { messages, actions, held, seen, asked } = figureOf({ link: 'lab&v=1&seed=4' });
  await messages.ready();
  const best = historyOf(experiment({ evolution: { seed: 4 } }), 3).map((one) => String(one.best.gains));
  assert.equal(new Set(best).size, 4);
  /** What ends the wait for the drive of each. @type {(() => void)[]} */
  const open = [];
  const drives = best.map((_, i) => new Promise((resolve) => (open[i] = () => resolve(null))));
  let arrived = 0;
  held.of = (gains) => {
    const i = best.indexOf(String(gains));
    return i > arrived ? new Pending(drives[i]) : null;
  };
  actions.forward();
  assert.ok(seen().isComputing);
  const { waits } = held;
  const answer = asked({ type: 'read' });
  while (held.waits === waits) await breathe();
  for (const i of [1, 2]) {
    actions.forward();
    arrived = i;
    open[i]();
    await breathe();
  }
  const { generation, generations, drive, statistics, link } = await answer;
  assert.deepEqual([generation, generations, link], [2, 3, 'lab&v=1&seed=4&generation=2']);
  assert.deepEqual(drive.gains, statistics.best.gains);
});

test('a figure on its way to the generation of its link can be asked, and a pause ends it', async () => {
  const { messages, asked, said } = figureOf({ link: `lab&v=1&seed=7&generation=${most}` });
  const ready = messages.ready(['it was ignored']);
  const { experiment: begun, generations } = await asked({ type: 'read' });
  assert.equal(begun.evolution.seed, 7);
  assert.ok(generations < most);
  const open = ['step', 'read', 'pause'].map((type) => asked({ type }));
  await Promise.all([ready, ...open]);
  const told = said.filter(({ type, id }) => type !== 'generation' && id !== 1 && id !== 3);
  assert.deepEqual(
    told.map(({ type, id, problems, evolving }) => [type, id, problems, evolving]),
    [
      ['ready', undefined, ['it was ignored'], false],
      ['state', 2, [], false],
      ['state', 4, [], false],
    ],
  );
  for (const one of told) assert.equal(one.generations, told[0].generations);
  assert.ok(told[0].generations < most);
});

test('an answer to the lesson’s question is told once, as soon as the right one is known', async () => {
  const { messages, said, held } = figureOf();
  await messages.ready();
  const law = { choice: 0, right: 1 };
  for (const right of [null, 1, 1]) {
    held.answers = { drive: { choice: 1, right }, law };
    messages.announce();
  }
  const told = said.filter(({ type }) => type === 'answer').map(({ question }) => question);
  assert.deepEqual(told, ['law', 'drive']);
});
