// What the law asks for against what the wheels do, on an axis on which both have room.
import { scaleLinear, scaleSymlog } from 'd3-scale';
import {
  createChart,
  drawCurve,
  drawGrid,
  drawLevel,
  drawNumbersBelow,
  drawUpright,
  pointsOf,
  ticksOn,
  within,
} from '../../kit/chart.js';
import { create } from '../../kit/elements.js';
import { fillTextWithHalo } from '../../kit/canvas.js';
import { colour } from '../../kit/palette.js';
import { setLettering, strongFont, textFont } from '../../kit/lettering.js';
import { fixed, powerOfTen } from '../../words/numbers.js';

/** @import { Axes, Size } from '../../kit/chart.js' */
/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @typedef {{ asked: { label: (asked: string, done: string) => string, linear: string, angular: string, asked: string, done: string, limit: string } }} AskedWords */
/** @typedef {{ run: Run, limits: Experiment['limits'], time: number, theme: number }} Model */
/** One velocity: what the law asks for, what the wheels do, and the most that they can. @typedef {{ asked: ArrayLike<number>, done: ArrayLike<number>, limit: number | null, token: string, name: string }} Half */

const gap = 34;
const [left, right] = [52, 24];

/** Of the axis: 0, ±1, ±10, …, not all where there are many. @param {number} most */
const powers = (most) => {
  const ticks = [0];
  for (let power = 1; power <= most; power *= 10) ticks.push(power, -power);
  const every = ticks.length < 8 ? 1 : 2 * Math.ceil(ticks.length / 16);
  return ticks.sort((a, b) => a - b).filter((_, i, all) => (i - (all.length >> 1)) % every === 0);
};

/** @param {ArrayLike<number>} values */
const isBelow = (values) => Array.from(values).some((value) => value < 0);

/** Beyond it an axis has no numbers. */
const longest = 1e300;

/** @param {ArrayLike<number>} values */
const largest = (values) =>
  Array.from(values).reduce((most, value) => Math.max(most, Math.min(Math.abs(value) || 0, longest)), 0);

/** @param {Tools} _tools @param {AskedWords} words @returns {Block} */
export function createAsked(_tools, { asked: words }) {
  const element = create('div', { id: 'asked', class: 'asked', role: 'img' });
  const chart = createChart(element, (context, size, /** @type {Model} */ model) => {
    context.font = strongFont;
    const { run, limits } = model;
    const isLimited = limits.speed !== null || limits.turnRate !== null;
    const signs = `── ${words.asked}   ━━ ${words.done}${isLimited ? `   ╌╌ ${words.limit}` : ''}`;
    const widthOf = (/** @type {string} */ text) => context.measureText(text).width;
    // Where the first name leaves them no room they stand above it.
    const head = widthOf(words.linear) + widthOf(signs) + left + right > size.width ? 20 : 0;
    const half = { ...size, height: (size.height - gap - head) / 2 };
    const [linear, angular] = halvesOf(run, limits, words);
    drawHalf(context, half, head, linear, model);
    drawHalf(context, half, head + half.height, angular, model, true);
    drawSigns(context, size, signs);
  });
  return {
    element,
    draw(/** @type {Live} */ { state, scene: { driving, experiment } }) {
      const drawn = chart.draw({
        run: driving,
        limits: experiment.limits,
        time: Math.min(state.robot.time, driving.finalTime),
        theme: state.theme,
      });
      if (!drawn) return;
      const [asked, done] = [driving.commandAngular, driving.angular].map((all) => fixed(largest(all), 0));
      element.setAttribute('aria-label', words.label(asked, done));
    },
  };
}

/** @param {Run} run @param {Experiment['limits']} limits @param {AskedWords['asked']} names @returns {[Half, Half]} */
const halvesOf = (run, { speed, turnRate }, { linear, angular }) => [
  { asked: run.commandLinear, done: run.linear, limit: speed, token: '--energy', name: linear },
  { asked: run.commandAngular, done: run.angular, limit: turnRate, token: '--omega', name: angular },
];

/** A power of ten with its sign, or 0. @param {number} tick */
const tickText = (tick) =>
  tick === 0 ? '0' : `${tick < 0 ? '−' : ''}${powerOfTen(Math.round(Math.log10(Math.abs(tick))))}`;

