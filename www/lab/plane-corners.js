// In which corner of the plane words stand: the legend, the name of the dotted run where that has no room beside the first one, and the two postures.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Room } from './plane-names.js' */
/** @import { Track } from './track.js' */
import { postureAt, referenceOf, sizes } from './track.js';
import { strongFont } from '../kit/lettering.js';
import { knobOf } from '../kit/transform.js';
import { isTracking } from '../core/reference.js';
import { around, meet, namesIn, paymentsOn, roomOf, widthOf } from './plane-names.js';
import { strayOf } from './robots.js';

/** At an edge, so far above the corner below. @typedef {{ corner: string, raised: number, room: Room }} Place */
/** What stands on the plane, and the runs there, of which the first is in ink. @typedef {{ view: View, ends: { start: Posture, goal: Posture }, runs: readonly Run[], isPaid: boolean }} Standing */

/** Of the legend, as its styles have it. */
const edge = { left: 56, right: 12, top: 12, bottom: 30 };
const [line, sample, widest] = [20, 28, 192];
/** Its letters are larger than those on canvases. */
const larger = 14 / 13;
/** The room of the two postures in words. */
const postures = { width: 210, height: 72, left: 56, right: 16, bottom: 36 };

/** Start and goal with their names and knobs, the robots at rest, and how far outside one is. @param {Standing} standing @returns {Room[]} */
function standing({ view, ends, runs, isPaid }) {
  const at = (/** @type {{ x: number, y: number }} */ { x, y }, /** @type {number} */ radius) =>
    around(view.screenX(x), view.screenY(y), radius);
  const last = (/** @type {Track} */ run) => postureAt(run, Infinity);
  const [driving, , ...pins] = runs;
  const stray = strayOf(view, last(driving));
  return [
    ...Object.values(ends).flatMap((end) => {
      const { px, py } = knobOf(view, end);
      // Where nothing is free, they are the last to be written over.
      return [...Array(3).fill(at(end, sizes.posture)), around(px, py, 8)];
    }),
    ...namesIn(view, ends, driving, isPaid, pins).map(roomOf),
    ...runs.map((run) => at(last(run), sizes.robot + 3)),
    ...(isTracking(driving) ? [at(last(referenceOf(driving)), sizes.posture)] : []),
    ...(stray ? [around(stray.px, stray.py, 12), roomOf(stray.name)] : []),
  ];
}

/** So many samples of a run tell where it passes: the longest drive has 100 000. */
const enough = 400;

/** How many samples of the runs lie there. @param {Standing} standing @param {Room} room */
function passing({ view, runs }, { left, right, top, bottom }) {
  const [low, high] = [view.world(left, bottom), view.world(right, top)];
  let count = 0;
  for (const { x, y } of runs)
    for (let i = 0; i < x.length; i += Math.ceil(x.length / enough))
      if (x[i] > low.x && x[i] < high.x && y[i] > low.y && y[i] < high.y) count += 1;
  return count;
}

/** What is written along the path. @param {Standing} standing */
const written = ({ view, ends, runs, isPaid }) =>
  isPaid
    ? paymentsOn(view, runs[0], ends.start, ends.goal).flatMap(({ name }) => (name ? [roomOf(name)] : []))
    : [];

/** The first that meets nothing, else the one that meets least. @template {Place} P @param {Standing} all @param {readonly P[]} places @param {readonly Room[]} [more] */
function emptiest(all, places, more = []) {
  const things = [...standing(all), ...written(all), ...more];
  let best = { place: places[0], met: Number.POSITIVE_INFINITY, passed: 0 };
  for (const place of places) {
    const met = things.filter((thing) => meet(thing, place.room)).length;
    if (met > best.met) continue;
    const passed = passing(all, place.room);
    if (met < best.met || passed < best.passed) best = { place, met, passed };
    if (met + passed === 0) break;
  }
  return best.place;
}

/** How large a text of the legend is that is no wider than `most`, in two lines if it must: its own at the right, and at the left below each other. @param {string} text @param {number} most @param {boolean} atLeft @param {string} [font] */
function sizeOf(text, most, atLeft, font) {
  const wide = (/** @type {string[]} */ words) => larger * widthOf(words.join(' '), font);
  const words = text.split(' ');
  const whole = sample + wide(words);
  if (whole <= most) return { width: whole, height: line };
  const broken = words
    .slice(1)
    .map((_, i) =>
      Math.max(sample + wide(words.slice(0, i + 1)), (atLeft ? sample : 0) + wide(words.slice(i + 1))),
    );
  return { width: Math.min(most, ...broken), height: 2 * line };
}

/** In which corners the legend may stand, the usual one first. */
const corners = /** @type {const} */ (['top left', 'top right', 'bottom left', 'bottom right']);
/** Up to this height a plane keeps no room for them. */
const lowest = 340;
/** So far from the lower edge, above the numbers of the axis. */
const aboveAxis = 34;

