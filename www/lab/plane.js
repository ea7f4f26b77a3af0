// The plane in metres: paths on one canvas, redrawn when they change; robots on another, redrawn as they move.
/** @import { Posture } from '../core/engine.js' */
/** @import { View } from '../kit/transform.js' */
/** @import { Pins } from '../run/pins.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { Payment, PostureName } from './plane-names.js' */
import { createWatchedLayer, fillTextWithHalo, sharpLine } from '../kit/canvas.js';
import { take } from '../kit/chart.js';
import { setLettering } from '../kit/lettering.js';
import { colour, pale } from '../kit/palette.js';
import { multiples, roundStep } from '../kit/steps.js';
import { styles } from '../run/pins.js';
import { knobOf } from '../kit/transform.js';
import { isTracking } from '../core/reference.js';
import { lab as strings } from '../words/index.js';
import { isSmall, namesIn, paymentsOn, widthOf } from './plane-names.js';
import { drawRobots } from './robots.js';
import { emptyKite, kite, referenceOf, sizes, strokeRuns } from './track.js';

/** @typedef {{ view: View, scene: Scene, start: Posture, goal: Posture, pins: Pins, pays: boolean, time: number, theme: number }} PlaneModel With `pays`, where along the path J was paid. */

/** @param {HTMLCanvasElement} pathsCanvas @param {HTMLCanvasElement} robotsCanvas */
export function createPlane(pathsCanvas, robotsCanvas) {
  const [paths, robots] = [pathsCanvas, robotsCanvas].map(createWatchedLayer);

  /** @param {PlaneModel} model */
  const draw = ({ view, scene, start, goal, pins, pays, time, theme }) => {
    const { driving, others, comparison } = scene;
    const shown = [driving, others, comparison, scene.pins, theme];
    paths(view, [...shown, start, goal, pays], (context) => {
      const isPaid = pays && !isSmall(view);
      const names = namesIn(view, { start, goal }, driving, isPaid, scene.pins);
      drawGrid(context, view, names);
      drawPinnedGoals(context, view, pins, goal);
      drawPaths(context, view, scene, pins);
      if (isPaid) drawPayments(context, paymentsOn(view, driving, start, goal));
      drawTarget(context, view, start, '--muted');
      drawTarget(context, view, goal, '--ink');
      drawPostureNames(context, names);
    });
    robots(view, [...shown, time], (context) => drawRobots(context, view, scene, pins, time));
  };
  return { draw };
}

/** @param {CanvasRenderingContext2D} context @param {View} view @param {readonly PostureName[]} names Over a number they would leave pieces of it. */
function drawGrid(context, view, names) {
  const step = roundStep(Math.min(140, view.width / 4.5) / view.scale);
  const digits = Math.max(0, -Math.floor(Math.log10(step) + 1e-9));
  const low = view.world(0, view.height);
  const high = view.world(view.width, 0);
  const heights = multiples(low.y, high.y, step);
  // No number leads out of the picture.
  const edge = 4 + Math.max(30, ...heights.map((y) => widthOf(strings.fixed(y, digits))));
  const { width, middle } = sharpLine(context, 1);
  take(context, { token: '--hairline', width });
  setLettering(context, { align: 'center', baseline: 'alphabetic' });
  context.beginPath();
  for (const x of multiples(low.x, high.x, step)) {
    const px = middle(view.screenX(x));
    if (px < edge + 10) continue;
    context.moveTo(px, 0);
    context.lineTo(px, view.height - 28);
    const isNamed = names.some((name) => Math.abs(name.px - px) < 40 && name.py > view.height - 34);
    if (px < view.width - 20 && !isNamed)
      context.fillText(`${strings.fixed(x, digits)} m`, px, view.height - 10);
  }
  setLettering(context, { align: 'right' });
  for (const y of heights) {
    const py = middle(view.screenY(y));
    if (py > view.height - 32) continue;
    context.moveTo(edge + 10, py);
    context.lineTo(view.width, py);
    if (py > 12) context.fillText(strings.fixed(y, digits), edge, py);
  }
  context.stroke();
}

/** @param {CanvasRenderingContext2D} context @param {View} view @param {Scene} scene @param {Pins} pins */
function drawPaths(context, view, scene, pins) {
  const { others, comparison, driving } = scene;
  strokeRuns(context, view, [
    ...others.map((run) => ({ run, token: '--muted', alpha: pale, width: 1, isRound: true })),
    { run: comparison, token: '--muted', width: 2, dash: [2, 6], isRound: true },
    ...pins.map(({ slot }, i) => ({ run: scene.pins[i], ...styles[slot], width: 2 })),
    { run: driving, token: '--ink', alpha: 0.4, width: 1.5, isRound: true },
    ...(isTracking(driving)
      ? [{ run: referenceOf(driving), token: '--ink', width: 1, dash: [8, 6], isRound: true }]
      : []),
  ]);
}

/** Where pinned drives had another goal. @param {CanvasRenderingContext2D} context @param {View} view @param {Pins} pins @param {Posture} goal */
function drawPinnedGoals(context, view, pins, goal) {
  for (const { slot, experiment } of pins) {
    const { x, y, theta } = experiment.goal;
    if (x === goal.x && y === goal.y && theta === goal.theta) continue;
    kite(context, view.screenX(x), view.screenY(y), theta, sizes.posture);
    take(context, { token: styles[slot].token, width: 1.5 });
    context.globalAlpha = 0.6;
    context.stroke();
    context.globalAlpha = 1;
  }
}

/** @param {CanvasRenderingContext2D} context @param {readonly Payment[]} payments */
function drawPayments(context, payments) {
  const half = 5;
  for (const { px, py, across, up, name } of payments) {
    take(context, { token: '--ink', width: 1.5 });
    context.beginPath();
    context.moveTo(px - half * across, py - half * up);
    context.lineTo(px + half * across, py + half * up);
    context.stroke();
    if (name) drawPostureNames(context, [name]);
  }
}

/** @param {CanvasRenderingContext2D} context @param {readonly PostureName[]} names */
function drawPostureNames(context, names) {
  for (const { text, px, py, align } of names) {
    setLettering(context, { align });
    fillTextWithHalo(context, text, px, py, { fill: colour('--muted'), halo: colour('--paper') });
  }
}

/** Start or goal: an empty arrow, and the knob that turns it. @param {CanvasRenderingContext2D} context @param {View} view @param {Posture} posture @param {string} token */
function drawTarget(context, view, posture, token) {
  const knob = knobOf(view, posture);
  const [px, py] = [view.screenX(posture.x), view.screenY(posture.y)];
  const [ahead, down] = [Math.cos(posture.theta), -Math.sin(posture.theta)];
  take(context, { token: '--muted', width: 1 });
  context.beginPath();
  context.moveTo(px + sizes.posture * ahead, py + sizes.posture * down);
  context.lineTo(knob.px - 5 * ahead, knob.py - 5 * down);
  context.moveTo(knob.px + 5, knob.py);
  context.arc(knob.px, knob.py, 5, 0, 2 * Math.PI);
  context.stroke();
  emptyKite(context, px, py, posture.theta, token);
}
