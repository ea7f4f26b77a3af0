// Where the dots of the gains stand that the seeds ended with.
import assert from 'node:assert/strict';
import { dotsIn } from '../../../www/parts/luck/strips.js';
import { test } from '../harness/once.js';

test('twenty seeds that end at one place are twenty dots that one can count', () => {
  for (const room of [30, 22.7]) {
    const diameter = room / 5;
    for (const positions of [Array(20).fill(40), Array.from({ length: 20 }, (_, i) => 40 + (i % 3))]) {
      const { along, away } = dotsIn(positions, diameter, room, [0, 300]);
      for (let i = 0; i < 20; i += 1) {
        assert.ok(Math.abs(along[i] - positions[i]) <= 2.5 * diameter && away[i] <= room - diameter / 2);
        for (let k = 0; k < i; k += 1)
          assert.ok(Math.hypot(along[i] - along[k], away[i] - away[k]) >= diameter - 1e-9);
      }
    }
  }
  // A hundred overlap, each above its own place.
  const many = dotsIn(Array(100).fill(40), 5, 30, [0, 300]);
  assert.ok(Math.max(...many.away) <= 30 - 2.5);
  assert.deepEqual(new Set(many.along), new Set([40]));
});
