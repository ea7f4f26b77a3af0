// What the actions have in common: an experiment that begins, robots that drive again, and the box around all that must be seen.
/** @import { Engine, Experiment, PaperResult } from '../../core/engine.js' */
/** @import { Restart, State } from '../state.js' */
/** @import { RunStore } from '../store.js' */
import { isTracking, stationsOf } from '../../core/reference.js';
import { refit } from '../../kit/transform.js';
import { isLost, messageOf } from '../../words/errors.js';
import { atEnd, fromStart } from '../clock.js';
import { gainsOf } from '../drivers.js';
import { endsOf } from '../state.js';
import { afterChange } from '../undo.js';

/**
 * What the parts of the page make of a run.
 * @typedef {object} Places
 * @property {(page: string) => boolean} triesStarts Whether a start is tried there, and not given to evolution.
 * @property {(page: string) => boolean} triesDisturbance
 * @property {string} phases The part in which a generation is seen phase by phase.
 * @property {readonly import('../store.js').Slice<any>[]} slices Of all parts.
 */
/**
 * What actions are made of.
 * @typedef {object} Means
 * @property {Engine} engine
 * @property {RunStore} store
 * @property {PaperResult[]} paper
 * @property {() => number} finalTime Of the robot in ink.
 * @property {() => boolean} isStill Whether robots stand at their ends: for who wants no motion, or none yet.
 * @property {Places} places
 */
/** @typedef {Means & ReturnType<typeof createBasis>} Basis */

/** @param {Means} means */
export function createBasis({ engine, store, paper, isStill }) {
  /** Whatever is wrong is said, and the last good state stays. @param {() => void} act */
  const attempt = (act) => {
    try {
      act();
    } catch (error) {
      if (isLost(error)) throw error;
      store.update({ message: messageOf(error), evolving: false });
    }
  };

  /** Throws when the core refuses the experiment. @param {Experiment} experiment @param {Restart} restart @param {Partial<State>} patch */
  const tryToBegin = (experiment, restart, patch) => {
    const { statistics, population } = engine.begin(experiment);
    const before = store.get();
    store.update({
      experiment,
      history: [statistics],
      generation: 0,
      population,
      restart,
      catchingUp: null,
      message: '',
      settings: { ...before.settings, error: null },
      versions: afterChange(before, { experiment, preset: patch.preset ?? before.preset }),
      ...patch,
    });
  };

  /** @param {Experiment} experiment @param {Restart} restart @param {Partial<State>} [patch] */
  const begin = (experiment, restart, patch = {}) => attempt(() => tryToBegin(experiment, restart, patch));

  /** The robots drive from the start, or stand at the end. */
  const shown = () => (isStill() ? atEnd : fromStart);

  /** A robot at rest at its end shows what is new by driving again; one that was paused on the way stays there. */
  const driveAgain = () => {
    if (store.get().robot.time === atEnd.time) store.update({ robot: shown() });
  };

  /** The run of who drives, in the experiment of evolution. */
  const drivenRun = () => {
    const state = store.get();
    return engine.drive(state.experiment, [gainsOf(state, state.driver, paper)])[0];
  };

  /** What must be seen: start and goal, and where the reference comes by. */
  const inSight = () => {
    const ends = Object.values(endsOf(store.get()));
    const run = drivenRun();
    return isTracking(run) ? [...ends, ...stationsOf(run)] : ends;
  };

  const refitBox = () => {
    const { box, size } = store.get();
    store.update({ box: refit(box, size, inSight()) });
  };

  const settle = () => {
    refitBox();
    driveAgain();
  };

  return { attempt, tryToBegin, begin, shown, driveAgain, drivenRun, inSight, refitBox, settle };
}
