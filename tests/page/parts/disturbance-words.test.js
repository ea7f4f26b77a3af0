// What Disturbance says in whole sentences.
import assert from 'node:assert/strict';
import { createSpec } from '../../../www/parts/disturbance/request.js';
import { tried } from '../../../www/run/scene.js';
import { hasAnother, placeOf, summarize } from '../../../www/parts/disturbance/summary.js';
import * as en from '../../../www/parts/disturbance/words/en.js';
import * as korean from '../../../www/parts/disturbance/words/ko.js';
import * as core from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../../../www/parts/disturbance/summary.js').Summary} Summary */

const { experiment, remainingErrors, startsOnCircle } = core;
const ko = /** @type {typeof en} */ (/** @type {unknown} */ (korean));
const preset = experiment('velocity-limits');
const circle = { x: 2, y: 2, radius: Math.hypot(2, 2), count: 32, seed: 1 };

/** @param {Partial<Experiment['disturbance']>} disturbance @param {[number, number, number]} gains @param {Partial<Experiment>} [more] @param {number} [count] */
function summaryOf(disturbance, gains, more, count = circle.count) {
  const starts = [...preset.starts, ...startsOnCircle({ ...circle, count })];
  const tolerance = { position: 0, heading: 0 };
  const own = experiment({ ...preset, starts, tolerance, ...more });
  const disturbed = experiment({ ...own, disturbance });
  const calm = remainingErrors(own, gains, 2);
  const spec = { experiment: disturbed, gains, seconds: 2 };
  return summarize({ spec, runs: [], disturbed: remainingErrors(disturbed, gains, 2), calm });
}

test('the theorem is called upon only where it speaks of the law and the gains that drive', () => {
  /** @param {typeof en} words @param {Experiment['law']} law @param {[number, number, number]} gains @param {Experiment['disturbance']['kind']} kind */
  const said = (words, law, gains, kind) =>
    words.summaryText(summaryOf({ kind, linear: 0.1, angular: 0.1 }, gains, { law }, 1));
  for (const [words, promise, sets, others] of /** @type {const} */ ([
    [en, /lets the error go to 0/, /\bsets?\b.*how soon/, /1 other start,/],
    [ko, /0에 수렴/, /집합.*얼마나 빨리/, /다른 출발점 1개/],
  ]))
    for (const kind of /** @type {const} */ (['none', 'slip'])) {
      const promised = said(words, 'shim-kim', [3, 1, 5], kind);
      assert.match(promised, kind === 'none' ? promise : sets);
      assert.match(promised, others);
      for (const told of [
        said(words, 'kanayama', [3, 1, 5], kind),
        said(words, 'shim-kim', [3, -0.01, 5], kind),
        said(words, 'shim-kim', [3, 0, 5], kind),
      ])
        for (const wrong of [promise, sets, /how soon|얼마나 빨리/, /all three|세 집합/])
          assert.doesNotMatch(told, wrong);
    }
});

test('a verdict does not hang on the digits that are shown: what shows the same is on the edge', () => {
  for (const scale of [1e-9, 1e-5, 1e-3, 0.1, 1, 50, 1e6])
    for (let percent = 80; percent <= 120; percent += 0.25) {
      const [error, set] = [(scale * percent) / 100, scale * 1.0049];
      const place = placeOf(error, set);
      const ratio = error / set;
      assert.equal(place, ratio > 1.01 ? 'outside' : ratio > 0.99 ? 'edge' : 'inside', `${error} ${set}`);
      if (en.sizeText(error) === en.sizeText(set)) assert.equal(place, 'edge', `${error} ${set}`);
    }
  assert.equal(placeOf(0, 0), 'inside');
  assert.equal(placeOf(Number.POSITIVE_INFINITY, 1), 'outside');
  assert.equal(placeOf(Number.NaN, 1), 'outside');
});

