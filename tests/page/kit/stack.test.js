// Where dots stand that would lie on each other.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { stacked } from '../../../www/kit/stack.js';
import { test } from '../harness/once.js';

test('no dot stands on another, none floats, and none is further aside than it may', () => {
  fc.assert(
    fc.property(
      fc.array(fc.integer({ min: 0, max: 14 }), { maxLength: 60 }),
      fc.integer({ min: 1, max: 8 }),
      fc.integer({ min: 0, max: 3 }),
      (columns, lines, reach) => {
        const places = stacked(columns, lines, reach, [0, 14]);
        const taken = new Set(places.map(({ column, level }) => `${column} ${level}`));
        assert.equal(taken.size, columns.length);
        for (const [i, { column, level }] of places.entries()) {
          assert.ok(Math.abs(column - columns[i]) <= reach && column >= 0 && column <= 14);
          assert.ok(level === 0 || taken.has(`${column} ${level - 1}`));
          // Aside, or above the room, only where its own column is full.
          if (column !== columns[i] || level >= lines) assert.ok(taken.has(`${columns[i]} ${lines - 1}`));
          if (level >= lines) assert.equal(column, columns[i]);
        }
      },
    ),
  );
});
