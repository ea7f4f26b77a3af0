// The points of the map that have a name: marks that are seen on every shade, and the names beside them.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Frame } from '../../kit/chart.js' */
import { fillTextWithHalo, pathOf, strokeTwice } from '../../kit/canvas.js';
import { setLettering, strongFont } from '../../kit/lettering.js';
import { dark, light } from '../../kit/map.js';
import { pale } from '../../kit/palette.js';
import { drawMark } from '../../kit/swatch.js';
import { styles } from '../../run/pins.js';
import { middleOf, placeNames } from './names.js';

/** @typedef {{ gains: Triple, name: string, mark: keyof typeof outlines | number }} Point A number is the slot of a pin. */

/** The marks of points, around (0, 0). */
export const outlines = {
  diamond: 'M0-7 7 0 0 7-7 0z',
  cross: 'M-6-6 6 6M-6 6 6-6',
  ring: 'M7 0A7 7 0 1 1-7 0A7 7 0 1 1 7 0z',
  // Open in its middle, so that whoever stands there is seen.
  sight: 'M-11 0H-5M5 0H11M0-11V-5M0 5V11',
};

/** @typedef {Point & { place: readonly [number, number], isPale: boolean }} Placed */

/** As far as the strokes of the lowest point reach; other marks are wholly under what covers their middle. @param {Point['mark']} mark */
const reachOf = (mark) => (mark === 'sight' ? 12 : 8);

/** The names of points, and where they stand; those of the pins are in the legend, beside the same marks. @param {Frame} frame @param {readonly Placed[]} points @param {readonly (readonly [number, number])[]} best What no name covers besides the marks. @param {(name: string) => number} widthOf */
export function namesOf(frame, points, best, widthOf) {
  const isLowest = (/** @type {Placed} */ { mark }) => mark === 'sight';
  const others = points.filter((point) => typeof point.mark === 'string' && !isLowest(point));
  // What the picture is about has its name first, then the last that was put there.
  const named = [...points.filter(isLowest), ...others.reverse()].map(({ name, place: [x, y] }) => ({
    x,
    y,
    name,
    width: widthOf(name),
  }));
  const spots = points.map(({ place: [x, y], mark }) => /** @type {const} */ ([x, y, reachOf(mark)]));
  const sought = best.map(([x, y]) => /** @type {const} */ ([x, y, 8]));
  return placeNames(frame, named, spots, sought).map((place, i) => ({ name: named[i].name, place }));
}

/** Whole also at the edge, where a gain is 0. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {readonly Placed[]} points @param {readonly (readonly [number, number])[]} best */
export function drawPoints(context, frame, points, best) {
  context.save();
  context.lineJoin = 'round';
  for (const { place, mark, isPale } of points) {
    context.globalAlpha = isPale ? pale : 1;
    drawPoint(context, place, mark);
  }
  context.globalAlpha = 1;
  setLettering(context, { font: strongFont });
  const look = { fill: light, halo: dark, width: 4 };
  for (const { name, place } of namesOf(frame, points, best, (text) => context.measureText(text).width))
    if (place) fillTextWithHalo(context, name, place.left, middleOf(place), look);
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {readonly [number, number]} place @param {Point['mark']} mark */
function drawPoint(context, [px, py], mark) {
  if (typeof mark === 'number')
    return drawMark(context, styles[mark].mark, px, py, { fill: light, edge: dark });
  context.save();
  context.translate(px, py);
  strokeTwice(context, [dark, 5], [light, 2.5], pathOf(outlines[mark]));
  context.restore();
}
