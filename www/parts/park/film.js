// The drives of one robot from all starts as a film, which ends soon after the last has parked.
/** @import { Drive } from './task.js' */

/** Seconds of the film: of one by hand, of the first generations, of the next ones, and of one that drives as the last one did. */
export const lengths = { hand: 3.6, first: 0.9, next: 0.5, same: 0.25 };
/** Seconds after which who has not parked is not waited for. */
const patience = 4;

/** @typedef {{ drives: readonly Drive[], others: readonly Drive[], end: number, pace: number, time: number }} Film `end` and `time` in seconds of the drive; `pace` in those of the drive a second. */

/** @param {readonly Drive[]} drives @param {readonly Drive[]} others @param {keyof typeof lengths} length @returns {Film} */
export function filmOf(drives, others, length) {
  const parked = drives.filter(({ run }) => run.arrived).map(({ run }) => run.finalTime);
  const end = Math.max(...parked, parked.length < drives.length ? patience : 0);
  return { drives, others, end, pace: Math.max(1, end / lengths[length]), time: 0 };
}

/** @param {Film} film @param {number} seconds @returns {Film} */
export const later = (film, seconds) => ({
  ...film,
  time: Math.min(film.end, film.time + seconds * film.pace),
});

/** @param {Film} film */
export const isOver = ({ time, end }) => time >= end;

/** How many have parked by now. @param {Film} film */
export const parkedBy = ({ drives, time }) =>
  drives.filter(({ run }) => run.arrived && run.finalTime <= time).length;
