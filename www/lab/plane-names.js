// What is written on the plane: the names of start and goal, each beside its arrow, and what J comes to along the path.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
import { scaleLinear } from 'd3-scale';
import { paidAt } from '../core/paid.js';
import { textFont } from '../kit/lettering.js';
import { once, remember } from '../kit/memo.js';
import { knobOf } from '../kit/transform.js';
import { lab as strings } from '../words/index.js';

/** @typedef {{ text: string, px: number, py: number, align: CanvasTextAlign }} PostureName */
/** In pixels. @typedef {{ left: number, right: number, top: number, bottom: number }} Room */

/** A plane that has no room for what is written along the path, nor beside the legend. @param {View} view */
export const isSmall = ({ height }) => height < 280;

/** Start and goal by name, as far as there is room: at their right hand, or at their left, where J is written on the right of the path. @param {View} view @param {{ start: Posture, goal: Posture }} ends @param {Run} run @param {boolean} isPaid @param {readonly Run[]} [pins] @returns {PostureName[]} */
export function namesIn(view, { start, goal }, run, isPaid, pins = []) {
  if (view.height < 170) return [];
  const side = isPaid ? -1 : 1;
  const names = [nameAt(view, start, strings.startName, side)];
  if (!isTaken(view, goal, side, run)) names.push(nameAt(view, goal, strings.goalName, side));
  else if (!isSmall(view)) names.push(nameAt(view, goal, strings.goalName, -side));
  return names.map((name) => besideMarks(view, name, pins));
}

/** Further out, where it would lie on the mark above a pinned robot at rest. @param {View} view @param {PostureName} name @param {readonly Run[]} pins @returns {PostureName} */
function besideMarks(view, name, pins) {
  const marks = pins.map(({ x, y }) =>
    around(view.screenX(x[x.length - 1]), view.screenY(y[y.length - 1]) - 20, 8),
  );
  const met = marks.filter((mark) => meet(mark, roomOf(name)));
  if (met.length === 0 || name.align === 'center') return name;
  const isLeft = name.align === 'right';
  return {
    ...name,
    px: isLeft ? Math.min(...met.map(({ left }) => left)) : Math.max(...met.map(({ right }) => right)),
  };
}

/** Whether the robot ends where the name of its goal would stand. @param {View} view @param {Posture} goal @param {number} side @param {Run} run */
function isTaken(view, goal, side, { x, y }) {
  const end = x.length - 1;
  const right = (x[end] - goal.x) * Math.sin(goal.theta) - (y[end] - goal.y) * Math.cos(goal.theta);
  const away = Math.hypot(x[end] - goal.x, y[end] - goal.y) * view.scale;
  return away > 16 && away < 80 && right * side * view.scale > 12;
}

/** Beside it, where neither its knob is nor the way to it. @param {View} view @param {Posture} posture @param {string} text @param {number} side @returns {PostureName} */
function nameAt(view, { x, y, theta }, text, side) {
  const [across, down] = [side * Math.sin(theta), side * Math.cos(theta)];
  const align = Math.abs(across) < 0.5 ? 'center' : across > 0 ? 'left' : 'right';
  return { text, px: view.screenX(x) + 20 * across, py: view.screenY(y) + 24 * down, align };
}

const context = once(() => document.createElement('canvas').getContext('2d'));
/** @type {Map<string, number>} */
const widths = new Map();

/** How wide a text is, measured once and without asking the page, which would have to be laid out for it. @param {string} text @param {string} [font] */
export function widthOf(text, font = textFont) {
  const key = `${font} ${text}`;
  let width = widths.get(key);
  if (width === undefined) {
    // A name has the number of its generation, of which there are many.
    if (widths.size >= 1000) widths.clear();
    const pen = context();
    if (pen) pen.font = font;
    width = pen?.measureText(text).width ?? 0;
    widths.set(key, width);
  }
  return width;
}

/** @param {PostureName} name @returns {Room} */
export function roomOf({ text, px, py, align }) {
  const width = widthOf(text);
  const left = px - (align === 'center' ? width / 2 : align === 'right' ? width : 0);
  return { left, right: left + width, top: py - 9, bottom: py + 9 };
}

/** @param {Room} a @param {Room} b */
export const meet = (a, b) => a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;

/** Around a point. @param {number} px @param {number} py @param {number} radius @returns {Room} */
export const around = (px, py, radius) => ({
  left: px - radius,
  right: px + radius,
  top: py - radius,
  bottom: py + radius,
});

/** Whether words there would lie on what turns a start or a goal: its knob, or the line that leads there. @param {View} view @param {readonly Posture[]} ends @param {Room} room */
const isOnHandle = (view, ends, room) =>
  ends.some((end) => {
    const { px, py } = knobOf(view, end);
    const [x, y] = [view.screenX(end.x), view.screenY(end.y)];
    const line = [0.2, 0.4, 0.6, 0.8].map((part) => around(x + part * (px - x), y + part * (py - y), 1));
    return [around(px, py, 6), ...line].some((one) => meet(one, room));
  });

/** A stroke across the path, and the name beside it, which is not everywhere. @typedef {{ px: number, py: number, across: number, up: number, name: PostureName | null }} Payment */

/** Along the path, wherever so much of J is paid. */
export const paymentsOn = remember(
  /** @param {View} view @param {Run} run @param {Posture} start @param {Posture} goal @returns {Payment[]} */
  (view, run, start, goal) => {
    const last = run.time.length - 1;
    const total = paidAt(run, last);
    if (!Number.isFinite(total)) return [];
    let i = 0;
    /** Where there is no room between two, only the first has its number, and on a handle none. */
    let named = [Number.NEGATIVE_INFINITY, 0];
    const ticks = scaleLinear([0, total], [0, 1]).ticks(6).slice(1);
    return ticks.map((cost) => {
      while (i < last && paidAt(run, i) < cost) i += 1;
      const [px, py] = [view.screenX(run.x[i]), view.screenY(run.y[i])];
      const [across, up] = [Math.sin(run.theta[i]), Math.cos(run.theta[i])];
      /** @type {PostureName} */
      const name = { text: strings.paidText(cost), px: px + 24 * across, py: py + 18 * up, align: 'center' };
      const isClose = Math.abs(name.px - named[0]) < 36 && Math.abs(name.py - named[1]) < 15;
      if (isClose || isOnHandle(view, [start, goal], roomOf(name))) return { px, py, across, up, name: null };
      named = [name.px, name.py];
      return { px, py, across, up, name };
    });
  },
);
