// Between the plane in metres and a picture in pixels.
import assert from 'node:assert/strict';
import fc from 'fast-check';
import { boxAround, createView, knobOf, refit, viewAround } from '../../../www/kit/transform.js';
import { test } from '../harness/once.js';

const number = fc.double({ min: -20, max: 20, noNaN: true });
const point = fc.record({ x: number, y: number });
const side = fc.integer({ min: 50, max: 2000 });
const size = fc.record({ width: side, height: side });

/** @param {number} a @param {number} b */
const isNear = (a, b) => assert.ok(Math.abs(a - b) < 1e-6, `${a}, ${b}`);

test('what is pressed is the point that is drawn there', () => {
  fc.assert(
    fc.property(size, point, point, (size, a, b) => {
      for (const view of [createView(boxAround([a, b]), size), viewAround(a, 3, size)]) {
        const { x, y } = view.world(view.screenX(b.x), view.screenY(b.y));
        isNear(x, b.x);
        isNear(y, b.y);
      }
    }),
  );
});

test('around a centre just its radius has room on every side, and up is up', () => {
  fc.assert(
    fc.property(size, point, fc.double({ min: 0.1, max: 9, noNaN: true }), (size, { x, y }, radius) => {
      const { screenX, screenY } = viewAround({ x, y }, radius, size);
      isNear(screenX(x), size.width / 2);
      isNear(screenY(y), size.height / 2);
      isNear(Math.min(screenX(x - radius), screenY(y + radius)), 0);
      isNear(screenX(x + radius) - screenX(x), screenY(y) - screenY(y + radius));
    }),
  );
});

test('where little of the picture is left to what must be seen, the box comes nearer', () => {
  const size = { width: 800, height: 600 };
  const box = boxAround([
    { x: 0, y: 0 },
    { x: 8, y: 8 },
  ]);
  const near = [
    { x: 3, y: 3 },
    { x: 5, y: 5 },
  ];
  assert.deepEqual(refit(box, size, near), boxAround(near));
  const nearly = [
    { x: 1, y: 1 },
    { x: 7, y: 7 },
  ];
  assert.equal(refit(box, size, nearly), box);
});

test('the knob of a posture lies straight ahead of it, within the plane and before its arrow, wherever the plane ends', () => {
  const room = fc.record({
    width: fc.integer({ min: 240, max: 2000 }),
    height: fc.integer({ min: 110, max: 1200 }),
  });
  const theta = fc.double({ min: -Math.PI, max: Math.PI, noNaN: true });
  fc.assert(
    fc.property(room, point, point, theta, ({ width, height }, start, goal, theta) => {
      const view = createView(boxAround([start, goal]), { width, height });
      const { px, py } = knobOf(view, { ...goal, theta });
      const [across, up] = [px - view.screenX(goal.x), view.screenY(goal.y) - py];
      isNear(Math.cos(Math.atan2(up, across) - theta), 1);
      const away = Math.hypot(across, up);
      assert.ok(away > 25.9 && away < 52.1, `${away} px away`);
      const inside = Math.min(px, width - px, py, height - py);
      assert.ok(inside > 7.9, `${inside} px within the edge`);
    }),
    { numRuns: 1000 },
  );
});
