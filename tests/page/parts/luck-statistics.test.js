// What is counted of many seeds.
import assert from 'node:assert/strict';
import { csvOf, quartilesOf } from '../../../www/parts/luck/statistics.js';
import { surveyOf } from '../../../www/parts/luck/request.js';
import { luckSlice } from '../../../www/parts/luck/state.js';
import * as en from '../../../www/parts/luck/words/en.js';
import { firstMaker, noExercise } from '../../../www/run/exercise.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/browsers.js').Page} Page */
/** @typedef {import('../../../pkg/ep_locomotion.js').Preset} Preset */

test('quartiles lie between the numbers in proportion, also when some are infinite', () => {
  assert.deepEqual(quartilesOf([4, 1, 3, 2, 5]), { least: 1, low: 2, median: 3, high: 4, most: 5 });
  assert.deepEqual(quartilesOf([10, 0]), { least: 0, low: 2.5, median: 5, high: 7.5, most: 10 });
  const { median, high, most } = quartilesOf([1, 2, Infinity, Infinity, Infinity]);
  assert.deepEqual([median, high, most], [Infinity, Infinity, Infinity]);
});

test('the CSV of one seed is what it was', () => {
  const champion = {
    gains: /** @type {[number, number, number]} */ ([3, -0.5, 5]),
    sigmas: /** @type {[number, number, number]} */ ([1, 1, 1]),
    cost: 7,
  };
  const run = { best: Float64Array.of(8, 7), champion, random: Float64Array.of(8, 7.75) };
  assert.equal(
    csvOf({ first: 4, drives: 40, runs: [run] }),
    'seed,drives,J evolution,kx (1/s),ky (1/(m^2 s)),ktheta (rad/s),J random search,' +
      'J evolution generation 0,J evolution generation 1,J random search generation 0,J random search generation 1\r\n' +
      '4,40,7,3,-0.5,5,7.75,8,7,8,7.75\r\n',
  );
});

test('a result from before does not tell what the paper’s gains cost where they are hidden', () => {
  const result = { generations: 50, paper: { gains: [1, 2, 3], cost: 7.935 } };
  const state = /** @type {any} */ ({
    slices: { [luckSlice.name]: { ...luckSlice.first, result } },
    exercise: noExercise,
    maker: firstMaker,
  });
  assert.equal(surveyOf(state), result);
  const hiding = { ...state, exercise: { ...noExercise, hidden: ['paper'] } };
  const shownThen = /** @type {any} */ (surveyOf(hiding));
  assert.equal(surveyOf(hiding), shownThen);
  assert.match(en.curveLabel(/** @type {any} */ (result), ''), /7\.935/);
  assert.doesNotMatch(en.curveLabel(shownThen, ''), /7\.935|paper/);
});
