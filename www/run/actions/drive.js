// Whose gains drive, under what, and the robots' clock.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Disturbance, Driver, Found } from '../state.js' */
/** @import { Basis } from './basis.js' */
import { isLost, messageOf } from '../../words/errors.js';
import { lab as words } from '../../words/index.js';
import { advanceRobot, atEnd, fromStart, scrubStep } from '../clock.js';
import { gainsOf } from '../drivers.js';
import { noErrors } from '../first.js';
import { isFree } from '../guard.js';
import { afterHand } from '../undo.js';

/** @param {Basis} basis */
export function createDrive({ engine, store, paper, attempt, shown, driveAgain }) {
  /** @param {readonly number[]} gains @param {Found} [found] @param {boolean} [areNew] Whether no hand has come to them from those that it had. */
  const driveByHand = (gains, found = 'hand', areNew = store.get().driver !== 'hand') => {
    const handGains = /** @type {Triple} */ (gains);
    const before = store.get();
    engine.check(before.experiment, handGains);
    // Who cannot choose who drives has no other way back.
    const isOwn = before.handGains ? before.found === 'hand' : !isFree(before, 'drives');
    const isLost = areNew && String(before.handGains) !== String(gains);
    const versions = isOwn && isLost ? afterHand(before) : before.versions;
    store.update({ handGains, found, driver: 'hand', gainErrors: noErrors, message: '', versions });
  };

  /** @param {number} index @param {string} error */
  const refuseGain = (index, error) =>
    store.update({
      gainErrors: /** @type {[string, string, string]} */ (
        noErrors.map((none, i) => (i === index ? error : none))
      ),
    });

  /** @param {number} index @param {number} value */
  const withGain = (index, value) =>
    gainsOf(store.get(), store.get().driver, paper).map((gain, i) => (i === index ? value : gain));

  return {
    driveAgain,

    /** @param {Driver} driver */
    chooseDriver(driver) {
      const state = store.get();
      const handGains = state.handGains ?? gainsOf(state, state.driver, paper);
      store.update({
        driver,
        handGains: driver === 'hand' ? handGains : state.handGains,
        gainErrors: noErrors,
        robot: shown(),
      });
    },

    /** @param {number} index @param {number} value */
    slideGain(index, value) {
      attempt(() => driveByHand(withGain(index, value)));
    },

    /** Drives by hand with all three gains. @param {Triple} gains @param {Found} [found] */
    driveGains(gains, found) {
      attempt(() => driveByHand(gains, found, true));
    },

    /** @param {number} index @param {string} text */
    typeGain(index, text) {
      const value = words.numberOf(text);
      const { name } = words.gains[index];
      if (!Number.isFinite(value)) return refuseGain(index, words.notANumber(name, text));
      try {
        driveByHand(withGain(index, value));
        driveAgain();
      } catch (error) {
        if (isLost(error)) throw error;
        refuseGain(index, words.gainRefused(name, messageOf(error)));
      }
    },

    /** Drives under a disturbance that evolution does not see. The core throws if it is out of range. @param {Disturbance} tried */
    tryDisturbance(tried) {
      const { experiment, trial } = store.get();
      engine.experiment({ ...experiment, disturbance: tried });
      store.update({ trial: { ...trial, disturbance: tried }, tried });
    },
  };
}

/** @param {Basis} basis */
export function createClock({ store, finalTime }) {
  /** @param {number} time */
  const standAt = (time) =>
    store.update({ robot: time >= finalTime() ? atEnd : { time, held: 0, playing: false } });

  return {
    /** Some real seconds go by. @param {number} seconds */
    advance(seconds) {
      const { robot, speed, evolving } = store.get();
      if (robot.playing) store.update({ robot: advanceRobot(robot, seconds, speed, finalTime(), evolving) });
    },

    togglePlay() {
      const { robot } = store.get();
      if (robot.playing)
        store.update({ robot: { ...robot, time: Math.min(robot.time, finalTime()), playing: false } });
      else store.update({ robot: robot.time < finalTime() ? { ...robot, playing: true } : fromStart });
    },

    /** @param {number} speed */
    setSpeed(speed) {
      store.update({ speed });
    },

    /** The last step of a slider may come short of the end. @param {number} time */
    scrub: (time) =>
      standAt(time > 0 && finalTime() - time < (1 - 1e-7) * scrubStep(finalTime()) ? finalTime() : time),

    /** As the page itself asks for it, where scrubbing may be locked. */
    standAt,
  };
}
