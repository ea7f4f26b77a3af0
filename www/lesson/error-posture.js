// The error posture on the plane: x_e and y_e as lengths along and across the goal's heading, θ_e as an angle at the robot.
import { svg } from '../kit/elements.js';
import { createView } from '../kit/transform.js';
import { watch } from '../kit/memo.js';
import { symbolInText } from './symbols.js';

/** @import { Live } from './page.js' */

/** Of the angle at the robot, which stays within a low plane. @param {{ width: number, height: number }} size */
const radiusIn = ({ width, height }) => Math.min(56, Math.max(28, Math.min(width, height) / 6));

/** @param {HTMLElement} root The svg, and beside it the labels. */
export function createErrorPosture(root) {
  const picture = svg('svg', { 'aria-hidden': 'true' });
  const names = /** @type {const} */ ([
    ['xe', 'x'],
    ['ye', 'y'],
    ['te', 'theta'],
  ]);
  const parts = names.map(([name, colour]) => {
    const path = svg('path', { class: `error-line of-${colour}` });
    const grip = svg('path', { class: 'error-grip' });
    const group = svg('g', { 'data-term': name }, path, grip);
    const label = document.createElement('span');
    label.className = `error-label of-${colour}`;
    label.dataset.term = name;
    label.append(symbolInText(name));
    return { path, grip, group, label };
  });
  const ahead = svg('path', { class: 'error-ahead' });
  picture.append(ahead, ...parts.map(({ group }) => group));
  root.replaceChildren(picture, ...parts.map(({ label }) => label));
  const changed = watch();

  let size = { width: 0, height: 0 };
  /** Within the plane. @param {number} at @param {number} end */
  const clamp = (at, end) => Math.max(16, Math.min(end - 16, at));
  /** @param {number} i @param {string} path @param {number} x @param {number} y @param {boolean} seen */
  const place = (i, path, x, y, seen) => {
    const { path: line, grip, label, group } = parts[i];
    line.setAttribute('d', path);
    grip.setAttribute('d', path);
    group.classList.toggle('gone', !seen);
    label.hidden = !seen;
    const [left, top] = [clamp(x, size.width), clamp(y, size.height)];
    label.style.transform = `translate(${left}px, ${top}px) translate(-50%, -50%)`;
  };

  return {
    /** @param {boolean} hidden */
    hide(hidden) {
      root.hidden = hidden;
    },
    /** @param {Live} live */
    draw({ state, sample }) {
      if (state.size.width === 0 || !changed(sample, state.box, state.size)) return;
      size = state.size;
      const radius = radiusIn(size);
      const view = createView(state.box, state.size);
      const { posture, reference, error } = sample;
      const at = (/** @type {number} */ x, /** @type {number} */ y) => [view.screenX(x), view.screenY(y)];
      const [cos, sin] = [Math.cos(reference.theta), Math.sin(reference.theta)];
      // On the goal's own axis, beside the robot.
      const corner = at(reference.x - error.x * cos, reference.y - error.x * sin);
      const robot = at(posture.x, posture.y);
      const goal = at(reference.x, reference.y);
      const line = (/** @type {number[]} */ from, /** @type {number[]} */ to) => `M${from}L${to}`;
      const apart = (/** @type {number[]} */ [ax, ay], /** @type {number[]} */ [bx, by]) =>
        Math.hypot(bx - ax, by - ay);
      // Beside the middle of its line, away from the third corner.
      const beside = (
        /** @type {number[]} */ [ax, ay],
        /** @type {number[]} */ [bx, by],
        /** @type {number[]} */ [ox, oy],
      ) => {
        const [nx, ny] = [by - ay, ax - bx];
        const side = Math.sign(nx * (ax - ox) + ny * (ay - oy)) || 1;
        const length = Math.hypot(nx, ny) || 1;
        return [(ax + bx) / 2 + (18 * side * nx) / length, (ay + by) / 2 + (18 * side * ny) / length];
      };
      const [xx, xy] = beside(corner, goal, robot);
      const [yx, yy] = beside(robot, corner, goal);
      place(0, line(corner, goal), xx, xy, apart(corner, goal) > 4);
      place(1, line(robot, corner), yx, yy, apart(robot, corner) > 4);
      const from = posture.theta;
      const to = posture.theta + error.theta;
      const [fx, fy] = [robot[0] + radius * Math.cos(from), robot[1] - radius * Math.sin(from)];
      const [tx, ty] = [robot[0] + radius * Math.cos(to), robot[1] - radius * Math.sin(to)];
      const sweep = error.theta > 0 ? 0 : 1;
      const middle = (from + to) / 2;
      place(
        2,
        `M${fx},${fy}A${radius},${radius} 0 0 ${sweep} ${tx},${ty}`,
        robot[0] + (radius + 18) * Math.cos(middle),
        robot[1] - (radius + 18) * Math.sin(middle),
        Math.abs(error.theta) > 0.03,
      );
      const beyond = (/** @type {number} */ angle) =>
        `M${robot}l${(radius + 12) * Math.cos(angle)},${-(radius + 12) * Math.sin(angle)}`;
      ahead.setAttribute('d', beyond(from) + beyond(to));
    },
  };
}
