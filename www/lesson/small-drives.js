// Drives as small pictures side by side, each from the same start to the same goal, at the same time.
import { drawBay, drawCar } from '../lab/car.js';
import { postureAt, trace } from '../lab/track.js';
import { createLayer } from '../kit/canvas.js';
import { create, followSize } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { colour } from '../kit/palette.js';
import { boxAround } from '../kit/transform.js';

/** @import { Experiment, Run } from '../core/engine.js' */
/** @import { Store } from '../run/store.js' */

/** @param {Store} store */
export function createSmallDrive(store) {
  const canvas = /** @type {HTMLCanvasElement} */ (create('canvas', ''));
  canvas.setAttribute('aria-hidden', 'true');
  const element = create('div', 'small-drive layers', canvas);
  const layer = createLayer(canvas);
  const sizeOf = followSize(element, () => store.redraw());
  const changed = watch();
  return {
    element,
    /** @param {Experiment} experiment @param {Run} run @param {number} time @param {number} theme @param {{ car: number, token?: string }} look */
    draw(experiment, run, time, theme, { car, token = '--ink' }) {
      const size = sizeOf();
      if (
        size.width === 0 ||
        !changed(experiment, run, Math.min(time, run.finalTime), theme, token, size.width, size.height)
      )
        return;
      const half = Math.min(car, Math.min(size.width, size.height) / 12);
      layer.draw(size, (context) => drawRun(context, size, { experiment, run, time, car: half, token }));
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {{ width: number, height: number }} size @param {{ experiment: Experiment, run: Run, time: number, car: number, token: string }} what */
function drawRun(context, { width, height }, { experiment, run, time, car, token }) {
  const { left, right, top, bottom } = boxAround([experiment.starts[0], experiment.goal]);
  const room = 2.6 * car;
  const scale = Math.min((width - 2 * room) / (right - left), (height - 2 * room) / (top - bottom));
  const [originX, originY] = [
    width / 2 - (scale * (left + right)) / 2,
    height / 2 + (scale * (bottom + top)) / 2,
  ];
  const onCanvas = (/** @type {{ x: number, y: number, theta: number }} */ { x, y, theta }) => ({
    x: originX + x * scale,
    y: originY - y * scale,
    theta,
  });
  drawBay(context, onCanvas(experiment.goal), 1.3 * car, colour('--muted'));
  context.save();
  context.transform(scale, 0, 0, -scale, originX, originY);
  context.lineWidth = 1.5 / scale;
  context.strokeStyle = colour(token);
  context.beginPath();
  trace(context, /** @type {any} */ ({ scale }), run, run.time.length - 1);
  context.globalAlpha = 0.5;
  context.stroke();
  context.restore();
  drawCar(context, onCanvas(postureAt(run, time)), car, {
    body: colour(token),
    wheel: colour('--muted'),
    nose: colour('--paper'),
  });
}
