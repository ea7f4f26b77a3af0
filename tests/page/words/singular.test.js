// One of anything is told as one.
import assert from 'node:assert/strict';
import { phasesOf } from '../../../www/parts/generation/phases.js';
import { dissect } from '../../../www/parts/generation/record.js';
import { othersText as othersInGeneration, sentence } from '../../../www/parts/generation/words/en.js';
import { labPurpose, othersText, restartText } from '../../../www/words/en/lab.js';
import { othersText as othersInKorean } from '../../../www/words/ko/lab.js';
import { Evolution, experiment } from '../harness/core.js';
import { test } from '../harness/once.js';

const base = experiment('velocity-limits');
const wrong =
  /(?<!and )\b1 (?:robots|members|others|survivors|parents|trials|random robots|draws|new draws|random robot: each|stay|are|count|of them arrive)\b/;

test('of few robots the lab speaks as of many', () => {
  for (const count of [1, 2])
    for (const text of [
      labPurpose(count),
      restartText('begin', count, true),
      restartText('seed', count, true),
      othersText({ others: count, population: count + 1, arrived: 1 }),
    ])
      assert.doesNotMatch(text, wrong);
});

test('of one other that drives beside the best the lab says as of one whether it arrives', () => {
  for (const population of [2, 5])
    for (const words of [othersText, othersInKorean]) {
      const [none, away, there] = [null, 0, 1].map((arrived) => words({ others: 1, population, arrived }));
      assert.deepEqual(
        [away, there],
        words === othersText
          ? [`${none} does not arrive`, `${none} arrives`]
          : [`${none}, 미도착`, `${none}, 도착`],
      );
    }
  assert.equal(othersText({ others: 1, population: 2, arrived: null }), 'the other one');
  assert.equal(othersText({ others: 2, population: 3, arrived: 0 }), 'the other 2, 0 of them arrive');
  assert.deepEqual(
    [0, 1, 2].map((arrived) => othersInKorean({ others: 2, population: 3, arrived })),
    ['나머지 로봇 2대, 모두 미도착', '나머지 로봇 2대, 그중 1대 도착', '나머지 로봇 2대, 모두 도착'],
  );
});

test('so does each phase of each method with the fewest robots', () => {
  for (const [method, population] of /** @type {const} */ ([
    ['ep', 1],
    ['ep', 2],
    ['random', 1],
    ['de', 4],
    ['cma-es', 2],
    ['cma-es', 3],
  ])) {
    const settings = { ...base.evolution, method, population, opponents: 1 };
    const evolution = new Evolution({ ...base, evolution: settings });
    for (let i = 0; i < 30; i += 1) evolution.step();
    for (let i = 0; i <= 30; i += 1) {
      const anatomy = dissect(evolution.record(i), settings);
      for (const phase of phasesOf(anatomy)) assert.doesNotMatch(sentence(anatomy, phase), wrong);
    }
  }
});

test('of one other that drives beside the chosen it is said as of one whether it arrives', () => {
  for (const [method, generation] of /** @type {const} */ ([
    ['ep', 3],
    ['random', 3],
    ['finite-differences', 9],
  ])) {
    const settings = { ...base.evolution, method };
    const evolution = new Evolution({ ...base, evolution: settings });
    for (let i = 0; i < generation; i += 1) evolution.step();
    const anatomy = dissect(evolution.record(generation), settings);
    for (const phase of phasesOf(anatomy))
      for (const isAmong of [true, false]) {
        const [none, away, there] = [null, 0, 1].map((arrived) =>
          othersInGeneration(anatomy, phase, { drawn: 1, all: 1, isAmong, arrived }),
        );
        assert.doesNotMatch(none, /\d|arrive/);
        assert.equal(away, `${none}, which does not arrive`);
        assert.equal(there, `${none}, which arrives`);
      }
  }
});
