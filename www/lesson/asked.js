// What the law asks for against what the wheels do, on an axis on which both have room.
import { scaleLinear, scaleSymlog } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawGrid,
  drawNumbersBelow,
  drawUpright,
  pointsOf,
  ticksOn,
  within,
} from '../kit/chart.js';
import { create } from '../kit/elements.js';
import { strongFont } from '../kit/fonts.js';
import { colour } from '../kit/palette.js';
import { fixed, powerOfTen } from '../words/numbers.js';

/** @import { Axes, Size } from '../kit/chart.js' */
/** @import { Run } from '../core/engine.js' */
/** @import { Block, Live, Tools } from './page.js' */
/** @typedef {{ asked: { label: (asked: string, done: string) => string, linear: string, angular: string, asked: string, done: string } }} AskedWords */
/** @typedef {{ run: Run, time: number, theme: number }} Model */

const gap = 34;
const [left, right] = [52, 24];

/** Of the axis: 0, ±1, ±10, …, not all where there are many. @param {number} most */
const powers = (most) => {
  const ticks = [0];
  for (let power = 1; power <= most; power *= 10) ticks.push(power, -power);
  const every = ticks.length < 8 ? 1 : 2 * Math.ceil(ticks.length / 16);
  return ticks.sort((a, b) => a - b).filter((_, i, all) => (i - (all.length >> 1)) % every === 0);
};

/** Beyond it an axis has no numbers. */
const longest = 1e300;

/** @param {ArrayLike<number>} values */
const largest = (values) =>
  Array.from(values).reduce((most, value) => Math.max(most, Math.min(Math.abs(value) || 0, longest)), 0);

/** @param {Tools} _tools @param {AskedWords} words @returns {Block} */
export function createAsked(_tools, { asked: words }) {
  const element = create('div', 'asked');
  element.id = 'asked';
  element.setAttribute('role', 'img');
  const chart = createChart(element, (context, size, /** @type {Model} */ model) => {
    context.font = strongFont;
    const signs = `· · · ${words.asked}   ━ ${words.done}`;
    const widthOf = (/** @type {string} */ text) => context.measureText(text).width;
    // Where the first name leaves them no room they stand above it.
    const head = widthOf(words.linear) + widthOf(signs) + left + right > size.width ? 20 : 0;
    const half = { ...size, height: (size.height - gap - head) / 2 };
    const { run } = model;
    drawHalf(context, half, head, [run.commandLinear, run.linear], '--energy', words.linear, model);
    const second = head + half.height;
    const angular = /** @type {const} */ ([run.commandAngular, run.angular]);
    drawHalf(context, half, second, angular, '--omega', words.angular, model, true);
    drawSigns(context, size, signs);
  });
  return {
    element,
    draw(/** @type {Live} */ { state, scene: { driving } }) {
      const drawn = chart.draw({
        run: driving,
        time: Math.min(state.robot.time, driving.finalTime),
        theme: state.theme,
      });
      if (!drawn) return;
      const [asked, done] = [driving.commandAngular, driving.angular].map((all) => fixed(largest(all), 0));
      element.setAttribute('aria-label', words.label(asked, done));
    },
  };
}

/** A power of ten with its sign, or 0. @param {number} tick */
const tickText = (tick) =>
  tick === 0 ? '0' : `${tick < 0 ? '−' : ''}${powerOfTen(Math.round(Math.log10(Math.abs(tick))))}`;

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {number} top @param {readonly [ArrayLike<number>, ArrayLike<number>]} values @param {string} token @param {string} name @param {Model} model @param {boolean} [isLast] */
function drawHalf(
  context,
  { width, height },
  top,
  [asked, done],
  token,
  name,
  { run, time },
  isLast = false,
) {
  const most = 1.4 * Math.max(2, largest(asked), largest(done));
  const frame = { left, right: width - right, top: top + 22, bottom: top + height - 4 };
  /** @type {Axes} */
  const axes = {
    frame,
    x: scaleLinear([0, run.finalTime || 1], [frame.left, frame.right]),
    y: scaleSymlog([-most, most], [frame.bottom, frame.top]).constant(1),
  };
  const ticks = {
    x: ticksOn(axes.x, 70),
    y: powers(most),
  };
  drawGrid(context, axes, ticks, ticks.y.map(tickText));
  if (isLast)
    drawNumbersBelow(
      context,
      axes.x,
      frame.bottom,
      ticks.x,
      ticks.x.map((tick) => `${fixed(tick, 1)} s`),
    );
  within(context, frame, () => {
    const line = (/** @type {ArrayLike<number>} */ all) =>
      pointsOf(
        axes,
        run.time,
        run.time.map((_, i) => all[Math.min(i, all.length - 1)]),
        true,
      );
    drawCurve(context, line(asked), { token, width: 1.5, dash: [2, 3] });
    drawCurve(context, line(done), { token, width: 3 });
  });
  drawUpright(context, axes.x(time), frame, { token: '--muted', width: 1 });
  context.font = strongFont;
  context.fillStyle = colour(token);
  context.textAlign = 'left';
  context.textBaseline = 'alphabetic';
  context.fillText(name, frame.left, top + 15);
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {string} signs */
function drawSigns(context, { width }, signs) {
  context.font = strongFont;
  context.fillStyle = colour('--muted');
  context.textAlign = 'right';
  context.fillText(signs, width - 12, 15);
}
