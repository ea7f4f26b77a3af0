// A run on the plane: where it is at a time, its line, and the arrow that is a robot.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
import { take } from '../kit/chart.js';
import { colour } from '../kit/palette.js';

/** @typedef {Pick<Run, 'time' | 'x' | 'y' | 'theta'>} Track */
/** The line of a run, up to a moment or its end. @typedef {{ run: Track, until?: number, token: string, alpha?: number, width: number, dash?: readonly number[], isRound?: boolean }} RunStroke In pixels; `isRound` are its ends. */

/** As large as they are drawn, in pixels: an arrow for a posture, half the length of a robot. */
export const sizes = { posture: 17, robot: 13, rival: 10, ghost: 6.5 };

/** @param {CanvasRenderingContext2D} context @param {Pick<View, 'scale' | 'originX' | 'originY'>} view */
export const inMetres = (context, { scale, originX, originY }) =>
  context.transform(scale, 0, 0, -scale, originX, originY);

/** The reference as if it were a robot. @param {Run} run @returns {Track} */
export const referenceOf = ({ time, referenceX, referenceY, referenceTheta }) => ({
  time,
  x: referenceX,
  y: referenceY,
  theta: referenceTheta,
});

/** A run up to a sample, without the steps too small to see. @param {CanvasRenderingContext2D} context @param {Pick<View, 'scale'>} view @param {Track} run @param {number} last */
export function trace(context, { scale }, { x, y }, last) {
  const least = 0.6 / scale;
  let drawn = 0;
  context.moveTo(x[0], y[0]);
  for (let i = 1; i <= last; i += 1) {
    if (i < last && Math.abs(x[i] - x[drawn]) + Math.abs(y[i] - y[drawn]) < least) continue;
    context.lineTo(x[i], y[i]);
    drawn = i;
  }
}

/** @param {CanvasRenderingContext2D} context @param {Pick<View, 'scale' | 'originX' | 'originY'>} view @param {readonly RunStroke[]} strokes Each over those before it. */
export function strokeRuns(context, view, strokes) {
  const metres = (/** @type {number} */ pixels) => pixels / view.scale;
  context.save();
  inMetres(context, view);
  context.lineJoin = 'round';
  for (const { run, until = Infinity, token, alpha = 1, width, dash = [], isRound = false } of strokes) {
    take(context, { token, width: metres(width), dash: dash.map(metres) });
    context.globalAlpha = alpha;
    context.lineCap = isRound ? 'round' : 'butt';
    context.beginPath();
    trace(context, view, run, sampleBefore(run, until));
    if (until < Infinity) {
      const { x, y } = postureAt(run, until);
      context.lineTo(x, y);
    }
    context.stroke();
  }
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {number} px @param {number} py @param {number} theta @param {number} size */
export function kite(context, px, py, theta, size) {
  const [c, s] = [Math.cos(theta) * size, -Math.sin(theta) * size];
  context.beginPath();
  context.moveTo(px + c, py + s);
  context.lineTo(px - 0.75 * c - 0.68 * s, py - 0.75 * s + 0.68 * c);
  context.lineTo(px - 0.35 * c, py - 0.35 * s);
  context.lineTo(px - 0.75 * c + 0.68 * s, py - 0.75 * s - 0.68 * c);
  context.closePath();
}

/** A posture at which no robot stands. @param {CanvasRenderingContext2D} context @param {number} px @param {number} py @param {number} theta @param {string} token */
export function emptyKite(context, px, py, theta, token) {
  kite(context, px, py, theta, sizes.posture);
  take(context, { token, width: 2 });
  context.fillStyle = colour('--paper');
  context.fill();
  context.stroke();
}

/** @param {Pick<Track, 'time'>} run @param {number} time */
export function sampleBefore(run, time) {
  const last = run.time.length - 1;
  if (last < 1 || time >= run.time[last]) return last;
  return Math.min(last, Math.floor(time / run.time[1] + 1e-9));
}

/** Where the robot is, between two samples on the straight line. @param {Track} run @param {number} time @returns {Posture} */
export function postureAt(run, time) {
  const i = sampleBefore(run, time);
  const j = Math.min(i + 1, run.time.length - 1);
  const part = i === j ? 0 : (time - run.time[i]) / (run.time[j] - run.time[i]);
  const between = (/** @type {Float64Array} */ values) => values[i] + part * (values[j] - values[i]);
  return { x: between(run.x), y: between(run.y), theta: between(run.theta) };
}
