// The error posture on the plane: x_e and y_e as lengths along and across the goal's heading, θ_e as an angle at the robot; and, on demand, of what postures it is the difference.
import { html, render, svg } from 'lit-html';
import { createView } from '../../kit/transform.js';
import { watch } from '../../kit/memo.js';
import { linesOfLegend } from '../../lab/notes.js';
import { placeOfLegend } from '../../lab/plane-corners.js';
import { around, meet, namesIn, roomOf } from '../../lab/plane-names.js';
import { sizes } from '../../lab/track.js';
import { endsOf } from '../../run/state.js';
import { symbolInText } from '../formulas/symbols.js';

/** @import { Posture, Sample } from '../../core/engine.js' */
/** @import { View } from '../../kit/transform.js' */
/** @import { Room } from '../../lab/plane-names.js' */
/** @import { Live } from '../page.js' */

/** In pixels. @typedef {readonly [x: number, y: number]} At */
/** One of the three: its line, where its name may stand, best first, and whether it is long enough to be seen. @typedef {{ path: string, places: readonly At[], seen: boolean }} Mark */

/** Their terms and their colours. */
const terms = /** @type {const} */ ([
  ['xe', 'x'],
  ['ye', 'y'],
  ['te', 'theta'],
]);

/** @param {HTMLElement} root */
export function createErrorPosture(root) {
  const symbols = terms.map(([name]) => symbolInText(name));
  const changed = watch();

  return {
    /** @param {boolean} hidden */
    hide(hidden) {
      root.hidden = hidden;
    },
    /** @param {Live} live */
    draw({ state, scene, sample }) {
      const { size, box } = state;
      if (size.width === 0 || !changed(sample, box, size, scene)) return;
      const view = createView(box, size);
      const { marks, ahead } = errorOn(view, sample);
      const ends = endsOf(state);
      const { driving, comparison, pins } = scene;
      const { texts, dashed } = linesOfLegend(state, scene, view);
      const standing = { view, ends, runs: [driving, comparison, ...pins], isPaid: false };
      const taken = [
        ...namesIn(view, ends, driving, false).map(roomOf),
        ...placeOfLegend(standing, texts, dashed).rooms,
      ];
      const arrows = [sample.posture, ends.start, ends.goal].map(({ x, y }) =>
        around(view.screenX(x), view.screenY(y), sizes.robot),
      );
      const at = marks.map(({ places, seen }) => (seen ? freeOf(size, places, taken, arrows) : places[0]));
      const lines = terms.map(([name, colour], i) => {
        const path = marks[i].seen ? marks[i].path : '';
        return svg`<g data-term=${name}>
          <path class=${`error-line of-${colour}`} d=${path} /><path class="error-grip" d=${path} />
        </g>`;
      });
      const values = [...valuesOf(view, 'r', sample.reference), ...valuesOf(view, 'c', sample.posture)].map(
        ({ term, colour, path }) =>
          svg`<g data-term=${term}><path class=${`error-value of-${colour}`} d=${somewhere(path)} /></g>`,
      );
      const labels = terms.map(([name, colour], i) => {
        const { seen } = marks[i];
        const place = `translate(${at[i][0]}px, ${at[i][1]}px)`;
        return html`<span class=${`error-label of-${colour}`} data-term=${name} ?hidden=${!seen}
          .style=${`transform: ${place} translate(-50%, -50%)`}>${symbols[i]}</span>`;
      });
      render(
        html`<svg aria-hidden="true"><path class="error-ahead" d=${somewhere(ahead)} />${lines}${values}</svg>${labels}`,
        root,
      );
    },
  };
}

/** Nothing where the robot is nowhere. @param {string} path */
const somewhere = (path) => (/NaN|Infinity/.test(path) ? '' : path);

/** Within the plane. @param {number} at @param {number} end */
const clamp = (at, end) => Math.max(16, Math.min(end - 16, at));

/** The first of these places at which the name meets neither words, of which it then is one, nor arrows; if there is none, that meets no words. @param {{ width: number, height: number }} size @param {readonly At[]} places @param {Room[]} taken @param {readonly Room[]} arrows @returns {At} */
function freeOf(size, places, taken, arrows) {
  const all = places.map(([x, y]) => /** @type {At} */ ([clamp(x, size.width), clamp(y, size.height)]));
  const room = (/** @type {At} */ [x, y]) => around(x, y, 14);
  const isFree = (/** @type {At} */ at, /** @type {readonly Room[]} */ things) =>
    !things.some((thing) => meet(thing, room(at)));
  const at =
    all.find((one) => isFree(one, [...taken, ...arrows])) ?? all.find((one) => isFree(one, taken)) ?? all[0];
  taken.push(room(at));
  return at;
}