test('sizes have three digits, however small they are', () => {
  for (const [size, text] of /** @type {const} */ ([
    [0, '0'],
    [0.0004 / 3.23673, '1.24×10⁻⁴'],
    [0.00999, '0.00999'],
    [0.03, '0.0300'],
    [0.034119, '0.0341'],
    [99.96, '100'],
    [1234, '1234'],
    [142_000, '1.42×10⁵'],
    [Number.POSITIVE_INFINITY, '∞'],
  ]))
    assert.equal(en.sizeText(size), text);
});

test('of the default slip nobody stays inside all three, many stand on an edge, and both languages say so', () => {
  const { gains } = core.evolve(preset);
  const summary = summaryOf(
    { kind: 'slip', linear: 0.1, angular: 0.2 },
    /** @type {[number, number, number]} */ ([...gains]),
  );
  assert.deepEqual([summary.allInside, summary.allEdge], [0, 11]);
  assert.deepEqual(
    Object.values(summary.rows).map(({ place }) => place),
    ['edge', 'inside', 'edge'],
  );
  assert.match(
    en.summaryText(summary),
    /^In the last 2 s this drive comes within 1 % of the edge of sets \(6\) and \(8\)\. Of 32 other starts, none stays within reach of all three, 11 within 1 % of an edge; even/,
  );
  assert.match(en.captionText(summary), /≈: edge ± 1 %$/);
  assert.match(
    ko.summaryText(summary),
    /집합 \(6\), \(8\)의 경계\(±1%\)에.*32개 중 세 집합의.* 것은 0개, 경계\(±1%\)에 이르는 것은 11개/,
  );
});

test('how many stay and how many stand on an edge is said of one, of none and of all', () => {
  const summary = summaryOf({ kind: 'slip', linear: 0.1, angular: 0.2 }, [3, 1, 5]);
  const said = (/** @type {Partial<Summary>} */ counts) => en.summaryText({ ...summary, ...counts });
  for (const [allInside, allEdge, text] of /** @type {const} */ ([
    [0, 0, 'none stays within reach of all three; even'],
    [1, 1, '1 stays within reach of all three, 1 within 1 % of an edge; even'],
    [2, 30, '2 stay within reach of all three, 30 within 1 % of an edge; even'],
    [32, 0, '32 stay within reach of all three; even'],
  ]))
    assert.ok(said({ allInside, allEdge }).includes(`Of 32 other starts, ${text}`), text);
});

test('a set against which nothing pushes is judged of nobody', () => {
  const ep = /** @type {[number, number, number]} */ ([...core.paperGains('velocity-limits', 'ep')]);
  for (const [linear, angular, pushed, all] of /** @type {const} */ ([
    [0.1, 0, ['x', 'y'], 'sets (6) and (7)'],
    [0, 0.2, ['theta'], 'set (8)'],
  ])) {
    const summary = summaryOf({ kind: 'slip', linear, angular }, ep);
    assert.deepEqual(summary.pushed, pushed);
    for (const [part, { place }] of Object.entries(summary.rows))
      assert.equal(place === null, !summary.pushed.some((one) => one === part), part);
    assert.ok(en.summaryText(summary).includes(`within reach of ${all}`), en.summaryText(summary));
  }
  const still = summaryOf({ kind: 'slip', linear: 0, angular: 0 }, ep);
  assert.match(en.summaryText(still), /^Without a disturbance/);
});

test('a set that reaches to a metre or more is said to promise little', () => {
  for (const [ky, isWide] of /** @type {const} */ ([
    [1e-4, true],
    [1, false],
  ])) {
    const summary = summaryOf({ kind: 'slip', linear: 0.1, angular: 0.2 }, [3, ky, 5]);
    assert.equal(summary.rows.y.set >= 1, isWide);
    assert.equal(en.summaryText(summary).includes(': it promises little.'), isWide);
    assert.equal(ko.summaryText(summary).endsWith('보장하는 것이 거의 없습니다.'), isWide);
  }
});

