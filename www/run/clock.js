// The robots' clock.
/** @import { RobotClock } from './state.js' */

const holdSeconds = 0.8;

/** From one place of the clock's slider to the next, in seconds; a drive that is over sooner has places, too. @param {number} finalTime */
export const scrubStep = (finalTime) => (finalTime < 0.1 ? finalTime / 100 : 0.01);

/**
 * The robot's clock some real seconds later. At the end it stops, or waits a moment and starts again.
 * @param {RobotClock} clock @param {number} seconds @param {number} speed @param {number} finalTime @param {boolean} loops
 * @returns {RobotClock}
 */
export function advanceRobot(clock, seconds, speed, finalTime, loops) {
  const time = Math.min(clock.time, finalTime) + seconds * speed;
  if (time < finalTime) return { time, held: 0, playing: true };
  const held = clock.held + seconds;
  if (loops)
    return held < holdSeconds
      ? { time: finalTime, held, playing: true }
      : { time: 0, held: 0, playing: true };
  return atEnd;
}

/** A clock that has run out stays at the end of whatever drives next. @type {RobotClock} */
export const atEnd = Object.freeze({ time: Number.MAX_VALUE, held: 0, playing: false });
/** @type {RobotClock} */
export const fromStart = Object.freeze({ time: 0, held: 0, playing: true });
