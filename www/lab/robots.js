// The robots on the plane at a time: who drives, whom it is compared with, and the others.
/** @import { Posture, Run } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Pins } from '../run/pins.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { PostureName } from './plane-names.js' */
import { isTracking } from '../core/reference.js';
import { fillTextWithHalo } from '../kit/canvas.js';
import { setLettering } from '../kit/lettering.js';
import { colour } from '../kit/palette.js';
import { drawMark } from '../kit/swatch.js';
import { keepInside } from '../kit/transform.js';
import { styles } from '../run/pins.js';
import { lab as strings } from '../words/index.js';
import { drawCar } from './car.js';
import { emptyKite, kite, postureAt, referenceOf, sizes, strokeRuns } from './track.js';

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
  strokeRuns(context, view, [{ run: scene.driving, until: time, token: '--ink', width: 3.5, isRound: true }]);
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

/** Of a robot outside the plane: where its mark stands at the edge, and how far it is from there. @param {View} view @param {Posture} posture */
export function strayOf(view, { x, y }) {
  const [farX, farY] = [view.screenX(x), view.screenY(y)];
  const { px, py } = keepInside(view, farX, farY);
  const beyond = Math.hypot(farX - px, farY - py);
  if (beyond < 24) return null;
  const inward = px > view.width / 2 ? -1 : 1;
  /** @type {PostureName} */
  const name = {
    text: strings.outside(beyond / view.scale),
    px: px + 18 * inward,
    // Above the numbers of the axis.
    py: Math.min(py, view.height - 44),
    align: inward < 0 ? 'right' : 'left',
  };
  return { px, py, angle: Math.atan2(py - farY, farX - px), name };
}

/** @param {CanvasRenderingContext2D} context @param {View} view @param {Posture} posture */
function drawStray(context, view, posture) {
  const stray = strayOf(view, posture);
  if (!stray) return;
  const { px, py, angle, name } = stray;
  context.fillStyle = colour('--ink');
  kite(context, px, py, angle, 10);
  context.fill();
  setLettering(context, { align: name.align });
  fillTextWithHalo(context, name.text, name.px, name.py, inkOnPaper());
}
