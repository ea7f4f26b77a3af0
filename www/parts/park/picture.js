// The parking place, and all robots on their way to it: a body, and two wheels that roll.
/** @import { Posture } from '../../core/engine.js' */
/** @import { Film } from './film.js' */
/** @import { Drive } from './task.js' */
import { circle, createLayer, createWatchedLayer, pathOf } from '../../kit/canvas.js';
import { once, watch } from '../../kit/memo.js';
import { colour } from '../../kit/palette.js';
import { viewAround } from '../../kit/transform.js';
import { inMetres, postureAt, sampleBefore, strokeRuns, trace } from '../../lab/track.js';
import { isOver } from './film.js';
import { axle } from './task.js';

/** @typedef {ReturnType<typeof planOf>} Plan */
/** @typedef {{ film: Film, theme: number, size: { width: number, height: number }, looked: number | null }} PictureModel `looked`: the robot that is looked at. */

/** Metres around the circle of starts. */
const margin = 0.45;
/** Metres between two lines on a wheel. */
const tread = 0.035;
/** In metres, ahead along x. */
const outlines = once(() => ({
  walls: pathOf('M-0.3 0.24H0.3V-0.24H-0.3'),
  arrow: pathOf('M-0.65 0H-0.35M-0.43 0.06L-0.35 0L-0.43 -0.06'),
  body: pathOf('M-0.085 -0.075H0.05Q0.125 -0.05 0.125 0Q0.125 0.05 0.05 0.075H-0.085Z'),
  nose: pathOf('M0.03 -0.035L0.08 0L0.03 0.035'),
}));

/** @param {readonly HTMLCanvasElement[]} canvases One on the other: the floor, the trails, the robots. @param {{ goal: Posture, radius: number }} place */
export function createParkPicture(canvases, place) {
  const [floor, robots] = [canvases[0], canvases[2]].map(createWatchedLayer);
  const trails = createLayer(canvases[1]);
  const trailsChanged = watch();
  /** The second of the drive up to which the trails stand. */
  let drawn = 0;

  /** @param {PictureModel} model */
  return ({ film, theme, size, looked }) => {
    if (size.width === 0) return;
    const plan = planOf(size, place);
    floor(size, [film.drives, film.others, theme], (context) => {
      const paths = (/** @type {readonly Drive[]} */ drives, /** @type {number} */ alpha) =>
        drives.map(({ run }) => ({ run, token: '--ink', alpha, width: 1 }));
      strokeRuns(context, plan, [...paths(film.others, 0.1), ...paths(film.drives, 0.16)]);
      drawBay(context, plan, place.goal);
    });
    /** @param {number} from */
    const trail = (from) => (/** @type {CanvasRenderingContext2D} */ context) =>
      drawTrails(context, plan, film, from);
    const isNew = trailsChanged(film.drives, isOver(film), theme, size);
    // Drawn anew, long trails would take most of a frame.
    if (isNew || film.time < drawn) trails.draw(size, trail(0));
    else if (film.time > drawn) trails.add(trail(drawn), trail(0));
    drawn = film.time;
    robots(size, [film, looked, theme], (context) => drawFilm(context, plan, film, looked));
  };
}

/** @param {{ width: number, height: number }} size @param {{ goal: Posture, radius: number }} place */
export const planOf = (size, { goal, radius }) => viewAround(goal, radius + margin, size);

/** Three walls, open to where one comes from, and the heading on the ground. @param {CanvasRenderingContext2D} context @param {Plan} plan @param {Posture} goal */
function drawBay(context, plan, { x, y, theta }) {
  context.save();
  inMetres(context, plan);
  context.translate(x, y);
  context.rotate(theta);
  context.lineWidth = 3 / plan.scale;
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.strokeStyle = colour('--ink');
  context.stroke(outlines().walls);
  context.lineWidth = 1.5 / plan.scale;
  context.stroke(outlines().arrow);
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {Plan} plan @param {Film} film @param {number} from Seconds of the drive. */
function drawTrails(context, plan, film, from) {
  const { drives, time } = film;
  const over = isOver(film);
  context.save();
  inMetres(context, plan);
  context.lineJoin = 'round';
  context.lineCap = 'round';
  context.lineWidth = 1.5 / plan.scale;
  for (const { run } of drives) {
    const [first, last] = [from, time].map((at) => postureAt(run, at));
    // Without transparency, so that no joint of two pieces is darker.
    context.strokeStyle = colour(over && !run.arrived ? '--error' : '--muted');
    context.beginPath();
    context.moveTo(first.x, first.y);
    for (let i = sampleBefore(run, from) + 1; i <= sampleBefore(run, time); i += 1)
      context.lineTo(run.x[i], run.y[i]);
    context.lineTo(last.x, last.y);
    context.stroke();
  }
  context.restore();
}

/** @param {CanvasRenderingContext2D} context @param {Plan} plan @param {Film} film @param {number | null} looked */
function drawFilm(context, plan, film, looked) {
  const { drives, time } = film;
  const over = isOver(film);
  const [ink, paper, error] = ['--ink', '--paper', '--error'].map(colour);
  context.save();
  inMetres(context, plan);
  // Small on a small screen, but to be seen as robots.
  const grown = Math.max(1, 7 / (plan.scale * (axle / 2)));
  if (looked !== null) drawLooked(context, plan, drives[looked].run, time, grown);
  for (const drive of drives) {
    const missed = over && !drive.run.arrived;
    // Hollow, so that not its colour alone tells it.
    const colours = missed
      ? { body: paper, line: error, wheel: error, tread: paper }
      : { body: ink, line: paper, wheel: ink, tread: paper };
    drawRobot(context, drive, time, grown, colours);
  }
  context.restore();
}

/** Its path, and a ring around it. In metres. @param {CanvasRenderingContext2D} context @param {Plan} plan @param {Drive['run']} run @param {number} time @param {number} grown */
function drawLooked(context, plan, run, time, grown) {
  const { x, y } = postureAt(run, time);
  context.strokeStyle = colour('--ink');
  context.lineWidth = 2.5 / plan.scale;
  context.beginPath();
  trace(context, plan, run, sampleBefore(run, time));
  context.stroke();
  circle(context, x, y, 0.24 * grown);
  context.stroke();
}

/** In metres. @param {CanvasRenderingContext2D} context @param {Drive} drive @param {number} time @param {number} grown @param {{ body: string, line: string, wheel: string, tread: string }} colours */
function drawRobot(context, { run, left, right }, time, grown, { body, line, wheel, tread: marks }) {
  const { x, y, theta } = postureAt(run, time);
  const at = sampleBefore(run, time);
  const half = axle / 2;
  context.save();
  context.translate(x, y);
  context.rotate(theta);
  context.scale(grown, grown);
  for (const [side, rolled] of /** @type {const} */ ([
    [half, left[at]],
    [-half, right[at]],
  ])) {
    context.fillStyle = wheel;
    context.fillRect(-0.065, side - 0.025, 0.13, 0.05);
    context.strokeStyle = marks;
    context.lineWidth = 0.011;
    context.beginPath();
    // A wheel seen from above rolls forwards over the ground.
    for (let mark = -0.065 + (((rolled % tread) + tread) % tread); mark < 0.065; mark += tread) {
      context.moveTo(mark, side - 0.02);
      context.lineTo(mark, side + 0.02);
    }
    context.stroke();
  }
  context.fillStyle = body;
  context.strokeStyle = line;
  context.lineWidth = 0.014;
  context.fill(outlines().body);
  context.stroke(outlines().body);
  context.stroke(outlines().nose);
  context.restore();
}
