// The gains in the parts of V̇ that are theirs, where there is room for them: colours alone name nothing in grey.
/** @import { Axes } from '../../../kit/chart.js' */
/** @import { Area } from './layout.js' */
import { drawSymbol } from '../../../kit/names.js';
import { lab } from '../../../words/index.js';

/** A gain in a formula, in pixels. */
const [wide, high] = [20, 22];
/** So many places are tried. */
const tried = 300;

/**
 * The middle of the tallest place as wide as a name within a part; nothing where none is high enough.
 * @param {Axes} axes @param {ArrayLike<number>} time @param {Area} area @returns {{ x: number, y: number } | null}
 */
export function roomIn({ x, y, frame }, time, { from, to }) {
  const inside = (/** @type {number} */ value) => Math.min(Math.max(y(value), frame.top), frame.bottom);
  const half = Math.ceil(wide / 2 / (x(time[1]) - x(time[0])));
  const every = Math.ceil(time.length / tried);
  let [most, place] = [high, /** @type {{ x: number, y: number } | null} */ (null)];
  for (let i = half; i + half < time.length; i += every) {
    const edges = [i - half, i, i + half].map((at) => [inside(from[at]), inside(to[at])]);
    const top = Math.max(...edges.map((pair) => Math.min(...pair)));
    const bottom = Math.min(...edges.map((pair) => Math.max(...pair)));
    if (bottom - top > most) [most, place] = [bottom - top, { x: x(time[i]), y: (top + bottom) / 2 }];
  }
  return place;
}

/** @param {CanvasRenderingContext2D} context @param {Axes} axes @param {ArrayLike<number>} time @param {readonly Area[]} areas */
export function drawPartNames(context, axes, time, areas) {
  for (const area of areas) {
    const place = roomIn(axes, time, area);
    if (place) drawSymbol(context, lab.gains[area.part], '--ink', place.x - wide / 2, place.y + 4);
  }
}
