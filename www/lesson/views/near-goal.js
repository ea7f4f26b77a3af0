// The last centimetres: where a disturbed robot stays, and the strips in which Theorem 2 lets it.
import { html, render } from 'lit-html';
import { create } from '../../kit/elements.js';
import { styled } from '../../kit/templates.js';
import { viewAt } from '../../kit/transform.js';
import { carOutline } from '../../lab/car.js';
import { remember, watch } from '../../kit/memo.js';
import { disturbanceSlice } from '../../parts/disturbance/state.js';
import { arePositive } from '../../parts/disturbance/summary.js';
import names from '../../parts/disturbance/words/index.js';

/** @import { Posture, Run } from '../../core/engine.js' */
/** @import { Block, Tools } from '../page.js' */
/** @typedef {{ near: { again: string, caption: (across: number, time: number, distance: number) => string, label: (across: number, distance: number) => string } }} NearWords */

/** Metres from the goal to the edge, doubled until the robot's end is well inside. */
const nearest = 0.1;
const farthest = 6.4;
/** Of the picture, from the middle to its edge. */
const reach = 100;

const arrow = 'M13,0L-9,-8L-4,0L-9,8Z';
const robotOutline = carOutline(9);

/** @param {Tools} tools @param {NearWords} words @returns {Block} */
export function createNearGoal({ actions }, { near: words }) {
  const element = create('div', { id: 'near-goal', class: 'near-goal' });
  const again = () => {
    actions.scrub(0);
    actions.togglePlay();
  };
  const [wayOf, calmWayOf] = [remember(trace), remember(trace)];
  const changed = watch();

  return {
    element,
    draw({ state, scene }) {
      const { driving, comparison, withoutDisturbance, experiment } = scene;
      const { measured } = disturbanceSlice.of(state);
      const time = Math.min(state.robot.time, driving.finalTime);
      if (!changed(driving, comparison, withoutDisturbance, measured, time)) return;
      const { goal } = experiment;
      const half = halfOf(driving, goal);
      const scale = reach / half;
      const distance = (/** @type {number} */ i) => Math.hypot(driving.x[i] - goal.x, driving.y[i] - goal.y);
      const at = indexAt(driving, time);
      const robot = { x: driving.x[at], y: driving.y[at], theta: driving.theta[at] };
      const { x, y } = setsOf(measured);
      const far = 10 * reach;
      const [wide, high] = [x[0], y[0]].map((set) => Math.min(set * scale, far));
      render(
        html`<div class="near-picture">
            <svg viewBox=${`${-reach} ${-reach} ${2 * reach} ${2 * reach}`} role="img"
              aria-label=${words.label(2 * half, distance(driving.time.length - 1))}>
              <g transform=${`rotate(${-degrees(goal.theta)})`}>
                <rect class="near-set of-y" x=${-far} y=${-high} width=${2 * far} height=${2 * high} />
                <rect class="near-set of-x" x=${-wide} y=${-far} width=${2 * wide} height=${2 * far} />
              </g>
              <path class="near-calm" d=${withoutDisturbance ? calmWayOf(comparison, goal, scale) : ''} />
              <path class="near-path" d=${wayOf(driving, goal, scale)} />
              <path class="near-end" d=${arrow} transform=${placeOf(goal, goal, scale)} />
              <path class="near-robot" d=${robotOutline} transform=${placeOf(robot, goal, scale)} />
            </svg>
            ${high > 0 ? nameOf('y', goal.theta) : ''} ${wide > 0 ? nameOf('x', goal.theta + Math.PI / 2) : ''}
          </div>
          <div class="near-text">
            <p class="muted">${words.caption(2 * half, driving.time[at], distance(at))}</p>
            <button type="button" class="link" @click=${again}>${words.again}</button>
          </div>`,
        element,
      );
    },
  };
}

/** The sets of Theorem 2, where it promises some. @param {import('../../parts/disturbance/request.js').Measured | null} measured */
function setsOf(measured) {
  const { law } = measured?.spec.experiment ?? {};
  const isPromised =
    measured && law && names.isPromised({ law, isPositive: arePositive(measured.spec.gains) });
  return isPromised ? measured.disturbed.sets : { x: [0], y: [0] };
}

/** The number of its inequality, in the middle of a strip. @param {'x' | 'y'} part @param {number} angle Where the strip leads. */
const nameOf = (part, angle) =>
  html`<span class="near-name of-${part}" aria-hidden="true" ${styled('left', `${50 + 42 * Math.cos(angle)}%`)} ${styled('top', `${50 - 42 * Math.sin(angle)}%`)}>${names.equations[part]}</span>`;

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
  const { screenX, screenY } = viewAt(goal, scale);
  const points = [];
  for (const [i, metres] of x.entries()) {
    const [px, py] = [screenX(metres), screenY(y[i])];
    if (Number.isFinite(px + py)) points.push(`${px.toFixed(1)},${py.toFixed(1)}`);
  }
  return `M${points.join('L')}`;
}

/** What is nowhere is as large as nothing. @param {Posture} posture @param {Posture} goal @param {number} scale */
function placeOf({ x, y, theta }, goal, scale) {
  if (!Number.isFinite(x + y + theta)) return 'scale(0)';
  const { screenX, screenY } = viewAt(goal, scale);
  return `translate(${screenX(x)} ${screenY(y)}) rotate(${-degrees(theta)})`;
}
