// The robots on the plane at a time: who drives, whom it is compared with, and the others.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Pins } from '../run/pins.js' */
/** @import { Scene } from '../run/scene.js' */
import { isTracking } from '../core/reference.js';
import { fillTextWithHalo } from '../kit/canvas.js';
import { textFont } from '../kit/fonts.js';
import { colour } from '../kit/palette.js';
import { drawMark } from '../kit/swatch.js';
import { keepInside } from '../kit/transform.js';
import { styles } from '../run/pins.js';
import { lab as strings } from '../words/index.js';
import { arrow, inMetres, kite, postureAt, referenceOf, sampleBefore, trace } from './track.js';

/** @param {CanvasRenderingContext2D} context @param {View} view @param {Scene} scene @param {Pins} pins @param {number} time */
export function drawRobots(context, view, scene, pins, time) {
  /** @param {Run} run @param {number} size */
  const robot = (run, size) => {
    const { x, y, theta } = postureAt(run, time);
    kite(context, view.screenX(x), view.screenY(y), theta, size);
  };
  context.fillStyle = colour('--ink');
  context.globalAlpha = 0.3;
  for (const run of scene.others) {
    robot(run, arrow.ghost);
    context.fill();
  }
  context.globalAlpha = 1;
  context.strokeStyle = colour('--muted');
  context.fillStyle = colour('--paper');
  context.lineWidth = 1.5;
  robot(scene.comparison, 12);
  context.fill();
  context.stroke();
  for (const [i, { slot }] of pins.entries()) {
    const { x, y } = postureAt(scene.pins[i], time);
    context.fillStyle = colour(styles[slot].token);
    robot(scene.pins[i], 12);
    context.fill();
    drawMark(context, styles[slot].mark, view.screenX(x), view.screenY(y) - 20, {
      fill: colour(styles[slot].token),
      edge: colour('--paper'),
    });
  }
  if (isTracking(scene.driving)) drawReference(context, view, scene.driving, time);
  drawTrail(context, view, scene.driving, time);
  context.fillStyle = colour('--ink');
  robot(scene.driving, arrow.robot);
  context.fill();
  drawStray(context, view, postureAt(scene.driving, time));
}

const inkOnPaper = () => ({ fill: colour('--ink'), halo: colour('--paper') });

/** The posture to follow: empty like the goal, from which it has come. @param {CanvasRenderingContext2D} context @param {View} view @param {Run} run @param {number} time */
function drawReference(context, view, run, time) {
  const { x, y, theta } = postureAt(referenceOf(run), time);
  const [px, py] = [view.screenX(x), view.screenY(y)];
  kite(context, px, py, theta, arrow.posture);
  context.strokeStyle = colour('--ink');
  context.fillStyle = colour('--paper');
  context.lineWidth = 2;
  context.fill();
  context.stroke();
  context.font = textFont;
  context.textAlign = 'left';
  context.textBaseline = 'middle';
  fillTextWithHalo(context, strings.referenceName, px + 22, py + 22, inkOnPaper());
}

/** @param {CanvasRenderingContext2D} context @param {View} view @param {Run} run @param {number} time */
function drawTrail(context, view, run, time) {
  const { x, y } = postureAt(run, time);
  context.save();
  inMetres(context, view);
  context.strokeStyle = colour('--ink');
  context.lineWidth = 3.5 / view.scale;
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.beginPath();
  trace(context, view, run, sampleBefore(run, time));
  context.lineTo(x, y);
  context.stroke();
  context.restore();
}

/** A robot outside the plane leaves a mark at the edge, with its distance from there. @param {CanvasRenderingContext2D} context @param {View} view @param {Posture} posture */
function drawStray(context, view, { x, y }) {
  const [px, py] = [view.screenX(x), view.screenY(y)];
  const edge = keepInside(view, px, py);
  const beyond = Math.hypot(px - edge.px, py - edge.py);
  if (beyond < 24) return;
  context.fillStyle = colour('--ink');
  kite(context, edge.px, edge.py, Math.atan2(edge.py - py, px - edge.px), 10);
  context.fill();
  context.font = textFont;
  context.textBaseline = 'middle';
  const inward = edge.px > view.width / 2 ? -1 : 1;
  const text = strings.outside(beyond / view.scale);
  context.textAlign = inward < 0 ? 'right' : 'left';
  fillTextWithHalo(context, text, edge.px + 18 * inward, edge.py, inkOnPaper());
}
