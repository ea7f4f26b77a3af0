// What a press that takes long finds once it can be done: it goes on in what it was pressed for, and in nothing else.
import assert from 'node:assert/strict';
import { Pending } from '../../../www/core/pending.js';
import { breathe } from '../../../www/kit/loop.js';
import { links } from '../../../www/lesson/links.js';
import { createAnatomy } from '../../../www/parts/generation/record.js';
import { generationSlice } from '../../../www/parts/generation/state.js';
import { createSteps } from '../../../www/parts/generation/steps.js';
import { places } from '../../../www/parts/parts.js';
import { createActions } from '../../../www/run/actions/actions.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { createStore } from '../../../www/run/store.js';
import { test } from '../harness/once.js';
import { slowEngine } from '../harness/slow-engine.js';

/** @typedef {'step' | 'record' | 'population'} Call */

/** The steps of what a link opens, and an engine of which one call keeps one waiting from `hold` to `free`. @param {string} link @param {Call} [held] */
function stepsIn(link, held) {
  const { engine, open } = slowEngine();
  let isHeld = false;
  let arrive = () => {};
  const arrival = new Promise((resolve) => {
    arrive = () => resolve(null);
  });
  if (held) {
    const own = /** @type {(...args: any[]) => any} */ (engine[held]);
    engine[held] = (/** @type {any[]} */ ...args) => {
      if (isHeld) throw new Pending(arrival);
      return own(...args);
    };
  }
  const store = createStore(firstState(engine, 'velocity-limits', atEnd), () => {});
  const means = { engine, store, paper: engine.paper(), finalTime: () => 1, isStill: () => true, places };
  const actions = createActions(means);
  /** What frames do on the way to a generation that is not there at once, which depends on the machine. */
  const catchUp = () => actions.evolve(() => store.get().catchingUp !== null);
  const follow = (/** @type {string} */ one) => {
    actions.openLinked(links.openLink(one, engine).opened, []);
    catchUp();
  };
  follow(link);
  return {
    ...{ store, actions, follow, open },
    steps: createSteps({ store, actions, anatomyOf: createAnatomy((...asked) => engine.record(...asked)) }),
    hold: () => {
      isHeld = true;
    },
    free: () => {
      isHeld = false;
      arrive();
    },
    rest: async () => {
      do await breathe();
      while (store.get().computing);
      catchUp();
    },
    seen: () => [store.get().generation, generationSlice.of(store.get()).phase],
  };
}

test('the next phase is one of what was set, once that is there', async () => {
  const { store, actions, steps, open, rest, seen } = stepsIn('generation&v=1&phase=survivors&individual=5');
  actions.changeSetting('evolution.population', 2000, false);
  steps.next();
  open();
  while (store.get().generation === 0 || store.get().computing) await rest();
  assert.equal(store.get().experiment.evolution.population, 2000);
  assert.deepEqual(seen(), [1, 'parents']);
});

test('what was set and is left for a link goes on in nothing of that', async () => {
  const { actions, steps, follow, open, rest, seen } = stepsIn('generation&v=1&phase=survivors');
  actions.changeSetting('evolution.population', 2000, false);
  steps.next();
  follow('generation&v=1&generation=3&phase=mutation');
  open();
  await rest();
  assert.deepEqual(seen(), [3, 'mutation']);
});

/** What is opened, which call is held, what is pressed, and what is opened meanwhile. @type {[string, Call, 'next' | 'back' | 'begin', number, string][]} */
const presses = [
  ['generation=0&phase=survivors', 'step', 'next', 3, 'survivors'],
  ['generation=0&phase=survivors', 'step', 'next', 1, 'drive'],
  ['generation=0&phase=survivors', 'step', 'begin', 1, 'drive'],
  ['generation=2&phase=drive', 'record', 'next', 2, 'mutation'],
  ['generation=2&phase=drive', 'record', 'back', 2, 'ranking'],
  ['generation=3&phase=parents', 'population', 'back', 2, 'drive'],
];

test('a link that is opened while a press is computed keeps its phase and its individual', async () => {
  for (const [from, held, press, generation, phase] of presses) {
    const { store, steps, follow, hold, free, rest, seen } = stepsIn(`generation&v=1&${from}`, held);
    const before = seen();
    hold();
    steps[press]();
    assert.deepEqual(seen(), before);
    free();
    // Before anybody hears that it is there.
    follow(`generation&v=1&generation=${generation}&phase=${phase}&individual=2`);
    await rest();
    assert.deepEqual(
      [...seen(), generationSlice.of(store.get()).chosen],
      [generation, phase, 2],
      `${from}, ${press}`,
    );
  }
});

test('what is pressed goes on once it is there', async () => {
  for (const [from, held, press] of presses) {
    const { steps, hold, free, rest, seen } = stepsIn(`generation&v=1&${from}`, held);
    const before = seen();
    hold();
    steps[press]();
    assert.deepEqual(seen(), before);
    free();
    await rest();
    assert.notDeepEqual(seen(), before, `${from}, ${press}`);
  }
});

test('to go back ends an evolution that goes on, at once', () => {
  const { store, actions, steps, hold } = stepsIn('generation&v=1&generation=2&phase=drive', 'record');
  actions.toggleEvolution();
  assert.equal(store.get().evolving, true);
  hold();
  steps.back();
  assert.equal(store.get().evolving, false);
});

/** The phases of each method of search, and of the paper's as it is changed. */
const courses = /** @type {const} */ ([
  ['method=random', ['parents', 'mutation', 'drive', 'survivors']],
  ['method=de', ['parents', 'mutation', 'drive', 'survivors']],
  ['method=cma-es', ['parents', 'mutation', 'drive', 'ranking', 'survivors']],
  ['method=one-plus-one-es', ['parents', 'mutation', 'drive', 'survivors']],
  ['method=nelder-mead', ['parents', 'mutation', 'drive', 'survivors']],
  ['method=one-at-a-time', ['parents', 'mutation', 'drive', 'survivors']],
  ['method=finite-differences', ['parents', 'mutation', 'drive', 'survivors']],
  ['selection=truncation', ['parents', 'mutation', 'drive', 'ranking', 'survivors']],
  ['crossover=1', ['parents', 'mutation', 'drive', 'tournament', 'ranking', 'survivors']],
]);

test('one goes through the phases that a search has, and then into the next generation', () => {
  for (const [setting, phases] of courses) {
    const { steps, seen } = stepsIn(`generation&v=1&generation=5&phase=parents&evolution.${setting}`);
    for (const phase of phases) {
      assert.deepEqual(seen(), [5, phase], setting);
      steps.next();
    }
    assert.deepEqual(seen(), [6, 'parents'], setting);
  }
});

test('a record is asked of the run that is seen, also once the engine has another', () => {
  const { store, actions } = stepsIn('generation&v=1&generation=2');
  const seen = store.get();
  actions.changeSetting('goal.x', 1.5, false);
  assert.notEqual(store.get().experiment, seen.experiment);
  /** @type {unknown[]} */
  let asked = [];
  const anatomyOf = createAnatomy((...args) => {
    asked = args;
    throw new Pending(Promise.resolve());
  });
  assert.throws(() => anatomyOf(seen), Pending);
  assert.deepEqual(asked, [2, seen.experiment]);
});
