// The starts of the map, positions on a square around the goal times headings, and what comes of them at each position.
/** @import { Posture, Range, Robustness } from '../../core/engine.js' */

import { startsOnGrid } from '../../core/rules.js';

/** @typedef {{ x: Range, y: Range, headings: number }} Grid As the core understands it. */
/** @typedef {ReturnType<typeof tally>} Tally */

/** How many, evenly around the circle from 0. */
export const headings = 18;

/** @param {{ x: number, y: number }} goal @param {number} half Metres from the goal to the edge. @param {number} count Positions on an edge. @returns {Grid} */
export const gridAround = (goal, half, count) => ({
  x: { from: goal.x - half, to: goal.x + half, count },
  y: { from: goal.y - half, to: goal.y + half, count },
  headings,
});

const here = { from: 0, to: 0, count: 1 };
/** In (−π, π]. @param {number} heading Its index. */
export const angleOf = (heading) => startOf({ x: here, y: here, headings }, 0, heading).theta;

/** The heading that is nearest to an angle. @param {number} angle */
export function headingNear(angle) {
  const steps = Math.round((angle * headings) / (2 * Math.PI));
  return ((steps % headings) + headings) % headings;
}

/** The start that the core drives from: but for the draw of a random disturbance, the run from there is the map's own. @param {Grid} grid @param {number} cell @param {number} heading @returns {Posture} */
export function startOf(grid, cell, heading) {
  const index = cell * grid.headings + heading;
  return startsOnGrid({ ...grid, part: [index, index + 1] })[0];
}

/** Column and row of the cell that is nearest to a point. @param {Grid} grid @param {{ x: number, y: number }} point @returns {[number, number]} */
export const placeOf = ({ x, y }, point) => [indexNear(x, point.x), indexNear(y, point.y)];

/** @param {Grid} grid @param {{ x: number, y: number }} point */
export function cellNear(grid, point) {
  const [column, row] = placeOf(grid, point);
  return row * grid.x.count + column;
}

/** Whether a point lies on the map. @param {Grid} grid @param {{ x: number, y: number }} point */
export const holds = ({ x, y }, point) =>
  point.x >= x.from && point.x <= x.to && point.y >= y.from && point.y <= y.to;

/** @param {Range} range @param {number} value */
function indexNear({ from, to, count }, value) {
  const index = Math.round(((value - from) / (to - from)) * (count - 1));
  return Math.min(Math.max(index, 0), count - 1);
}

/** The heading with which a posture is a start of this cell; −1 if it is none. @param {Grid} grid @param {number} cell @param {Posture} posture */
export function headingOf(grid, cell, posture) {
  const heading = headingNear(posture.theta);
  const start = startOf(grid, cell, heading);
  return start.x === posture.x && start.y === posture.y && start.theta === posture.theta ? heading : -1;
}

/** Of a cell, the heading that does worst: the highest J of those that do not arrive, if there are any. @param {Robustness} result @param {number} cell */
function worstHeading({ cost, arrived }, cell) {
  const first = cell * headings;
  let worst = first;
  for (let i = first + 1; i < first + headings; i += 1)
    if (arrived[i] < arrived[worst] || (arrived[i] === arrived[worst] && cost[i] > cost[worst])) worst = i;
  return worst - first;
}

/** For each cell how many headings arrive, and time and J averaged over those; over all, the share that arrives. @param {Robustness} result */
export function tally({ cost, finalTime, arrived }) {
  const cells = arrived.length / headings;
  const count = new Uint8Array(cells);
  const [time, meanCost] = [new Float64Array(cells), new Float64Array(cells)];
  for (let i = 0; i < arrived.length; i += 1) {
    if (!arrived[i]) continue;
    const cell = Math.floor(i / headings);
    count[cell] += 1;
    time[cell] += finalTime[i];
    meanCost[cell] += cost[i];
  }
  for (let cell = 0; cell < cells; cell += 1) {
    time[cell] /= count[cell];
    meanCost[cell] /= count[cell];
  }
  return { count, time, cost: meanCost, share: count.reduce((sum, one) => sum + one, 0) / arrived.length };
}

/** The share that arrives from behind the goal, from in front of it, from its left and from its right. @param {Grid} grid @param {Posture} goal @param {Uint8Array} count */
export function sharesBySide(grid, goal, count) {
  const sides = { behind: [0, 0], front: [0, 0], left: [0, 0], right: [0, 0] };
  for (const [cell, { x, y }] of startsOnGrid({ ...grid, headings: 1 }).entries()) {
    const angle = Math.atan2(y - goal.y, x - goal.x) - goal.theta;
    const [ahead, aside] = [Math.cos(angle), Math.sin(angle)];
    const along = ahead > 0 ? sides.front : sides.behind;
    const across = aside > 0 ? sides.left : sides.right;
    const side = Math.abs(ahead) > Math.abs(aside) ? along : across;
    side[0] += count[cell];
    side[1] += headings;
  }
  const share = (/** @type {number[]} */ [arrived, all]) => arrived / all;
  return {
    behind: share(sides.behind),
    front: share(sides.front),
    left: share(sides.left),
    right: share(sides.right),
  };
}

/** The worst heading of a cell, or the one after that which is being watched there. @param {{ grid: Grid, runs: Robustness }} survey @param {number} cell @param {Posture} watched */
export function nextHeading({ grid, runs }, cell, watched) {
  const current = headingOf(grid, cell, watched);
  return current < 0 ? worstHeading(runs, cell) : (current + 1) % headings;
}
