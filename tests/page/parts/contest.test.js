// The contest: its numbers are those of the core's trials, counted here once more; and its CSV.
import assert from 'node:assert/strict';
import { trials } from '../../../pkg/ep_locomotion.js';
import { isTooLongSurvey, mostRobotsOfCall } from '../../../www/core/bounds.js';
import { partsOf } from '../../../www/parts/luck/contest-asked.js';
import { contestants, entered, ingredientNames } from '../../../www/parts/luck/contestants.js';
import { pairsText, targetText } from '../../../www/parts/luck/words/common.js';
import * as en from '../../../www/parts/luck/words/contest-en.js';
import * as ko from '../../../www/parts/luck/words/contest-ko.js';
import { contestCsv, standingsOf } from '../../../www/parts/luck/contest-summary.js';
import { test } from '../harness/once.js';
import { contestOf, others, small, velocityLimits } from './contests.js';

test('every contestant runs, and every ingredient is another search', () => {
  const [lab] = contestOf([], 1, 3000).lines;
  for (const name of contestants) {
    const [run] = trials(entered(velocityLimits, name), { seeds: [1, 2], drives: 3000 });
    assert.ok(Number.isFinite(run.champion.cost), name);
    if (ingredientNames.some((one) => one === name) && name !== 'mirror')
      assert.notDeepEqual(run, lab.trials[0], name);
  }
});

test('the trials of a seed are the same in whatever batch it runs', () => {
  for (const name of [null, ...others]) {
    const [alone] = trials(entered(velocityLimits, name), { seeds: [11, 12], drives: 1000 });
    const line = small.lines.find((one) => one.name === name);
    assert.deepEqual(alone, line?.trials[10]);
  }
});

test('no part of a contest is more than the core takes in one call, and parts are no smaller than they must be', () => {
  const starts = (/** @type {number} */ count) =>
    Array.from({ length: count }, (_, i) => ({ x: 0, y: i / 100, theta: 0 }));
  for (const change of [
    {},
    { starts: starts(32) },
    { starts: starts(7), horizon: 3 },
    { horizon: 30, sampleTime: 0.001 },
    { horizon: 0.1 },
  ]) {
    const experiment = { ...velocityLimits, ...change };
    const most = mostRobotsOfCall(experiment);
    assert.throws(
      () => trials(experiment, { seeds: [1, 1001], drives: 20_000_000 }),
      (/** @type {Error} */ { message }) => new RegExp(`at most ${most} with `).test(message),
    );
    for (const budget of [1000, 4000, 20_000].filter((drives) => drives <= most)) {
      const parts = partsOf(experiment, { seeds: 51, budget });
      assert.deepEqual(
        parts.flatMap(([from, to]) => Array.from({ length: to - from }, (_, i) => from + i)),
        Array.from({ length: 51 }, (_, i) => i + 1),
      );
      const largest = Math.max(...parts.map(([from, to]) => to - from));
      assert.ok(largest * budget <= most);
      assert.ok(largest === 8 || (largest + 1) * budget > most, `${largest} of ${most} with ${budget}`);
    }
  }
});

test('what takes longer than anybody waits is too long, whether of many drives or of long ones', () => {
  const sampled = { ...velocityLimits, sampleTime: 0.001 };
  for (const [horizon, isTooLong] of /** @type {const} */ ([
    [30, false],
    [100, true],
  ]))
    assert.equal(isTooLongSurvey({ ...sampled, horizon }, 8_080_000), isTooLong);
});

test('the usual target is 0.2 % above the lowest of all, and the standings follow from the trials', () => {
  const { lowest, target, lines } = standingsOf(small);
  const costs = small.lines.map((line) => line.trials.map(({ champion }) => champion.cost));
  const least = Math.min(...costs.flat());
  assert.equal(lowest?.cost, least);
  assert.equal(target, least + 0.002 * least);
  const winner = small.lines.find(({ name }) => name === lowest?.name)?.trials[(lowest?.seed ?? 0) - 1];
  assert.equal(winner?.champion.cost, least);
  for (const [i, line] of lines.entries()) {
    const spent = small.lines[i].trials.map(({ drives, costs: fallen }) => {
      const at = fallen.findIndex((cost) => cost <= target);
      return at < 0 ? null : drives[at];
    });
    const there = spent.filter((one) => one !== null);
    assert.equal(line.reached, there.length);
    const sum = spent.reduce((total, one) => (total ?? 0) + (one ?? 1000), 0) ?? 0;
    assert.equal(line.ert, there.length === 0 ? Infinity : sum / there.length);
    assert.equal(line.median, costs[i].toSorted((a, b) => a - b)[7]);
  }
});

