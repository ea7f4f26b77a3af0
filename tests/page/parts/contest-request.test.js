// A contest that does not come to its end, or of which a part does not.
import assert from 'node:assert/strict';
import { createContestRequests } from '../../../www/parts/luck/contest-request.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import { atEnd } from '../../../www/run/clock.js';
import { firstState } from '../../../www/run/first.js';
import { createStore } from '../../../www/run/store.js';
import { test } from '../harness/once.js';
import { slowEngine } from '../harness/slow-engine.js';

/** @typedef {ReturnType<typeof slowEngine>['engine']['surveys']} Surveys */

/** The lab's own search and differential evolution, which begin when `open` lets them. @param {(trials: Surveys['trials']) => Surveys['trials']} [instead] */
function contestOfTwo(instead = (trials) => trials) {
  const { engine, open } = slowEngine();
  const { surveys } = engine;
  surveys.trials = instead(surveys.trials);
  const store = createStore(firstState(engine, 'velocity-limits', atEnd), () => {});
  const { now, update } = luckSlice.at(store);
  update({ others: ['de'], seeds: 15, budget: 1000 });
  return { open, now, update, requests: createContestRequests(engine, store) };
}

test('a contest that is refused stops the one before, of which what has run stays', async () => {
  const { open, now, update, requests } = contestOfTwo();
  const before = requests.run();
  assert.ok(now().contestRuns);
  update({ budget: 1e9 });
  await requests.run();
  const stopped = now();
  assert.match(stopped.contestMessage, /^That would be 30.000.000.000 drives, far too many/);
  assert.deepEqual([stopped.contestRuns, stopped.contest?.cancelled], [false, true]);
  open();
  await before;
  assert.equal(now(), stopped);
});

test('a contestant of which a part fails has no trials, whether its other parts come before or after', async () => {
  for (const failing of [1, 9]) {
    const { open, now, requests } = contestOfTwo((trials) => (experiment, asked, options) => {
      const isFailing = experiment.evolution.method === 'de' && asked.seeds[0] === failing;
      return isFailing ? Promise.reject(new Error('lost')) : trials(experiment, asked, options);
    });
    open();
    await requests.run();
    const lines = now().contest?.lines.map(({ name, trials, error }) => [name, trials.length, error]);
    assert.deepEqual(lines, [
      [null, 15, ''],
      ['de', 0, 'lost'],
    ]);
  }
});
