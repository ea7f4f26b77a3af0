// What an exercise locks and hides, without a browser.
import { tidyText } from '../../../www/kit/text.js';
import assert from 'node:assert/strict';
import {
  firstMaker,
  groupNames,
  noExercise,
  shownExercise,
  wayOf,
  withWay,
} from '../../../www/run/exercise.js';
import { groupOf, guarded } from '../../../www/run/guard.js';
import { withExercise } from '../../../www/link/link.js';
import { paces } from '../../../www/run/pace.js';
import { nobody } from '../../../www/run/variant.js';
import { experiment } from '../harness/core.js';
import { test } from '../harness/once.js';
import { pageOf } from './page-of.js';

test('a task is one line of text, whatever was written', () => {
  const rows = [
    ['  Find gains\n\tthat park \u0000 the robot.\r\n', 'Find gains that park the robot.'],
    ['safe\u202Egnp.exe\u2066 x\u200F', 'safegnp.exe x'],
    ['half \ud83e of a robot \udd16', 'half of a robot'],
    ['<b>bold</b> 🤖 과제', '<b>bold</b> 🤖 과제'],
    ['\n\u2028 \u00a0', ''],
  ];
  for (const [written, shown] of rows) assert.equal(tidyText(written), shown);
});

test('each group of controls is free, locked or hidden, and says so in a fixed order', () => {
  let exercise = withWay(withWay(withWay(noExercise, 'share', 'locked'), 'gains', 'locked'), 'run', 'hidden');
  assert.deepEqual(exercise, { ...noExercise, locked: ['gains', 'share'], hidden: ['run'] });
  exercise = withWay(withWay(exercise, 'gains', 'hidden'), 'share', 'free');
  assert.deepEqual(exercise, { ...noExercise, hidden: ['gains', 'run'] });
  assert.equal(wayOf({ ...noExercise, locked: ['run'], hidden: ['run'] }, 'run'), 'hidden');
  assert.equal(
    withExercise(
      'lab&v=1&lesson=2',
      { exercise: { ...exercise, task: 'a & b' }, student: nobody },
      experiment,
    ),
    'lab&v=1&lesson=2&hide=gains,run&task=a%20%26%20b',
  );
  assert.equal(withExercise('lab', { exercise: noExercise, student: nobody }, experiment), 'lab');
});

test('what is locked or hidden does nothing but say so, whichever control asks for it; what is free goes on', () => {
  /** Each action with the group that it obeys; of what drives, the paper's gains are a group of their own. @type {[name: string, owners: string[], ...given: unknown[]][]} */
  const asked = [
    .../** @type {[string, string][]} */ (Object.entries(groupOf))
      .filter(([name]) => name !== 'backToPreset')
      .map(([name, owner]) => /** @type {[string, string[]]} */ ([name, [owner]])),
    ['backToPreset', ['settings', 'postures', 'seed']],
    ['changeSetting', ['settings', 'postures'], 'goal.x'],
    ['changeSetting', ['settings', 'postures'], 'starts[0].theta'],
    ['changeSetting', ['settings', 'seed'], 'evolution.seed'],
    ['changeSetting', ['settings'], 'evolution.population'],
    ['chooseDriver', ['drives'], 'evolved'],
    ['chooseDriver', ['drives', 'paper'], 'paper-ep'],
    ['chooseDriver', ['drives', 'paper'], 'paper-arbitrary'],
  ];
  let done = 0;
  let refusals = 0;
  const actions = Object.fromEntries(asked.map(([name]) => [name, () => (done += 1)]));
  for (const group of groupNames)
    for (const way of /** @type {const} */ (['locked', 'hidden', 'free'])) {
      const exercise = withWay(noExercise, group, way);
      const controls = /** @type {Record<string, (...given: any[]) => unknown>} */ (
        /** @type {unknown} */ (
          guarded(
            /** @type {any} */ (actions),
            /** @type {any} */ ({
              get: () => ({ exercise, maker: firstMaker, refusals }),
              update: (/** @type {{ refusals: number }} */ patch) => ({ refusals } = patch),
            }),
          )
        )
      );
      for (const [name, owners, ...given] of asked) {
        done = 0;
        refusals = 0;
        controls[name](...given);
        const isRefused = owners.includes(group) && way !== 'free';
        // Share, for instance, does without a pause.
        const isSaid = isRefused && name !== 'pauseEvolution';
        assert.deepEqual([done, refusals], [isRefused ? 0 : 1, isSaid ? 1 : 0], `${way} ${group}: ${name}`);
      }
    }
});

test('an exercise in the making frees nothing of the one that is open', () => {
  const exercise = {
    ...noExercise,
    task: 'x',
    locked: /** @type {const} */ (['gains']),
    hidden: /** @type {const} */ (['paper']),
  };
  const draft = { ...noExercise, task: 'y', locked: /** @type {const} */ (['paper', 'run']) };
  const shown = (/** @type {boolean} */ open) => shownExercise({ exercise, maker: { open, draft } });
  assert.deepEqual(shown(true), { ...draft, locked: ['gains', 'run'], hidden: ['paper'] });
  assert.equal(shown(false), exercise);
  // It is the same until something else is.
  assert.equal(shown(true), shown(true));
});

test('what a lecturer locks while it runs is paused, for nobody could pause it then', () => {
  const { store, actions } = pageOf('lab');
  actions.makeExercise({ open: true });
  actions.toggleEvolution();
  actions.makeExercise({ draft: withWay(noExercise, 'gains', 'locked') });
  assert.equal(store.get().evolving, true);
  actions.makeExercise({ draft: withWay(noExercise, 'run', 'locked') });
  assert.equal(store.get().evolving, false);
});

test('what a link still evolves comes to its end, whatever a lecturer locks meanwhile', () => {
  const { store, actions } = pageOf('lab');
  store.update({ evolving: true, catchingUp: { newest: 3, generation: 3 } });
  actions.makeExercise({ open: true, draft: withWay(noExercise, 'run', 'locked') });
  assert.equal(store.get().evolving, true);
});

test('the settings and the maker stand in one place, and in no exercise that locks the settings', () => {
  const { store, actions, open } = pageOf('lab');
  const areOpen = () => [store.get().settings.open, store.get().maker.open];
  actions.makeExercise({ open: true });
  actions.openSettings(true);
  assert.deepEqual(areOpen(), [true, false]);
  open('lab&lock=settings');
  assert.deepEqual(areOpen(), [false, false]);
});

test('where the parts are locked, phase by phase is one generation after the other', () => {
  const { store, actions } = pageOf('lab&lock=parts');
  actions.toggleEvolution();
  actions.setPace(paces[0]);
  assert.equal(store.get().pace, 1);
});
