// The still picture: the first robots of an evolution and the best of a later generation, driven by the core.
import { Evolution, experiment, simulateAll } from '../www/core/headless.js';

/** @typedef {import('../pkg/ep_locomotion.js').Run} Run */

export const generations = 100;
const task = experiment('velocity-limits');
const evolution = new Evolution(task);
const first = evolution.population();
for (let i = 0; i < generations; i++) evolution.step();
const { best } = evolution.statistics();

export const robots = first.length;
export const costs = { first: first[0].cost, best: best.cost };

/** Metres, upwards, as the picture has them: downwards. @param {number} x @param {number} y */
const point = (x, y) => `${x.toFixed(2)} ${(-y).toFixed(2)}`;

/** As fine as one sees it. @param {Run} run */
function pathOf({ x, y }) {
  const points = Array.from(x, (_, i) => point(x[i], y[i]));
  const some = points.filter((_, i) => i % 5 === 0 || i === points.length - 1);
  return `M${some.filter((one, i) => one !== some[i - 1]).join('L')}`;
}

/** A posture as a kite that points ahead. @param {import('../pkg/ep_locomotion.js').Posture} posture */
function kiteOf({ x, y, theta }) {
  const corners = [
    [0.14, 0],
    [-0.1, 0.09],
    [-0.04, 0],
    [-0.1, -0.09],
  ];
  const [c, s] = [Math.cos(theta), Math.sin(theta)];
  return `M${corners.map(([a, b]) => point(x + c * a - s * b, y + s * a + c * b)).join('L')}Z`;
}

const others = simulateAll(
  task,
  first.flatMap(({ gains }) => gains),
);
const [own] = simulateAll(task, best.gains);

export const picture = [
  // Its looks without a style, too.
  '<svg viewBox="-0.6 -2.4 3.2 2.7" width="352" fill="none" stroke="#777" stroke-width="0.012" aria-hidden="true">',
  `<path class="first" d="${others.map(pathOf).join('')}"/>`,
  `<path class="best" d="${pathOf(own)}"/>`,
  `<path class="posture" d="${kiteOf(task.starts[0])}${kiteOf(task.goal)}"/>`,
  '</svg>',
].join('');
