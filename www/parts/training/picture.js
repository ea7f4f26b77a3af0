// A picture of starts around the goal: filled where the robot arrives; small, pale red and without a tail where it does not.
/** @import { Posture, Run } from '../../core/engine.js' */
import { circle, createWatchedLayer, strokeTwice } from '../../kit/canvas.js';
import { followSize } from '../../kit/size.js';
import { arrowOf, isChord } from '../../kit/keyboard.js';
import { colour } from '../../kit/palette.js';
import { viewAround } from '../../kit/transform.js';
import { kite } from '../../lab/track.js';

/**
 * @typedef {object} PictureModel
 * @property {readonly Posture[]} starts
 * @property {Uint8Array | null} arrived Null: nobody has driven yet.
 * @property {Posture} goal
 * @property {Posture | null} tried The start that a robot drives from now.
 * @property {Pick<Run, 'x' | 'y'>} driving Its drive.
 * @property {number} theme
 */

/** Metres beside the outermost start, for its arrow. */
const margin = 0.3;
/** As near as a press must come to a start, in pixels. */
const nearest = 18;
/** So strong, and so large, is what does not arrive, beside what does. */
const missing = { alpha: 0.65, size: 0.75 };

/** @param {HTMLCanvasElement} canvas `radius`: metres around the goal that are shown. @param {{ radius: number, onTry: (start: Posture) => void, onSize: () => void }} options */
export function createPicture(canvas, { radius, onTry, onSize }) {
  const drawWatched = createWatchedLayer(canvas);
  const sizeOf = followSize(canvas, onSize);
  /** @type {PictureModel | null} */
  let model = null;

  const viewOf = (/** @type {Posture} */ goal) => viewAround(goal, radius + margin, sizeOf());

  /** Known at once, because a second key may come before the next frame. @param {PictureModel} from @param {Posture} tried */
  const drive = (from, tried) => {
    model = { ...from, tried };
    onTry(tried);
  };

  canvas.addEventListener('click', ({ offsetX, offsetY }) => {
    if (!model) return;
    const { screenX, screenY } = viewOf(model.goal);
    const distances = model.starts.map(({ x, y }) => Math.hypot(screenX(x) - offsetX, screenY(y) - offsetY));
    const least = Math.min(...distances);
    if (least <= nearest) drive(model, model.starts[distances.indexOf(least)]);
  });

  canvas.addEventListener('keydown', (event) => {
    const arrow = arrowOf(event.key);
    if (!model || !arrow || isChord(event)) return;
    event.preventDefault();
    const { starts, tried } = model;
    const step = arrow[0] - arrow[1];
    const now = starts.findIndex((start) => isSame(start, tried));
    const next = now < 0 ? (step > 0 ? 0 : -1) : now + step;
    drive(model, starts[(next + starts.length) % starts.length]);
  });

  return {
    /** @param {PictureModel} next */
    draw(next) {
      model = next;
      const { starts, arrived, goal, tried, driving, theme } = next;
      drawWatched(sizeOf(), [starts, arrived, goal, tried, tried && driving, theme], (context) =>
        drawStarts(context, next, viewOf(goal)),
      );
    },
  };
}

/** @param {Posture} a @param {Posture | null} b */
const isSame = (a, b) => b !== null && a.x === b.x && a.y === b.y && a.theta === b.theta;

/** @param {CanvasRenderingContext2D} context @param {PictureModel} model @param {ReturnType<typeof viewAround>} view */
function drawStarts(context, { starts, arrived, goal, tried, driving }, { scale, screenX, screenY }) {
  const [ink, muted, paper, error] = ['--ink', '--muted', '--paper', '--error'].map(colour);
  const isCrowded = starts.length > 100;
  // As large as fits, so that one does not hide the next.
  const size = isCrowded ? Math.max(2.6, 0.1 * scale) : Math.max(6, 0.22 * scale);
  context.lineJoin = 'round';
  context.fillStyle = ink;
  context.strokeStyle = arrived ? error : muted;
  context.lineWidth = isCrowded ? Math.max(1, size / 4) : 1.5;
  for (const [i, { x, y, theta }] of starts.entries()) {
    if (arrived && !arrived[i]) {
      context.globalAlpha = missing.alpha;
      chevron(context, screenX(x), screenY(y), theta, missing.size * size);
      context.stroke();
      context.globalAlpha = 1;
    } else {
      kite(context, screenX(x), screenY(y), theta, size);
      if (arrived) context.fill();
      else context.stroke();
    }
  }
  const current = starts.find((start) => isSame(start, tried));
  if (current) {
    context.beginPath();
    for (const [i, x] of driving.x.entries()) context.lineTo(screenX(x), screenY(driving.y[i]));
    strokeTwice(context, [paper, 5], [ink, 2]);
  }
  kite(context, screenX(goal.x), screenY(goal.y), goal.theta, 12);
  context.fillStyle = paper;
  context.strokeStyle = ink;
  context.lineWidth = 2;
  context.fill();
  context.stroke();
  if (!current) return;
  circle(context, screenX(current.x), screenY(current.y), size + 5);
  strokeTwice(context, [paper, 5], [ink, 2]);
}

/** The tip of a kite alone. @param {CanvasRenderingContext2D} context @param {number} px @param {number} py @param {number} theta @param {number} size */
function chevron(context, px, py, theta, size) {
  const [c, s] = [Math.cos(theta) * size, -Math.sin(theta) * size];
  context.beginPath();
  context.moveTo(px - 0.75 * c - 0.68 * s, py - 0.75 * s + 0.68 * c);
  context.lineTo(px + c, py + s);
  context.lineTo(px - 0.75 * c + 0.68 * s, py - 0.75 * s - 0.68 * c);
}

/** What its two signs look like, in a square of 20. */
export const signs = { arrives: 'M10 0L-7.5 6.8L-3.5 0L-7.5 -6.8Z', misses: 'M-7.5 6.8L10 0L-7.5 -6.8' };
