// What plots against time share: the end of their axis, its ticks and those of the other one, and the samples.
/** @import { Run } from '../../core/engine.js' */
/** @import { Axes, Scale } from '../../kit/chart.js' */
import { drawNumbersBelow, levelsOn } from '../../kit/chart.js';
import { roundStep, sameDigits } from '../../kit/steps.js';
import words from './words/index.js';

/** So many times as long as the run in question others may take before they leave the picture. */
const longest = 2;

/** The end of the time axis, in steps, so that it does not move at each generation. @param {Pick<Run, 'time'>} driving @param {readonly Pick<Run, 'time'>[]} others */
export function endOf(driving, others) {
  const own = driving.time[driving.time.length - 1];
  const last = Math.max(own, ...others.map(({ time }) => time[time.length - 1]));
  const end = Math.min(last, longest * own) || 0.01;
  const step =
    end < 0.01 ? roundStep(end / 12) : ([0.01, 0.05, 0.25, 0.5, 1, 5].find((one) => end / one <= 12) ?? 10);
  return Math.ceil(end / step - 1e-9) * step;
}

/** As many as there is room to name. @param {Scale} time */
export function timeTicks(time) {
  const [left, right] = time.range();
  const roomFor = (/** @type {readonly number[]} */ ticks) =>
    Math.max(36, ...sameDigits(ticks).map((text) => 8 * words.seconds(text).length));
  const hasRoom = (/** @type {readonly number[]} */ ticks) => ticks.length * roomFor(ticks) <= right - left;
  const count = [6, 4, 2].find((most) => hasRoom(time.ticks(most))) ?? 1;
  return time.ticks(count);
}

/** Of the other axis. @param {Pick<Axes, 'frame' | 'y'>} axes */
export function ticksUp({ frame, y }) {
  const ticks = y.ticks(Math.max(2, Math.floor((frame.bottom - frame.top) / 30)));
  return ticks.length > 1 ? ticks : levelsOn(y);
}

/** @param {CanvasRenderingContext2D} context @param {Scale} time @param {number} bottom */
export function drawTimeAxis(context, time, bottom) {
  const ticks = timeTicks(time);
  drawNumbersBelow(context, time, bottom, ticks, sameDigits(ticks).map(words.seconds));
}

/** The time of the sample next to a time. @param {Pick<Run, 'time'>} run @param {number} time */
export function sampleTime({ time: samples }, time) {
  const last = samples.length - 1;
  if (last < 1) return 0;
  return samples[Math.min(last, Math.max(0, Math.round(time / samples[1])))];
}
