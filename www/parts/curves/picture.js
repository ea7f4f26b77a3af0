// A picture of runs against time: the lines on one canvas, redrawn when they change; the cursor, which is the robots' clock, on another.
/** @import { Size } from '../../kit/canvas.js' */
/** @import { Scale } from '../../kit/chart.js' */
/** @import { Tools } from '../part.js' */
import { createWatchedLayer } from '../../kit/canvas.js';
import { followPointer } from '../../kit/map.js';
import { followSize } from '../../kit/size.js';
import { watch } from '../../kit/memo.js';
import { isFree } from '../../run/guard.js';
import { sampleTime } from './axes.js';

/**
 * @template M, L
 * @typedef {object} Plots What is drawn of a model M, laid out as L.
 * @property {(model: M) => void} makeReady Throws a Pending as long as there is more to make than a frame can take.
 * @property {(size: Size, model: M) => L} layoutOf
 * @property {(context: CanvasRenderingContext2D, layout: L, model: M) => void} drawLines
 * @property {(context: CanvasRenderingContext2D, layout: L, model: M, time: number) => void} drawCursor
 */

/**
 * Whoever points at it sets the clock.
 * @template {{ driving: { time: Float64Array } }} M @template {{ time: Scale }} L
 * @param {HTMLElement} root It holds both canvases. @param {Tools} tools @param {Plots<M, L>} plots
 */
export function createPicture(root, { store, actions }, { makeReady, layoutOf, drawLines, drawCursor }) {
  const [lines, cursor] = root.querySelectorAll('canvas');
  const around = /** @type {HTMLElement} */ (lines.parentElement);
  const [under, over] = [lines, cursor].map(createWatchedLayer);
  const sizeOf = followSize(around, store.redraw);
  const changed = watch();
  /** @type {M['driving'] | null} */
  let driving = null;
  /** @type {L | null} */
  let layout = null;
  followPointer(around, (px) => {
    if (driving && layout && isFree(store.get(), 'clock'))
      actions.scrub(sampleTime(driving, layout.time.invert(px)));
  });

  return {
    /** @param {M} model @param {number} time */
    draw(model, time) {
      ({ driving } = model);
      const size = sizeOf();
      if (size.width === 0) return;
      makeReady(model);
      if (changed(size, ...Object.values(model)) || !layout) layout = layoutOf(size, model);
      const drawn = layout;
      under(size, [drawn], (context) => drawLines(context, drawn, model));
      over(size, [drawn, time], (context) => drawCursor(context, drawn, model, time));
    },
  };
}
