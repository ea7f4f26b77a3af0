// Evolution phase by phase, also where a worker takes its time for each generation and for all that happened in it.
import assert from 'node:assert/strict';
import { setImmediate as turn } from 'node:timers/promises';
import { isLongEvolution, isLongRecord } from '../../../www/core/bounds.js';
import { Pending } from '../../../www/core/pending.js';
import { links } from '../../../www/lesson/links.js';
import { createAnatomy } from '../../../www/parts/generation/record.js';
import { generationSlice, phases } from '../../../www/parts/generation/state.js';
import { createSteps } from '../../../www/parts/generation/steps.js';
import { places } from '../../../www/parts/parts.js';
import { createActions } from '../../../www/run/actions/actions.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { createStore } from '../../../www/run/store.js';
import { createEngine } from '../harness/core.js';
import { test } from '../harness/once.js';

/** The page's run, with its frames in the hand. @param {string} link */
async function runOf(link) {
  const engine = createEngine();
  const store = createStore(firstState(engine, 'velocity-limits', atEnd), () => {});
  const actions = createActions({
    engine,
    store,
    paper: engine.paper(),
    finalTime: () => 1,
    isStill: () => true,
    places,
  });
  const { opened, problems } = links.openLink(link, engine);
  assert.deepEqual(problems, []);
  actions.openLinked(opened, []);
  await actions.whenIdle();
  const steps = createSteps({ store, actions, anatomyOf: createAnatomy(engine.record) });
  return {
    store,
    actions,
    /** A frame some seconds later. @param {number} seconds */
    async frame(seconds) {
      try {
        steps.tick(store.get(), seconds);
      } catch (error) {
        if (!(error instanceof Pending)) throw error;
        await error.arrival;
      }
      await turn();
    },
  };
}

for (const [name, link, isHeavy] of /** @type {const} */ ([
  ['at once', 'generation&v=1&seed=3', false],
  [
    'in a worker',
    `generation&v=1&seed=3&population=300&start=${Array.from({ length: 8 }, (_, i) => `${i % 7},${i},0`).join(';')}`,
    true,
  ],
]))
  test(`phases are played ${name}: each in its turn, to where evolution pauses, and on from there`, async () => {
    const { store, actions, frame } = await runOf(link);
    const { experiment } = store.get();
    assert.equal(isLongEvolution(experiment), isHeavy);
    assert.equal(isLongRecord(experiment, 0), isHeavy);
    actions.setPace(0);
    actions.setUntil('generation', '2');
    actions.toggleEvolution();
    /** @type {string[]} */
    const seen = [];
    const play = async () => {
      for (let i = 0; i < 300 && store.get().evolving; i += 1) {
        const { generation } = store.get();
        const place = `${generation} ${generationSlice.of(store.get()).phase}`;
        if (seen.at(-1) !== place) seen.push(place);
        await frame(0.5);
      }
      assert.ok(!store.get().evolving, `it goes on beyond ${seen.at(-1)}`);
    };
    await play();
    assert.equal(store.get().generation, 2);
    assert.equal(generationSlice.of(store.get()).phase, 'survivors');
    const all = phases.map(String);
    const played = (/** @type {number} */ generation) => all.map((phase) => `${generation} ${phase}`);
    const whole = [...seen, '2 survivors'].filter((place) => !place.startsWith('0'));
    assert.deepEqual([...new Set(whole)], [...played(1), ...played(2)]);

    actions.setUntil('generation', '3');
    actions.toggleEvolution();
    await play();
    assert.equal(store.get().generation, 3);
  });