/** Where x, y and θ of a posture are read, seen while their symbol is pointed at: lines to both axes, and the angle from the horizontal. @param {View} view @param {'r' | 'c'} index @param {Posture} posture */
function valuesOf(view, index, { x, y, theta }) {
  const [px, py] = [view.screenX(x), view.screenY(y)];
  const radius = radiusIn(view) * 0.75;
  const { path } = arcOf([px, py], radius, 0, Math.atan2(Math.sin(theta), Math.cos(theta)));
  const [ahead, up] = [radius * Math.cos(theta), radius * Math.sin(theta)];
  return [
    { term: `x${index}`, colour: 'x', path: `M${px},${py}V${view.height - 28}` },
    { term: `y${index}`, colour: 'y', path: `M${px},${py}H48` },
    { term: `t${index}`, colour: 'theta', path: `M${px + radius},${py}H${px}l${ahead},${-up}${path}` },
  ];
}

/** The marks of x_e, y_e and θ_e, and the two directions between which θ_e lies. @param {View} view @param {Sample} sample */
function errorOn(view, { posture, reference, error }) {
  const at = (/** @type {number} */ x, /** @type {number} */ y) =>
    /** @type {At} */ ([view.screenX(x), view.screenY(y)]);
  const [cos, sin] = [Math.cos(reference.theta), Math.sin(reference.theta)];
  // On the goal's own axis, beside the robot.
  const corner = at(reference.x - error.x * cos, reference.y - error.x * sin);
  const robot = at(posture.x, posture.y);
  const goal = at(reference.x, reference.y);
  const radius = radiusIn(view);
  const beyond = (/** @type {number} */ angle) =>
    `M${robot}l${(radius + 12) * Math.cos(angle)},${-(radius + 12) * Math.sin(angle)}`;
  return {
    marks: [
      lineOf(corner, goal, robot),
      lineOf(robot, corner, goal),
      arcOf(robot, radius, posture.theta, error.theta),
    ].map((mark) => ({ ...mark, seen: mark.seen && somewhere(mark.path) !== '' })),
    ahead: beyond(posture.theta) + beyond(posture.theta + error.theta),
  };
}

/** Its name stands beside the middle of the line, away from the third corner. @param {At} from @param {At} to @param {At} third @returns {Mark} */
function lineOf(from, to, third) {
  const [[ax, ay], [bx, by], [ox, oy]] = [from, to, third];
  const [nx, ny] = [by - ay, ax - bx];
  const side = Math.sign(nx * (ax - ox) + ny * (ay - oy)) || 1;
  const length = Math.hypot(nx, ny);
  /** @param {number} far @returns {At} */
  const beside = (far) => {
    const away = (far * side) / (length || 1);
    return [(ax + bx) / 2 + away * nx, (ay + by) / 2 + away * ny];
  };
  return {
    path: `M${from}L${to}`,
    places: [20, -20, 32, -32, 44].map(beside),
    seen: length > 4,
  };
}

/** Of the angle at the robot, which stays within a low plane. @param {{ width: number, height: number }} size */
const radiusIn = ({ width, height }) => Math.min(56, Math.max(28, Math.min(width, height) / 6));

/** @param {At} centre @param {number} radius @param {number} from @param {number} turn @returns {Mark} */
function arcOf([x, y], radius, from, turn) {
  const to = from + turn;
  /** @param {number} angle @param {number} far @returns {At} */
  const on = (angle, far) => [x + far * Math.cos(angle), y - far * Math.sin(angle)];
  const sweep = turn > 0 ? 0 : 1;
  return {
    path: `M${on(from, radius)}A${radius},${radius} 0 0 ${sweep} ${on(to, radius)}`,
    places: [0, Math.PI, Math.PI / 2, -Math.PI / 2].map((aside, i) =>
      on((from + to) / 2 + aside, i === 0 ? radius + 18 : 28),
    ),
    seen: Math.abs(turn) > 0.03,
  };
}
