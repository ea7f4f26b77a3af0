// The pushes over the whole drive, which are its clock: v above ω against time, and a cursor that moves the robots.
import { bisectRight } from 'd3-array';
import { scaleLinear } from 'd3-scale';
import { html, nothing, render, svg } from 'lit-html';
import { live as liveValue } from 'lit-html/directives/live.js';
import { pointsOf, ticksOn } from '../../kit/chart.js';
import { create } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { extentOf } from '../../kit/extent.js';
import { remember, watch } from '../../kit/memo.js';
import { standingFree } from '../../kit/names.js';
import { dashes } from '../../kit/palette.js';
import { scrubStep } from '../../run/clock.js';
import { lab } from '../../words/index.js';
import { fixed } from '../../words/numbers.js';
import { pushesOver, reach } from './push-terms.js';

/** @import { Axes } from '../../kit/chart.js' */
/** @import { Experiment, Samples, Triple } from '../../core/engine.js' */
/** @import { Tools } from '../page.js' */
/** @import { Curve, Half, Pushes, Side } from './push-terms.js' */
/** @typedef {{ strip: string, stripKey: string, stripHint: string }} StripWords */
/** @typedef {{ samples: Samples, experiment: Experiment, gains: Triple, time: number, finalTime: number }} Model */
/** A curve on the picture, and how high it is at a moment. @typedef {{ term: string, path: string, at: (i: number) => number }} Drawn */
/** @typedef {{ name: string, colour: string, axes: Axes, ticks: number[], limits: number[], curves: Drawn[], asked: Drawn }} DrawnHalf */

const [left, right, top, gap, below] = [52, 14, 6, 10, 20];
const classes = /** @type {Record<string, string>} */ ({
  kx: 'of-x',
  ky: 'of-y',
  kt: 'of-theta',
  moving: 'of-moving',
});
const dashOf = (/** @type {string} */ term) =>
  (dashes[classes[term].replace('of-', '--')] ?? dots).join(' ') || nothing;
/** Of what no gain asks for. */
const dots = [1, 2];
const symbols = /** @type {const} */ ({ linear: ['v', 'of-energy'], angular: ['ω', 'of-omega'] });

/** @param {Tools} tools @param {StripWords} words */
export function createStrip({ actions, store }, words) {
  const picture = create('div', 'strip-picture');
  const hint = create('span', 'hint', words.stripHint);
  const element = create('div', 'push-strip', create('p', 'muted', words.stripKey, ' ', hint), picture);
  const sizeOf = followSize(picture, () => store.redraw());
  const changed = watch();
  const over = remember(
    (
      /** @type {Samples} */ samples,
      /** @type {Experiment} */ experiment,
      /** @type {number[]} */ ...gains
    ) => pushesOver(samples, experiment, /** @type {Triple} */ (/** @type {readonly number[]} */ (gains))),
  );
  const onPicture = remember(drawn);
  return {
    element,
    /** @param {Model} model */
    draw({ samples, experiment, gains, time, finalTime }) {
      const { width, height } = sizeOf();
      if (width === 0 || !changed(samples, experiment, ...gains, time, finalTime, width, height)) return;
      const pushes = over(samples, experiment, ...gains);
      const halves = onPicture(pushes, finalTime, width, height);
      const text = lab.clockText(time, finalTime);
      render(
        html`<svg viewBox=${`0 0 ${width} ${height}`} width=${width} height=${height} aria-hidden="true">
            ${halves.map(halfOf)} ${timesOf(halves[1])} ${cursorOf(halves, pushes.times, time)}
          </svg>
          <input id="push-clock" type="range" min="0" step=${scrubStep(finalTime)} aria-label=${words.strip} aria-valuetext=${text}
            .max=${String(finalTime)} .value=${liveValue(String(time))}
            @input=${(/** @type {{ target: HTMLInputElement }} */ { target }) => actions.scrub(target.valueAsNumber)}>`,
        picture,
      );
    },
  };
}

/** So that the limits, or half of what the bars have room for, are always in it: no axis jumps at every step of a slider. @param {Side} side @param {Half} half @returns {[number, number]} */
function domainOf(side, { asked, terms, limit }) {
  const most = reach[side];
  const usual = limit === null ? most / 2 : Math.min(1.2 * limit, most);
  const all = [asked, ...terms].map(({ values }) => values);
  const [low, high] = extentOf(all, [0, usual]);
  // Where something pushes backwards, the limit on that side is there too.
  return [
    Math.max(low < -0.02 * most ? Math.min(1.1 * low, -usual) : -0.05 * most, -most),
    Math.min(1.1 * high, most),
  ];
}

