// The points of the map that have a name: marks that are seen on every shade, and the names beside them.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Frame } from '../../kit/chart.js' */
import { fillTextWithHalo, pathOf, strokeTwice } from '../../kit/canvas.js';
import { strongFont } from '../../kit/fonts.js';
import { dark, light } from '../../kit/map.js';
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

/** How much is seen of a mark that is not in the slice. */
export const pale = 0.5;

/** Whole also at the edge, where a gain is 0. @param {CanvasRenderingContext2D} context @param {Frame} frame @param {readonly (Point & { place: readonly [number, number], isPale: boolean })[]} points @param {readonly (readonly [number, number])[]} best What no name covers besides the marks. */
export function drawPoints(context, frame, points, best) {
  context.save();
  context.lineJoin = 'round';
  for (const { place, mark, isPale } of points) {
    context.globalAlpha = isPale ? pale : 1;
    drawPoint(context, place, mark);
  }
  context.globalAlpha = 1;
  context.font = strongFont;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  // The names of the pins are in the legend, beside the same marks.
  const named = points
    .filter(({ mark }) => typeof mark === 'string')
    // The last that was put there has its name first; that of the lowest stands below the map too.
    .reverse()
    .map(({ name, place: [x, y] }) => ({ x, y, name, width: context.measureText(name).width }));
  const spots = [...points.map(({ place }) => place), ...best].map(
    ([x, y]) => /** @type {const} */ ([x, y, 8]),
  );
  for (const [i, place] of placeNames(frame, named, spots).entries()) {
    const look = { fill: light, halo: dark, width: 4 };
    if (place) fillTextWithHalo(context, named[i].name, place.left, middleOf(place), look);
  }
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
