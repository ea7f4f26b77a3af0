// What Disturbance says in whole sentences.
import assert from 'node:assert/strict';
import { summarize } from '../../../www/parts/disturbance/summary.js';
import * as en from '../../../www/parts/disturbance/words/en.js';
import * as ko from '../../../www/parts/disturbance/words/ko.js';
import { experiment, remainingErrors, startsOnCircle } from '../harness/core.js';
import { test } from '../harness/once.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */

const preset = experiment('velocity-limits');
const circle = { x: 2, y: 2, radius: Math.hypot(2, 2), count: 1, seed: 1 };

test('the theorem is called upon only where it speaks of the law and the gains that drive', () => {
  const starts = [...preset.starts, ...startsOnCircle(circle)];
  /** @param {typeof en} words @param {Experiment['law']} law @param {[number, number, number]} gains @param {Experiment['disturbance']['kind']} kind */
  const said = (words, law, gains, kind) => {
    const own = experiment({ ...preset, starts, law });
    const disturbed = experiment({ ...own, disturbance: { kind, linear: 0.1, angular: 0.1 } });
    const calm = remainingErrors(own, gains, 2);
    const spec = { experiment: disturbed, gains, seconds: 2 };
    const measured = { spec, runs: [], disturbed: remainingErrors(disturbed, gains, 2), calm };
    return words.summaryText(summarize(measured));
  };
  for (const [words, promise, sets, others] of /** @type {const} */ ([
    [en, /lets the error go to 0/, /\bsets?\b.*how soon/, /1 other start,/],
    [
      /** @type {typeof en} */ (/** @type {unknown} */ (ko)),
      /0에 수렴/,
      /집합.*얼마나 빨리/,
      /다른 출발점 1개/,
    ],
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
