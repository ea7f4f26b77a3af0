// The gains of a generation, seen from two sides: kx and kθ across, ky up in both, so that each robot stands equally high in both.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Place as Flat } from '../../kit/ellipse.js' */
/** @import { Place, Size } from './places.js' */
/** @import { Anatomy, Phase } from './record.js' */
import { scaleLinear } from 'd3-scale';
import { ticksOn } from '../../kit/chart.js';
import { svg } from '../../kit/elements.js';
import { sameDigits } from '../../kit/steps.js';
import { lab } from '../../words/index.js';
import words from './words/index.js';
import { margin } from './places.js';
import { pointsOf, sketchOf } from './sketch.js';

/** @typedef {ReturnType<typeof sidesOf>[number]} Side */

const up = 1;
const gap = 24;
/** What is nearer together than this part of its size cannot be told apart in a number. */
const nearest = 1e-12;
const tip = 8;
/** About how wide a digit is, and what the letter of a gain needs at the end of its axis. */
const [digit, letter] = [7, 28];
/** A step ends before the mark of a robot and its ring. */
const before = 13;

/** @param {readonly number[]} values @returns {[number, number]} */
function spanOf(values) {
  const finite = values.filter(Number.isFinite);
  const [low, high] = finite.length > 0 ? [Math.min(...finite), Math.max(...finite)] : [0, 1];
  const room = Math.max(0.08 * (high - low), nearest * Math.max(Math.abs(low), Math.abs(high)), 1e-12);
  return [low - room, high + room];
}

/** The two sides, each with its scales. @param {Anatomy} anatomy @param {Size} size */
export function sidesOf(anatomy, { width, height }) {
  const points = pointsOf(anatomy);
  const span = (/** @type {number} */ gain) => spanOf(points.map((point) => point[gain]));
  const [top, bottom] = [margin.top, height - margin.bottom];
  const wide = (width - margin.left - margin.right - gap) / 2;
  const y = scaleLinear().domain(span(up)).range([bottom, top]);
  return [0, 2].map((across, i) => {
    const left = margin.left + i * (wide + gap);
    const frame = { left, right: left + wide, top, bottom };
    const x = scaleLinear().domain(span(across)).range([frame.left, frame.right]);
    const place = (/** @type {Flat} */ [px, py]) => ({ x: x(px), y: y(py) });
    const shadow = (/** @type {Triple} */ gains) => /** @type {const} */ ([gains[across], gains[up]]);
    return { across, frame, x, y, place, shadow, isFirst: i === 0 };
  });
}

/** Where each number lies; before it is tried an offspring is where its parent is. @param {Anatomy} anatomy @param {Phase} phase @param {Side} side @returns {Place[]} */
export const gainPlaces = ({ all, count }, phase, { place, shadow }) =>
  all.map((_, number) => place(shadow(all[phase === 'parents' ? number % count : number].gains)));

/** @param {Element} layer @param {readonly Side[]} sides */
export const drawGainAxes = (layer, sides) => layer.replaceChildren(...sides.flatMap(axesOf));

/** @param {Side} side */
function axesOf({ frame, across, x, y, isFirst }) {
  const { left, right, top, bottom } = frame;
  const rows = ticksOn(y, 44);
  const columns = ticksOn(x, 64);
  const levels = rows.filter((tick) => y(tick) > top + 18);
  const named = columns.filter((tick) => x(tick) > left + 6);
  const texts = textsOf(named);
  const zero = y(0);
  return [
    ...rows.map((tick) => svg('line', { x1: left, x2: right, y1: y(tick), y2: y(tick) })),
    ...columns.map((tick) => svg('line', { x1: x(tick), x2: x(tick), y1: top, y2: bottom })),
    // Below it gains cost a penalty.
    ...(zero > top && zero < bottom
      ? [svg('line', { x1: left, x2: right, y1: zero, y2: zero, class: 'group' })]
      : []),
    ...named.flatMap((tick, i) =>
      x(tick) + (digit * texts[i].length) / 2 < right - letter
        ? [svg('text', { x: x(tick), y: bottom + 17, class: 'middle' }, texts[i])]
        : [],
    ),
    symbol(across, right - 4, bottom + 17),
    ...(isFirst
      ? [
          ...textsOf(levels).map((text, i) =>
            svg('text', { x: left - 8, y: y(levels[i]) + 4, class: 'end' }, text),
          ),
          symbol(up, left - 8, top + 8),
        ]
      : []),
  ];
}

/** Where all lies close together, how far from the first. @param {readonly number[]} ticks */
function textsOf(ticks) {
  const step = ticks.length > 1 ? ticks[1] - ticks[0] : 1;
  if (step >= 1e-3) return sameDigits(ticks);
  return ticks.map((tick, i) => (i === 0 ? words.baseText(tick) : words.awayText(tick - ticks[0])));
}

/** @param {number} gain @param {number} x @param {number} y */
function symbol(gain, x, y) {
  const { id, letter, index } = lab.gains[gain];
  const below = svg('tspan', { dy: 4, class: 'index' }, index);
  return svg('text', { x, y, class: `symbol gain end ${id}` }, letter, below);
}

/** What the method sees and does. @param {Element} layer @param {readonly Side[]} sides @param {Anatomy} anatomy @param {Phase} phase @param {number} chosen */
export function drawSketch(layer, sides, anatomy, phase, chosen) {
  const { rings, lines, names } = sketchOf(anatomy, phase, chosen);
  layer.replaceChildren(
    ...sides.flatMap(({ place, shadow, frame }) => {
      const at = (/** @type {Triple} */ gains) => place(shadow(gains));
      return [
        ...rings.map(({ outline, faint }) => {
          const places = outline(shadow).map(place);
          return svg('path', { class: faint ? 'ring-of faint' : 'ring-of', d: `M${joined(places)}Z` });
        }),
        ...lines.map(({ from, to, kind }) => svg('path', { class: kind, d: lineOf(at(from), at(to), kind) })),
        ...names.map(({ at: gains, text }) => {
          const { x, y } = at(gains);
          const isLast = x > frame.right - 56;
          const beside = { x: isLast ? x - 9 : x + 9, class: isLast ? 'point end' : 'point' };
          return svg('text', { y: y + 15, ...beside }, text);
        }),
      ];
    }),
  );
}

/** @param {readonly Place[]} places */
const joined = (places) => places.map(({ x, y }) => `${x.toFixed(1)} ${y.toFixed(1)}`).join('L');

/** A step has a tip where it ends. @param {Place} from @param {Place} to @param {import('./sketch.js').Line['kind']} kind */
function lineOf(from, to, kind) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const length = Math.hypot(dx, dy);
  if (kind === 'step' && length > 2 * before) {
    const share = 1 - before / length;
    return lineOf(from, { x: from.x + share * dx, y: from.y + share * dy }, 'shift');
  }
  const line = `M${joined([from, to])}`;
  if (kind !== 'shift' || length < tip) return line;
  const [ux, uy] = [(tip * dx) / length, (tip * dy) / length];
  const barb = (/** @type {1 | -1} */ way) => ({
    x: to.x - ux - (way * uy) / 2,
    y: to.y - uy + (way * ux) / 2,
  });
  return `${line}M${joined([barb(1), to, barb(-1)])}`;
}