test('verdicts say what the ranks say', () => {
  const twice = {
    ...small,
    lines: [small.lines[0], { ...small.lines[0], name: /** @type {const} */ ('mirror') }],
  };
  assert.deepEqual(standingsOf(twice).lines[1].verdict, { kind: 'same', runs: 15, isBefore: false });
  // The first robots are the same whatever comes of them.
  assert.deepEqual(standingsOf(small, { until: 15 }).lines[2].verdict, {
    kind: 'same',
    runs: 15,
    isBefore: true,
  });
  // A target that everybody meets at the first drive tells nobody apart.
  const easy = standingsOf(small, { target: 1e9 });
  for (const line of easy.lines.slice(1)) assert.equal(line.verdict?.kind, 'undecided');
  const [first] = small.lines;
  const slower = first.trials.map((trial) => ({ ...trial, drives: trial.drives.map((drive) => 3 * drive) }));
  const late = {
    ...small,
    budget: 3000,
    lines: [first, { name: /** @type {const} */ ('de'), trials: slower, error: '' }],
  };
  // So near that all reach it, so far that they do not at once.
  const target = Math.max(...first.trials.map(({ champion }) => champion.cost));
  const { verdict } = standingsOf(late, { target }).lines[1];
  assert.ok(verdict?.kind === 'later' && Math.abs(verdict.times - 3) < 1e-12, JSON.stringify(verdict));
});

test('what is read after fewer drives, or of fewer seeds, is what a shorter contest with them says', () => {
  const shorter = standingsOf(contestOf(others, 15, 400), { target: 7.9 });
  const read = standingsOf(small, { target: 7.9, until: 400 });
  assert.deepEqual(
    read.lines.map(({ ert, median, comparison }) => ({ ert, median, comparison })),
    shorter.lines.map(({ ert, median, comparison }) => ({ ert, median, comparison })),
  );
  const five = standingsOf(contestOf(others, 5, 1000), { target: 7.9 });
  const few = standingsOf(small, { target: 7.9, only: 5 });
  for (const [i, line] of five.lines.entries()) {
    assert.deepEqual(few.lines[i].comparison, line.comparison);
    assert.deepEqual(few.lines[i].verdict, line.verdict);
    assert.deepEqual(few.lines[i].interval, line.interval);
  }
  // The usual target is that of all runs.
  assert.equal(standingsOf(small, { only: 5 }).target, standingsOf(small).target);
  const drawn = standingsOf(small, { only: 5, draw: 3 }).drawn.map(({ trials: runs }) =>
    runs.map(({ seed }) => seed),
  );
  assert.ok(drawn.every((seeds) => String(seeds) === String(drawn[0]) && new Set(seeds).size === 5));
  assert.notDeepEqual(drawn[0], [1, 2, 3, 4, 5]);
});

test('at every target and budget a verdict follows from p, A12 and the expected drives alone', () => {
  const kinds = new Set();
  let nearly = 0;
  for (let i = 0; i <= 60; i += i < 20 ? 1 : 10)
    for (const until of [100, 300, 1000])
      for (const only of [6, 10, 15]) {
        const { lines } = standingsOf(small, { target: 7.71 + 0.02 * i, until, only });
        for (const { verdict, comparison, ert, reached, count, interval } of lines.slice(1)) {
          const { a12, p, share } = comparison ?? { a12: 0.5, p: 1, share: 1 };
          nearly += Number(p >= 0.05 && p < 0.1);
          const isSooner = ert < lines[0].ert;
          const more = share < 0.05 ? Math.sign(reached - lines[0].reached) : 0;
          const factors = only < 15 ? [] : [isSooner ? 'sooner' : 'later'];
          const ahead = isSooner
            ? ['better', ...factors, ...(more > 0 ? ['mostly', 'only-this'] : [])]
            : ['better', ...(more < 0 ? ['riskier'] : [])];
          const behind = isSooner
            ? ['worse', ...(more > 0 ? ['surer'] : [])]
            : ['worse', ...factors, ...(more < 0 ? ['hardly', 'only-first'] : [])];
          const told = [['hardly', 'only-first'], ['undecided'], ['mostly', 'only-this']];
          const expected = p >= 0.05 ? told[1 + more] : a12 > 0.5 ? ahead : behind;
          assert.ok(verdict && expected.includes(verdict.kind), `${verdict?.kind}: ${a12} ${p} ${ert}`);
          assert.equal(interval === null, count < 15);
          if (verdict.kind === 'undecided') {
            const isAlone = comparison !== null && comparison.alone < 0.05;
            assert.equal(verdict.alone, isAlone ? comparison.alone : null);
            assert.equal(
              /p would be 0\.0\d\d, were it alone and not one of 3/.test(en.verdictText(verdict, 'de')),
              isAlone,
            );
            assert.equal(/비교 3개에 .*p는 0\.0\d\d\)/.test(ko.verdictText(verdict, 'de')), isAlone);
          }
          kinds.add(verdict.kind);
        }
      }
  assert.ok(nearly > 5 && kinds.size >= 4, `${nearly} ${[...kinds]}`);
});

