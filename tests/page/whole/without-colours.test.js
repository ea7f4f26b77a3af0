// What colours tell is told besides: by dashes, by names where they belong, by words.
import assert from 'node:assert/strict';
import { dashes } from '../../../www/kit/palette.js';
import { linesOf } from '../../../www/parts/curves/plots.js';
import { styles } from '../../../www/run/pins.js';
import { test } from '../harness/once.js';

test('the lines of the gains differ by their dashes, whose gaps are narrower than those of pins and comparisons', () => {
  const own = Object.values(dashes);
  assert.equal(new Set(own.map(String)).size, 3);
  const widest = Math.max(...own.flatMap((dash) => dash.filter((_, i) => i % 2)));
  const lines = linesOf({ driving: 0, comparison: 0, pins: [], pinned: [] });
  const others = [...styles, ...lines].map(({ dash }) => dash).filter(({ length }) => length > 0);
  assert.equal(others.length, 5);
  for (const dash of others)
    assert.ok(
      dash.every((gap, i) => i % 2 === 0 || gap > widest),
      `${dash}`,
    );
  // And nobody takes the one of them for the other.
  const [longer, shorter] = [dashes['--y'], dashes['--theta']].map(([length]) => length);
  assert.ok(longer >= 2 * shorter);
});
