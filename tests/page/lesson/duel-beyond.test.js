// What is said of evolution's ky after the duel is so in the duel that was fought.
import assert from 'node:assert/strict';
import { isBeyond, lockedIn, roundOf } from '../../../www/lesson/duel/duel.js';
import { noTally } from '../../../www/lesson/state.js';
import { stepOf } from '../../../www/lesson/steps.js';
import { contest, engine, yard } from './duel-task.js';
import { opened } from './links.js';
import { liveOf, tryOf } from './live.js';
import { test } from '../harness/once.js';

const step = stepOf('duel');

test('where no hand goes evolution’s ky lies only while turning is cheap', async () => {
  const dear = yard.experimentOf(opened(tryOf('duel', 'dear')).experiment);
  for (const [experiment, turning, expected] of /** @type {const} */ ([
    [contest, '0.1', true],
    [dear, '1', false],
  ])) {
    const duel = lockedIn(noTally, experiment);
    const round = await roundOf(engine, duel, 1);
    assert.equal(isBeyond(duel, round, 'velocity-limits'), expected, `ky ${round.champion[1]}`);
    const live = liveOf(expected ? step.link : tryOf('duel', 'dear'));
    const told = step.values?.(live);
    assert.equal(told?.turning, turning);
    assert.equal(told?.before, expected ? 'not 1 as in the steps before' : 'as in the steps before');
  }
  // Neither beyond the slider alone, nor beyond random search's range alone.
  const round = { champion: /** @type {const} */ ([1, 20, 1]) };
  const wide = {
    ...contest,
    evolution: { ...contest.evolution, initialRange: /** @type {[number, number]} */ ([0, 30]) },
  };
  assert.ok(!isBeyond({ experiment: contest }, round, 'acceleration-limits'));
  assert.ok(!isBeyond({ experiment: wide }, round, 'velocity-limits'));
});
