// Where the names of start and goal stand on the plane.
import assert from 'node:assert/strict';
import { around, meet, namesIn, roomOf } from '../../../www/lab/plane-names.js';
import { test } from '../harness/once.js';

/** A canvas that measures letters of 7 px. */
const measuring = {
  getContext: () => ({ measureText: (/** @type {string} */ text) => ({ width: 7 * text.length }) }),
};

test('the name of the goal leaves the mark above a pinned robot at rest alone', (t) => {
  const { document } = globalThis;
  t.after(() => Object.assign(globalThis, { document }));
  Object.assign(globalThis, { document: { createElement: () => measuring } });
  const view = {
    width: 600,
    height: 600,
    scale: 200,
    screenX: (/** @type {number} */ x) => 100 + 200 * x,
    screenY: (/** @type {number} */ y) => 500 - 200 * y,
  };
  const ends = { start: { x: 0, y: 0, theta: 0 }, goal: { x: 2, y: 2, theta: Math.PI / 4 } };
  const ending = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {any} */ ({ x: [0, x], y: [0, y] });
  for (const isPaid of [true, false])
    for (const x of [1.9, 1.95, 2.05, 2.1])
      for (const y of [1.85, 1.95, 2, 2.05]) {
        const names = namesIn(/** @type {any} */ (view), ends, ending(2, 2), isPaid, [ending(x, y)]);
        const mark = around(view.screenX(x), view.screenY(y) - 20, 7);
        assert.deepEqual(
          names.map(({ text }) => text),
          ['Start', 'Goal'],
        );
        assert.ok(
          names.every((name) => !meet(roomOf(name), mark)),
          `${isPaid}, ${x}, ${y}`,
        );
      }
});