test('why there are fewer other starts than usual is said where they are', () => {
  const specOf = createSpec(/** @type {any} */ (core), []);
  const state = (/** @type {Partial<Experiment>} */ more) =>
    /** @type {any} */ ({
      experiment: experiment({ ...preset, ...more }),
      tried: { kind: 'slip', linear: 0.1, angular: 0.2, seed: 1 },
      trial: { start: null, disturbance: null },
      driver: 'hand',
      handGains: [3, 1, 5],
    });
  for (const [more, others, english] of /** @type {const} */ ([
    [{ horizon: 10 }, 32, null],
    [{ horizon: 1000 }, 2, /Only 2 other starts instead of 32: a drive of 1000 s has 100\u202f000 samples\./],
    [
      { sampleTime: 0.001 },
      20,
      /Only 20 other starts instead of 32: a drive of 10 s has 10\u202f000 samples\./,
    ],
  ])) {
    const spec = specOf(state(more));
    assert.equal(spec.experiment.starts.length, others + 1);
    const { horizon, sampleTime } = spec.experiment;
    const summary = {
      ...summaryOf(spec.experiment.disturbance, [3, 1, 5]),
      starts: others,
      horizon,
      samples: horizon / sampleTime,
    };
    const said = [en.summaryText(summary), ko.summaryText(summary)];
    if (english) assert.match(said[0], english);
    else assert.doesNotMatch(said[0], /instead/);
    assert.equal(said[1].includes('32개가 아니라'), english !== null);
  }
});

test('what is tried is called so where the experiment has another disturbance', () => {
  const slip = { kind: /** @type {const} */ ('slip'), linear: 0.1, angular: 0.2, seed: 1 };
  for (const [own, expected] of /** @type {const} */ ([
    [{ ...slip, kind: 'none' }, false],
    [slip, false],
    [{ ...slip, linear: 0, angular: 0 }, false],
    [{ ...slip, kind: 'random' }, true],
    [{ ...slip, linear: -0.1 }, true],
  ]))
    assert.equal(hasAnother(own, slip), expected, JSON.stringify(own));
  const own = { ...slip, kind: /** @type {const} */ ('random') };
  assert.equal(en.ownText(own), 'only tried here; in the experiment: random, 0.1 m/s, 0.2 rad/s');
  assert.match(ko.ownText(own), /실험의 외란: 무작위, 0.1 m\/s, 0.2 rad\/s/);
});

test('put on the goal it is pushed and drives, in the measurement as on the plane; elsewhere it begins where it was put', () => {
  const disturbance = { kind: /** @type {const} */ ('slip'), linear: 0.1, angular: 0.2, seed: 1 };
  const specOf = createSpec(/** @type {any} */ (core), []);
  /** @param {Partial<Experiment>} more @param {import('../harness/core.js').Experiment['starts'][number]} start */
  const beganAt = (more, start) => {
    const trial = { start, disturbance };
    const own = experiment({ ...preset, ...more });
    const state = { experiment: own, tried: disturbance, trial, driver: 'hand', handGains: [3, 1, 5] };
    const driven = tried(own, trial);
    assert.deepEqual(specOf(/** @type {any} */ (state)).experiment.starts[0], driven.starts[0]);
    return { from: driven.starts[0], run: core.simulate(driven, [3, 1, 5], 0) };
  };
  for (const theta of [0, 1, -Math.PI, 100, -100]) {
    const goal = { x: 2, y: 2, theta };
    for (const turns of Math.abs(theta) === 100 ? [0] : [0, 2 * Math.PI])
      assert.equal(beganAt({ goal }, { ...goal, theta: theta + turns }).run.finalTime, 10, `${theta}`);
    const beside = { ...goal, theta: theta * 0.99 + 1e-3 };
    assert.equal(beganAt({ goal }, beside).from, beside);
  }
  const moving = { referenceVelocity: { linear: 0.1, angular: 0 } };
  assert.equal(beganAt(moving, preset.goal).from, preset.goal);
});