/** Where the names of the runs stand below each other. @param {View} view @param {(typeof corners)[number]} corner @param {readonly string[]} texts @returns {Room[]} */
function roomsIn({ width, height }, corner, texts) {
  const sizes = texts.map(
    (text, i) => sizeOf(text, Number.POSITIVE_INFINITY, true, i === 0 ? strongFont : undefined).width,
  );
  const left = corner.endsWith('left') ? edge.left : width - edge.right - Math.max(...sizes);
  const first = corner.startsWith('top') ? edge.top : height - aboveAxis - texts.length * line;
  return sizes.map((size, i) => {
    const top = first + i * line;
    return { left, right: left + size, top, bottom: top + line };
  });
}

/**
 * In which corner the names of the runs stand, and their rooms: the usual one, but on a plane that keeps no room for them one where they
 * lie neither on start and goal nor on a robot at rest; without the dotted run's where only that helps.
 * @param {Standing} all @param {readonly string[]} texts @param {string} dashed One of them.
 * @returns {{ corner: (typeof corners)[number], isShort: boolean, rooms: Room[] }}
 */
export function placeOfLegend(all, texts, dashed) {
  const { view } = all;
  const placed = [false, true].flatMap((isShort) => {
    const names = isShort ? texts.filter((text) => text !== dashed) : texts;
    return corners.map((corner) => ({ corner, isShort, rooms: roomsIn(view, corner, names) }));
  });
  const [usual] = placed;
  if (view.height > lowest) return usual;
  const things = standing(all);
  const isFree = (/** @type {Room} */ room) =>
    room.left >= edge.left && room.top > 0 && !things.some((thing) => meet(thing, room));
  const free = placed.filter(({ rooms }) => rooms.every(isFree));
  const first = free[0] ?? usual;
  if (first === usual) return usual;
  const crossed = (/** @type {typeof usual} */ { rooms }) =>
    rooms.reduce((sum, room) => sum + passing(all, room), 0);
  return free
    .filter(({ isShort }) => isShort === first.isShort)
    .reduce((best, one) => (crossed(one) < crossed(best) ? one : best));
}

/** Where the name of the dotted run stands: below on the right or on the left, under the first name, or else between; nowhere if everywhere it would lie on the drive in ink, on start, goal or a robot. @param {Standing} all @param {string} first @param {string} text */
export function placeOfName(all, first, text) {
  const { width, height } = all.view;
  const free = width - edge.left - edge.right;
  const top = edge.top + sizeOf(first, free, true, strongFont).height;
  /** @param {'left' | 'right'} side @param {number | 'above'} at @returns {Place} */
  const place = (side, at) => {
    const size = sizeOf(text, Math.min(widest, free), side === 'left');
    const left = side === 'left' ? edge.left : width - edge.right - size.width;
    const from = at === 'above' ? top : height - edge.bottom - at - size.height;
    const room = { left, right: left + size.width, top: from, bottom: from + size.height };
    return at === 'above' ? { corner: `above ${side}`, raised: 0, room } : { corner: side, raised: at, room };
  };
  const heights = Array.from(
    { length: Math.max(0, Math.floor((height - top - edge.bottom) / line) - 2) },
    (_, i) => i + 1,
  );
  const places = [
    place('right', 0),
    place('left', 0),
    place('left', 'above'),
    place('right', 'above'),
    ...heights.flatMap((i) => [place('right', i * line), place('left', i * line)]),
  ];
  const things = standing(all);
  const inInk = { ...all, runs: all.runs.slice(0, 1) };
  const empty = places.filter(
    ({ room }) => passing(inInk, room) === 0 && !things.some((thing) => meet(thing, room)),
  );
  return empty.length > 0 ? emptiest(all, empty) : { ...places[0], corner: 'none' };
}

/** Where the postures stand: below, or under the legend of so many lines, on the right or on the left. @param {Standing} all @param {number} lines @param {readonly Room[]} legend @returns {{ side: 'left' | 'right', under: number | null }} */
export function placeOfPostures(all, lines, legend) {
  const { width, height } = all.view;
  const below = height - postures.bottom - postures.height;
  const under = edge.top + lines * line + 6;
  const sides = { right: width - postures.right - postures.width, left: postures.left };
  const places = [below, under].flatMap((top) =>
    /** @type {const} */ (['right', 'left']).map((side) => ({
      corner: side,
      raised: below - top,
      side,
      under: top === below ? null : under,
      room: {
        left: sides[side],
        right: sides[side] + postures.width,
        top,
        bottom: top + postures.height,
      },
    })),
  );
  return emptiest(all, places, legend);
}