test('what is behind in most pairs and yet cheaper in the mean is said to be surer', () => {
  const run = (/** @type {number} */ seed, /** @type {number} */ at) => ({
    seed,
    drives: Float64Array.of(1, at),
    costs: Float64Array.of(9, at < 1000 ? 1 : 8),
    champion: { gains: /** @type {[number, number, number]} */ ([1, 1, 1]), cost: at < 1000 ? 1 : 8 },
  });
  const seeds = Array.from({ length: 50 }, (_, i) => i + 1);
  const fast = seeds.map((seed) => run(seed, seed % 10 < 3 ? 1000 : 10 + seed));
  const sure = seeds.map((seed) => run(seed, 200 + seed));
  /** @param {typeof fast} a @param {typeof fast} b */
  const verdictOf = (a, b) => toldOf(a, b)?.kind;
  /** @param {typeof fast} a @param {typeof fast} b */
  const toldOf = (a, b) =>
    standingsOf(
      {
        ...small,
        budget: 1000,
        seeds: 50,
        lines: [
          { name: null, trials: a, error: '' },
          { name: 'de', trials: b, error: '' },
        ],
      },
      { target: 2 },
    ).lines[1].verdict;
  // Where pairs are even it may be no chance that one fails less often.
  const often = seeds.map((seed) => run(seed, 80 + ((37 * seed) % 100)));
  const failing = seeds.map((seed) => run(seed, seed % 4 === 0 ? 1000 : 50 + ((53 * seed) % 100)));
  assert.equal(verdictOf(failing, often), 'mostly');
  assert.equal(verdictOf(often, failing), 'hardly');
  assert.equal(verdictOf(fast, sure), 'surer');
  assert.equal(verdictOf(sure, fast), 'riskier');
  // Most pairs may be decided by J alone, and then no time is told.
  const worse = seeds.map((seed) => ({ ...run(seed, 1000), costs: Float64Array.of(9, 8.5) }));
  const rare = [...worse.slice(0, 42), ...seeds.slice(42).map((seed) => run(seed, seed - 20))];
  const never = seeds.map((seed) => run(seed, seed === 50 ? 500 : 1000));
  for (const [a, b, kind] of /** @type {const} */ ([
    [never, rare, 'surer'],
    [rare, never, 'riskier'],
  ])) {
    const verdict = toldOf(a, b);
    assert.ok(verdict?.kind === kind && verdict.factor === null, JSON.stringify(verdict));
    for (const words of [en, ko]) {
      const said = words.verdictText(verdict, 'de');
      assert.doesNotMatch(said, /later|sooner|times|배|늦|빠르|null/, said);
    }
  }
  // Nobody fails where the slow ones are only late.
  const late = seeds.map((seed) => run(seed, seed % 10 < 3 ? 900 : 10 + seed));
  assert.equal(verdictOf(late, sure), 'worse');
  assert.equal(verdictOf(sure, late), 'better');
  // Runs with other seeds are not run by run the same.
  assert.equal(verdictOf(sure, sure), 'same');
  const apart = sure.map((trial) => ({ ...trial, seed: trial.seed + 50 }));
  assert.equal(verdictOf(sure, apart), 'undecided');
});

test('a target has four digits after the point, or fewer where seven count, and is read as it is written', () => {
  const values = [8.61758, 33.91144, 758042.9469, 8.8e6, 0];
  assert.deepEqual(values.map(targetText), ['8.6176', '33.9114', '758042.9', '8800000', '0.0000']);
});

test('what is not all is never told as all, nor what is not none as none', () => {
  for (const [part, whole, pairs] of /** @type {const} */ ([
    [0, '0', '0.00'],
    [0.0038, '<1', '<0.01'],
    [0.006, '1', '0.01'],
    [0.5, '50', '0.50'],
    [0.994, '99', '0.99'],
    [0.9962, '>99', '>0.99'],
    [1, '100', '1.00'],
  ])) {
    assert.equal(pairsText(part), pairs);
    const said = en.verdictText({ kind: 'better', a12: part }, 'de');
    assert.match(said, new RegExp(`^In ${whole} % of all pairs`));
    const inKorean = whole === '>99' ? '99%가 넘는' : `${whole}%의`;
    assert.ok(ko.verdictText({ kind: 'better', a12: part }, 'de').includes(` ${inKorean} 쌍에서`));
  }
});

test('the CSV has a row for each improvement', () => {
  const rows = contestCsv(small).trimEnd().split('\r\n');
  assert.equal(rows[0], 'contestant,seed,drive,J');
  const expected = small.lines.flatMap(({ name, trials: runs }) =>
    runs.flatMap(({ seed, drives, costs }) =>
      [...drives].map((drive, i) => `${name ?? 'lab'},${seed},${drive},${costs[i]}`),
    ),
  );
  assert.deepEqual(rows.slice(1), expected);
});

test('no contestant’s name reads as a list where a sentence begins with it', () => {
  for (const name of contestants) assert.doesNotMatch(en.shortName(name), /,/);
});
