// Drives as small pictures side by side, each from the same start to the same goal, at the same time.
import { drawBay, drawCar } from '../../lab/car.js';
import { inMetres, postureAt, trace } from '../../lab/track.js';
import { circle, createWatchedLayer } from '../../kit/canvas.js';
import { create } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { colour, pale } from '../../kit/palette.js';
import { planeAround } from './plane-around.js';

/** @import { Experiment, Run } from '../../core/engine.js' */
/** @import { Size } from '../../kit/canvas.js' */
/** @import { Store } from '../../run/store.js' */

/** @param {Store} store */
export function createSmallDrive(store) {
  const canvas = /** @type {HTMLCanvasElement} */ (create('canvas', { 'aria-hidden': 'true' }));
  const element = create('div', 'small-drive layers', canvas);
  const drawWatched = createWatchedLayer(canvas);
  const sizeOf = followSize(element, () => store.redraw());
  return {
    element,
    /**
     * @param {Experiment} experiment @param {Run} run @param {number} time @param {number} theme
     * @param {{ car: number, token?: string, others: readonly (Run | null)[], beat?: number }} look With the drives of others, pale, and a dot on its own every so many seconds.
     */
    draw(experiment, run, time, theme, { car, token = '--ink', others, beat = 0 }) {
      const size = sizeOf();
      const half = Math.min(car, Math.min(size.width, size.height) / 12);
      const shown = [experiment, run, others, Math.min(time, run.finalTime), theme, token];
      drawWatched(size, shown, (context) =>
        drawRun(context, size, { experiment, run, others, beat, time, car: half, token }),
      );
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {{ experiment: Experiment, run: Run, others: readonly (Run | null)[], beat: number, time: number, car: number, token: string }} what */
function drawRun(context, size, { experiment, run, others, beat, time, car, token }) {
  const plane = planeAround([experiment.starts[0], experiment.goal], size, 2.6 * car + 2);
  drawBay(context, plane.placeOf(experiment.goal), 1.3 * car, colour('--muted'));
  context.save();
  inMetres(context, plane);
  context.lineWidth = 1.5 / plane.scale;
  for (const one of [...others.filter((other) => other !== run), run]) {
    if (!one) continue;
    context.strokeStyle = colour(one === run ? token : '--muted');
    context.globalAlpha = one === run ? 0.7 : pale;
    context.beginPath();
    trace(context, plane, one, one.time.length - 1);
    context.stroke();
  }
  context.restore();
  context.fillStyle = colour(token);
  for (const moment of beats(run, beat)) {
    const { x, y } = plane.placeOf(postureAt(run, moment));
    circle(context, x, y, 2.5);
    context.fill();
  }
  drawCar(context, plane.placeOf(postureAt(run, time)), car, {
    body: colour(token),
    wheel: colour('--muted'),
    nose: colour('--paper'),
  });
}

/** The moments of a drive that have a dot. @param {Run} run @param {number} beat */
const beats = ({ finalTime }, beat) =>
  beat > 0 ? Array.from({ length: Math.floor(finalTime / beat) + 1 }, (_, i) => i * beat) : [];
