// The robots on the plane at a time: who drives, whom it is compared with, and the others.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Pins } from '../run/pins.js' */
/** @import { Scene } from '../run/scene.js' */
import { isTracking } from '../core/reference.js';
import { fillTextWithHalo } from '../kit/canvas.js';
import { setLettering } from '../kit/lettering.js';
import { colour } from '../kit/palette.js';
import { drawMark } from '../kit/swatch.js';
import { keepInside } from '../kit/transform.js';
import { styles } from '../run/pins.js';
import { lab as strings } from '../words/index.js';
import { drawCar } from './car.js';
import { emptyKite, inMetres, kite, postureAt, referenceOf, sampleBefore, sizes, trace } from './track.js';

/** @param {CanvasRenderingContext2D} context @param {View} view @param {Scene} scene @param {Pins} pins @param {number} time */
export function drawRobots(context, view, scene, pins, time) {
  const [ink, muted, paper] = [colour('--ink'), colour('--muted'), colour('--paper')];
  /** @param {Run} run @param {number} size @param {Parameters<typeof drawCar>[3]} look */
  const robot = (run, size, look) => {
    const { x, y, theta } = postureAt(run, time);
    drawCar(context, { x: view.screenX(x), y: view.screenY(y), theta }, size, look);
  };
  context.globalAlpha = 0.3;
  for (const run of scene.others) robot(run, sizes.ghost, { body: ink, wheel: ink, nose: paper });
  context.globalAlpha = 1;
  robot(scene.comparison, sizes.rival, { body: paper, wheel: muted, nose: muted, edge: muted });
  for (const [i, { slot }] of pins.entries()) {
    const { x, y } = postureAt(scene.pins[i], time);
    const own = colour(styles[slot].token);
    robot(scene.pins[i], sizes.rival, { body: own, wheel: own, nose: paper });
    drawMark(context, styles[slot].mark, view.screenX(x), view.screenY(y) - 20, {
      fill: colour(styles[slot].token),
      edge: colour('--paper'),
    });
  }
  if (isTracking(scene.driving)) drawReference(context, view, scene.driving, time);
  drawTrail(context, view, scene.driving, time);
  robot(scene.driving, sizes.robot, { body: ink, wheel: ink, nose: paper, edge: paper });
  drawStray(context, view, postureAt(scene.driving, time));
}

const inkOnPaper = () => ({ fill: colour('--ink'), halo: colour('--paper') });

/** The posture to follow: empty like the goal, from which it has come. @param {CanvasRenderingContext2D} context @param {View} view @param {Run} run @param {number} time */
function drawReference(context, view, run, time) {
  const { x, y, theta } = postureAt(referenceOf(run), time);
  const [px, py] = [view.screenX(x), view.screenY(y)];
  emptyKite(context, px, py, theta, '--ink');
  setLettering(context, {});
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
  const inward = edge.px > view.width / 2 ? -1 : 1;
  const text = strings.outside(beyond / view.scale);
  setLettering(context, { align: inward < 0 ? 'right' : 'left' });
  // Above the numbers of the axis.
  const textY = Math.min(edge.py, view.height - 44);
  fillTextWithHalo(context, text, edge.px + 18 * inward, textY, inkOnPaper());
}
