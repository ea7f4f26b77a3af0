import assert from 'node:assert/strict';
import { createColumns } from '../../../www/lab/columns.js';
import { experiment, historyOf } from '../harness/core.js';
import { test } from '../harness/once.js';

test('columns are those of the history, whatever they were of before', () => {
  const preset = experiment('velocity-limits');
  const [run, other] = [1, 2].map((seed) =>
    historyOf({ ...preset, evolution: { ...preset.evolution, seed } }, 600),
  );
  const columnsOf = createColumns(['generation', 'best', 'median', 'ky']);
  const wild = [
    {
      ...run[0],
      median: Number.POSITIVE_INFINITY,
      meanSigmas: /** @type {[number, number, number]} */ ([1, 0, 1]),
    },
  ];
  for (const history of [
    ...[run, other].flatMap((whole) => [1, 2, 255, 257, 600].map((count) => whole.slice(0, count))),
    run.slice(0, 7),
    other.slice(0, 7),
    wild,
    run,
  ])
    assert.deepEqual(columnsOf(history), {
      generation: Float64Array.from(history, (one) => one.generation),
      best: Float64Array.from(history, (one) => one.best.cost),
      median: Float64Array.from(history, (one) => (history === wild ? Number.NaN : one.median)),
      ky: Float64Array.from(history, (one) => one.meanSigmas[1] || Number.NaN),
    });
});