/** Its numbers: powers of ten, and the limit, before which one that is too near gives way. @param {Axes['y']} y @param {number} most @param {number | null} limit @returns {{ at: number, text: string }[]} */
function numbersOn(y, most, limit) {
  const [lowest] = y.domain();
  const isApart = (/** @type {number} */ one, /** @type {number} */ other) =>
    Math.abs(y(one) - y(other)) > 13;
  const limits =
    limit === null ? [] : [limit, -limit].filter((one) => one >= lowest && (one > 0 || isApart(one, limit)));
  const isFree = (/** @type {number} */ tick) => limits.every((one) => isApart(one, tick));
  return [
    ...limits.map((at) => ({ at, text: fixed(at, 1) })),
    // What is near 0 goes before what is not.
    ...powers(most)
      .sort((one, other) => Math.abs(one) - Math.abs(other))
      .filter((tick) => tick >= lowest && isFree(tick))
      .map((at) => ({ at, text: tickText(at) })),
  ];
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {number} top @param {Half} half @param {Model} model @param {boolean} [isLast] */
function drawHalf(context, { width, height }, top, half, { run, time }, isLast = false) {
  const { asked, done, limit, token, name } = half;
  const most = 1.4 * Math.max(2, largest(asked), largest(done));
  const frame = { left, right: width - right, top: top + 22, bottom: top + height - 4 };
  // Where nothing goes backwards the picture is of what goes forwards.
  const least = isBelow(asked) || isBelow(done) ? -most : 0;
  /** @type {Axes} */
  const axes = {
    frame,
    x: scaleLinear([0, run.finalTime || 1], [frame.left, frame.right]),
    y: scaleSymlog([least, most], [frame.bottom, frame.top]).constant(1),
  };
  const numbers = numbersOn(axes.y, most, limit !== null && limit < most ? limit : null);
  const ticks = { x: ticksOn(axes.x, 70), y: numbers.map(({ at }) => at) };
  const texts = numbers.map(({ text }) => text);
  drawGrid(context, axes, ticks, texts);
  const times = ticks.x.map((tick) => `${fixed(tick, 1)} s`);
  if (isLast) drawNumbersBelow(context, axes.x, frame.bottom, ticks.x, times);
  within(context, frame, () => {
    const line = (/** @type {ArrayLike<number>} */ all) => {
      const values = run.time.map((_, i) => all[Math.min(i, all.length - 1)]);
      return pointsOf(axes, run.time, values, true);
    };
    for (const at of limit === null ? [] : [limit, -limit])
      drawLevel(context, frame, axes.y(at), { token: '--muted', width: 1, dash: [3, 3] });
    drawCurve(context, line(asked), { token, width: 1.25 });
    drawCurve(context, line(done), { token, width: 3 });
  });
  if (limit !== null) namePeak(context, axes, half, run.time);
  drawUpright(context, axes.x(time), frame, { token: '--muted', width: 1 });
  setLettering(context, { token, font: strongFont, baseline: 'alphabetic' });
  context.fillText(name, frame.left, top + 15);
}

/** How much is asked for at most, where that is more than can be done. @param {CanvasRenderingContext2D} context @param {Axes} axes @param {Half} half @param {ArrayLike<number>} times */
function namePeak(context, { frame, x, y }, { asked, limit, token }, times) {
  const sizes = Array.from(asked, Math.abs);
  const at = sizes.indexOf(largest(sizes));
  if (!(sizes[at] > Number(limit) && sizes[at] < 1e4)) return;
  const text = fixed(asked[at], 1);
  setLettering(context, { token, font: textFont, align: 'left', baseline: 'alphabetic' });
  const { width } = context.measureText(text);
  const isUp = asked[at] > 0;
  // The line of the limit may be near.
  fillTextWithHalo(
    context,
    text,
    Math.min(x(times[at]) + 6, frame.right - width),
    isUp ? Math.max(y(asked[at]) - 4, frame.top + 10) : Math.min(y(asked[at]) + 13, frame.bottom - 2),
    { fill: colour(token), halo: colour('--paper') },
  );
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {string} signs */
function drawSigns(context, { width }, signs) {
  setLettering(context, { font: strongFont, align: 'right', baseline: 'alphabetic' });
  context.fillText(signs, width - 12, 15);
}
