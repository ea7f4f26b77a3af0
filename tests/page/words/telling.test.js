// Numbers that differ where it matters are not written as the same.
import assert from 'node:assert/strict';
import { summaryOf } from '../../../www/parts/curves/stability/summary.js';
import { noteText } from '../../../www/parts/curves/stability/words/en.js';
import { timeText } from '../../../www/parts/curves/words/common.js';
import { costWriter } from '../../../www/parts/generation/words/common.js';
import * as en from '../../../www/parts/generation/words/en.js';
import * as ko from '../../../www/parts/generation/words/ko.js';
import { shareText } from '../../../www/parts/robustness/words/common.js';
import { rangesOf } from '../../../www/parts/training/spread.js';
import { spreadText } from '../../../www/parts/training/words/en.js';
import { shareOf } from '../../../www/parts/training/words/common.js';
import { costBeside } from '../../../www/share/handin/words/common.js';
import { costText } from '../../../www/words/numbers.js';
import { createEngine } from '../harness/core.js';
import { test } from '../harness/once.js';

test('only all are 100 %, and only none are 0 %', () => {
  for (let part = 0; part <= 1000; part += 1) {
    assert.equal(shareOf(part, 1000) === '100', part === 1000);
    assert.equal(shareOf(part, 1000) === '0', part === 0);
  }
  const count = 118_098;
  for (const part of [0, 1, 4, 58, 60, 200, 60_000]) {
    assert.equal(shareText(part / count) === '0.0', part === 0);
    assert.equal(shareText(1 - part / count) === '100.0', part === 0);
  }
  assert.deepEqual([shareText(0.5332), shareText(1 - 1e-5), shareText(1e-5)], ['53.3', '>99.9', '<0.1']);
  const counts = [998, 999, 999];
  assert.match(
    spreadText(rangesOf({ one: [250, 400], circle: counts, grid: counts }), 1000, 1),
    /33\u202f% \(25 to 40\u202f%\) .*99\.9\u202f% \(99\.8 to 99\.9\u202f%\)/,
  );
});

test('a J that falls is another one than before, of whatever size it is', () => {
  for (const size of [1, 10, 103, 5000, 400_000])
    for (const by of [0.5, 0.03, 1e-3, 1e-5]) {
      const [before, after] = [size, size - by];
      const write = costWriter(
        /** @type {any} */ ({ all: [{ cost: after }, { cost: before + 1 }, { cost: size * 2 }] }),
      );
      for (const words of [en, ko]) {
        const [from, to] = words.bestText('ep', before, after, write).match(/\d+(?:\.\d+)?/g) ?? [];
        assert.ok(Number(from) > Number(to), `${from} to ${to}`);
      }
    }
});

test('robots of a wild J are told apart too', () => {
  const write = costWriter(
    /** @type {any} */ ({ all: [{ cost: 47_607_812 }, { cost: 47_644_840 }, { cost: 5e7 }] }),
  );
  assert.deepEqual([47_607_812, 47_644_840, Infinity].map(write), ['4.7608×10⁷', '4.7645×10⁷', '∞']);
  const alike = costWriter(/** @type {any} */ ({ all: [{ cost: 1e7 }, { cost: 1e7 }, { cost: 2e7 }] }));
  assert.equal(alike(12_345_678), '1.23×10⁷');
});

test('of random search, which keeps only the best of all, nothing is said to be lost', () => {
  for (const [before, after] of [
    [8.228, 8.3],
    [8.3, 8.228],
  ])
    for (const words of [en, ko]) {
      const told = words.bestText('random', before, after, costText);
      assert.ok(told.includes('8.228') && told.includes('8.300'), told);
      assert.doesNotMatch(told, /rises|falls|forgets|내려|올라|잊/);
    }
});

test('where nothing is driven, no rate is said to be another', () => {
  const experiment = createEngine().experiment('velocity-limits');
  const there = { ...experiment, starts: [experiment.goal].map((goal) => ({ ...goal, x: goal.x - 0.5 })) };
  const arrived = { ...there, tolerance: { ...there.tolerance, position: 1 } };
  const summary = summaryOf(createEngine().stability(arrived, [3, 1, 5]), arrived, [3, 1, 5]);
  assert.equal(summary.seconds, 0);
  assert.match(noteText(summary), /nothing is driven/);
  assert.doesNotMatch(noteText(summary), /V̇/);
});

test('J beside an aim stands on the side on which it is', () => {
  for (const limit of [7.9354, 7.93543001, 103.04, 20_000.55, 1e9])
    for (const by of [0, 1e-9, -1e-9, 1e-5, -1e-5, 0.01, -0.01, 1]) {
      const text = costBeside(limit + by, limit);
      assert.equal(Number(text) < limit, limit + by < limit, `${text} beside ${limit}`);
    }
  assert.equal(costBeside(7.6, 7.9), costText(7.6));
  assert.equal(costBeside(Number.POSITIVE_INFINITY, 7.9), '∞');
});

test('a column of times has the digits of its step', () => {
  for (const [step, second] of /** @type {const} */ ([
    [0.01, '0.01'],
    [0.5, '0.50'],
    [0.001, '0.001'],
    [0.025, '0.025'],
    [3 * 0.1, '0.30'],
  ]))
    assert.equal(timeText(step, step), second);
});

test('what a gain below zero raises is blamed on nothing else', () => {
  const experiment = createEngine().experiment('velocity-limits');
  const gains = /** @type {const} */ ([-2, -2, -2]);
  const summary = summaryOf(createEngine().stability(experiment, gains), experiment, gains);
  assert.ok(summary.rising > 1 && summary.limited > 1);
  assert.deepEqual([summary.raised, summary.causes], [[0, 1, 2], []]);
});

test('V is told with the digits that its numbers have, and as staying where it stays', () => {
  const summary = {
    law: 'shim-kim',
    isPromised: true,
    referenceSpeed: 0,
    rising: 0,
    limited: 0,
    isLaw: true,
    seconds: 10,
  };
  const rest = { disturbed: false, raised: [], negative: [], causes: [], sampleTime: 0.01 };
  const told = (/** @type {number} */ from, /** @type {number} */ to) =>
    noteText(/** @type {any} */ ({ ...summary, ...rest, from, to }));
  assert.match(told(1_002_000, 996_000), /it goes from 1×10⁶ to 9\.96×10⁵\./);
  assert.match(told(4.2902, 4.2901), /^V never rises: it stays at 4\.29\./);
});