/** @param {Pushes} pushes @param {number} finalTime @param {number} width @param {number} height @returns {DrawnHalf[]} */
function drawn(pushes, finalTime, width, height) {
  const high = (height - top - gap - below) / 2;
  return /** @type {const} */ (['linear', 'angular']).map((side, i) => {
    const half = pushes[side];
    const from = top + i * (high + gap);
    const frame = { left, right: width - right, top: from, bottom: from + high };
    const y = scaleLinear(domainOf(side, half), [frame.bottom, frame.top]).clamp(true);
    const axes = { frame, x: scaleLinear([0, finalTime || 1], [frame.left, frame.right]), y };
    const [low, most] = y.domain();
    const limits = half.limit === null ? [] : [half.limit, -half.limit].filter((at) => at > low && at < most);
    const drawnCurve = (/** @type {Curve} */ { term, values }) => ({
      term,
      // What is off lies on the line of 0. Its node stays, for it may be lit when it comes on.
      path: values.some((one) => one !== 0)
        ? `M${pointsOf(axes, pushes.times, values)
            .map((point) => point.map((one) => one.toFixed(1)).join())
            .join('L')}`
        : '',
      at: (/** @type {number} */ moment) => y(values[moment]),
    });
    const [name, colour] = symbols[side];
    return {
      name,
      colour,
      axes,
      limits,
      // The limits keep their numbers where 0 would touch them.
      ticks: [...(limits.length > 0 ? limits : [most]), 0],
      asked: drawnCurve(half.asked),
      curves: half.terms.map(drawnCurve),
    };
  });
}

/** @param {DrawnHalf} half */
const halfOf = ({ name, colour, axes: { frame, y }, limits, ticks, asked, curves }) => svg`
  ${ticks.map((tick) => svg`<path class="strip-grid" d=${across(frame, y(tick))} />`)}
  ${limits.map((at) => svg`<path class="strip-limit" d=${across(frame, y(at))} />`)}
  <path class=${`strip-asked ${colour}`} data-term=${asked.term} d=${asked.path} />
  ${curves.map(({ term, path }) => svg`<path class=${`strip-curve ${classes[term]}`} data-term=${term} stroke-dasharray=${dashOf(term)} d=${path} />`)}
  <text class=${`strip-name ${colour}`} x="2" y=${frame.top + 16}>${name}</text>
  ${standingFree(ticks.map(y)).map((i) => numberAt(ticks[i], y(ticks[i])))}`;

/** @param {number} tick @param {number} y */
const numberAt = (tick, y) =>
  svg`<text class="strip-number" x=${left - 6} y=${y + 4} text-anchor="end">${fixed(tick, tick === 0 ? 0 : 1)}</text>`;

/** @param {import('../../kit/chart.js').Frame} frame @param {number} y */
const across = (frame, y) => `M${frame.left},${y}H${frame.right}`;

/** The seconds below. @param {DrawnHalf} half */
const timesOf = ({ axes: { frame, x } }) =>
  ticksOn(x, 60).map(
    (tick) =>
      svg`<text class="strip-number" x=${x(tick)} y=${frame.bottom + 16} text-anchor="middle">${+tick.toFixed(2)} s</text>`,
  );

/** @param {DrawnHalf[]} halves @param {readonly number[]} times @param {number} time */
function cursorOf([above, under], times, time) {
  const now = bisectRight(times, time + 1e-9) - 1;
  const px = above.axes.x(time);
  const [start, end] = [above.axes.frame.top, under.axes.frame.bottom];
  return svg`<path class="strip-cursor" d=${`M${px},${start}V${end}`} />
    ${[above, under].map(({ curves }) =>
      curves.map(
        ({ term, path, at }) =>
          path &&
          svg`<circle class=${`strip-dot ${classes[term]}`} cx=${px} cy=${at(Math.max(now, 0))} r="3.5" />`,
      ),
    )}
    <circle class="strip-handle" cx=${px} cy=${end} r="7" />`;
}
