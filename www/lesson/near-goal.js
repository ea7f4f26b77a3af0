// The last centimetres: where a disturbed robot stays, and the strips in which Theorem 2 lets it.
import { disturbanceSlice } from '../parts/disturbance/state.js';
import { create, svg } from '../kit/elements.js';
import { watch } from '../kit/memo.js';

/** @typedef {import('./page.js').Live} Live */
/** @typedef {import('../core/engine.js').Posture} Posture */
/** @typedef {import('../core/engine.js').Run} Run */
/** @typedef {{ near: { again: string, caption: (across: number, time: number, distance: number) => string, label: (across: number, distance: number) => string } }} NearWords */

/** Metres from the goal to the edge, doubled until the robot's end is well inside. */
const nearest = 0.1;
const farthest = 6.4;
/** Of the picture, from the middle to its edge. */
const reach = 100;

/** @param {import('./page.js').Tools} tools @param {NearWords} words @returns {import('./page.js').Block} */
export function createNearGoal({ actions }, { near: words }) {
  const [stripX, stripY] = ['x', 'y'].map((part) => svg('rect', { class: `near-set of-${part}` }));
  const strips = svg('g', {}, stripY, stripX);
  const calm = svg('path', { class: 'near-calm' });
  const path = svg('path', { class: 'near-path' });
  const arrow = 'M13,0L-9,-8L-4,0L-9,8Z';
  const goal = svg('path', { class: 'near-end', d: arrow });
  const robot = svg('path', { class: 'near-robot', d: arrow });
  const picture = svg(
    'svg',
    { viewBox: `${-reach} ${-reach} ${2 * reach} ${2 * reach}`, role: 'img' },
    ...[strips, calm, path, goal, robot],
  );
  const caption = create('p', 'muted');
  const button = create('button', 'link', words.again);
  button.setAttribute('type', 'button');
  button.addEventListener('click', () => {
    actions.scrub(0);
    actions.togglePlay();
  });
  const element = create(
    'div',
    'near-goal',
    create('div', 'near-picture', picture),
    create('div', 'near-text', caption, button),
  );
  element.id = 'near-goal';
  const driveChanged = watch();
  const timeChanged = watch();

  return {
    element,
    /** @param {Live} live */
    draw({ state, scene }) {
      const { driving, comparison, withoutDisturbance, experiment } = scene;
      const { measured } = disturbanceSlice.of(state);
      const end = experiment.goal;
      const half = halfOf(driving, end);
      const scale = reach / half;
      const distance = (/** @type {number} */ i) => Math.hypot(driving.x[i] - end.x, driving.y[i] - end.y);
      if (driveChanged(driving, comparison, withoutDisturbance, measured)) {
        path.setAttribute('d', trace(driving, end, scale));
        calm.setAttribute('d', withoutDisturbance ? trace(comparison, end, scale) : '');
        place(goal, end, end, scale);
        strips.setAttribute('transform', `rotate(${-degrees(end.theta)})`);
        const { x, y } = measured?.disturbed.sets ?? { x: [0], y: [0] };
        const far = 10 * reach;
        const [wide, high] = [x[0], y[0]].map((set) => Math.min(set * scale, far));
        box(stripX, wide, far);
        box(stripY, far, high);
        const last = driving.time.length - 1;
        picture.setAttribute('aria-label', words.label(2 * half, distance(last)));
      }
      const time = Math.min(state.robot.time, driving.finalTime);
      if (!timeChanged(driving, time)) return;
      const at = indexAt(driving, time);
      place(robot, { x: driving.x[at], y: driving.y[at], theta: driving.theta[at] }, end, scale);
      caption.textContent = words.caption(2 * half, driving.time[at], distance(at));
    },
  };
}

/** @param {Run} run @param {Posture} goal */
function halfOf({ x, y }, goal) {
  const left = Math.hypot(x[x.length - 1] - goal.x, y[y.length - 1] - goal.y);
  let half = nearest;
  while (half < farthest && left > 0.8 * half) half *= 2;
  return half;
}

/** @param {Run} run @param {number} now */
const indexAt = ({ time }, now) => Math.min(Math.round(now / (time[1] - time[0] || 1)), time.length - 1);

/** @param {number} radians */
const degrees = (radians) => (radians * 180) / Math.PI;

/** The way as far as it lies about the picture. @param {Run} run @param {Posture} goal @param {number} scale */
function trace({ x, y }, goal, scale) {
  const points = [];
  for (const [i, metres] of x.entries()) {
    const [px, py] = [(metres - goal.x) * scale, (goal.y - y[i]) * scale];
    points.push(`${px.toFixed(1)},${py.toFixed(1)}`);
  }
  return `M${points.join('L')}`;
}

/** @param {Element} element @param {Posture} posture @param {Posture} goal @param {number} scale */
function place(element, { x, y, theta }, goal, scale) {
  const [px, py] = [(x - goal.x) * scale, (goal.y - y) * scale];
  element.setAttribute('transform', `translate(${px} ${py}) rotate(${-degrees(theta)})`);
}

/** A box around the middle. @param {Element} element @param {number} wide @param {number} high */
function box(element, wide, high) {
  for (const [name, value] of Object.entries({ x: -wide, y: -high, width: 2 * wide, height: 2 * high }))
    element.setAttribute(name, String(value));
}
