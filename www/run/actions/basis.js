// What the actions have in common: an experiment that begins, robots that drive again, and the box around all that must be seen.
/** @import { Engine, Experiment, PaperResult, Posture } from '../../core/engine.js' */
/** @import { Next, Restart, State } from '../state.js' */
/** @import { RunStore } from '../store.js' */
import { Pending, whenThere } from '../../core/pending.js';
import { isTracking, stationsOf } from '../../core/reference.js';
import { boxAround, refit } from '../../kit/transform.js';
import { isLost, messageOf, orSay } from '../../words/errors.js';
import { atEnd, fromStart } from '../clock.js';
import { gainsOf } from '../drivers.js';
import { asked, endsOf, evolvedOf } from '../state.js';
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
/** @typedef {Omit<import('../state.js').Computing, 'since' | 'share'>} Waiting */
/** @typedef {Means & ReturnType<typeof createBasis>} Basis */

/** @param {Means} means */
export function createBasis(means) {
  const sight = createSight(means);
  const waiting = createWaiting(means.store, sight.refitBox);
  return { ...sight, ...waiting, ...createBeginning(means, waiting) };
}

/** What takes long is waited for, and whatever is wrong is said. @param {RunStore} store @param {() => void} refitBox */
function createWaiting(store, refitBox) {
  /** What is to be done once a worker has computed what it takes; only the newest is. @type {(() => void) | null} */
  let due = null;
  /** @type {(() => void)[]} */
  const idlers = [];

  /** Whatever is under way is no longer waited for. */
  const forget = () => {
    due = null;
    if (store.get().computing) store.update({ computing: null });
    for (const tell of idlers.splice(0)) tell();
  };

  /** @param {() => void} act @param {Pending} pending @param {Waiting} waiting */
  const waitFor = (act, pending, waiting) => {
    due = act;
    const since = store.get().computing?.since ?? performance.now();
    store.update({ computing: { ...waiting, since, share: pending.share } });
    pending.arrival.then(() => {
      if (due !== act) return;
      attempt(act, waiting);
      if (due === null) refitBox();
    });
  };

  /**
   * Whatever is wrong is said, and the last good state stays. What takes long is done as soon as it can be.
   * @param {() => void} act It asks the core before it changes anything. @param {Waiting} [waiting]
   */
  const attempt = (act, waiting = { what: 'begin' }) => {
    try {
      act();
      if (due === act) forget();
    } catch (error) {
      if (isLost(error)) throw error;
      if (error instanceof Pending) return waitFor(act, error, waiting);
      if (due === act) forget();
      store.update({ message: messageOf(error), evolving: false, catchingUp: null });
    }
  };

  /** Resolves once nothing is waited for. @returns {Promise<void>} */
  const whenIdle = () =>
    due === null
      ? Promise.resolve()
      : new Promise((resolve) => {
          idlers.push(() => resolve());
        });

  return { attempt, forget, whenIdle };
}

/** An experiment begins, or is refused. @param {Means} means @param {ReturnType<typeof createWaiting>} waiting */
function createBeginning({ engine, store }, { attempt, forget, whenIdle }) {
  /** Of an experiment that is to begin. @param {Experiment} experiment @param {Partial<State>} [patch] @returns {Next} */
  const nextOf = (experiment, patch = {}) => {
    const before = asked(store.get());
    const { preset = before.preset, dragging = before.dragging } = patch;
    const { versions = afterChange(before, { experiment, preset }) } = patch;
    return { experiment, preset, versions, dragging };
  };

  /** Throws when the core refuses the experiment. @param {Next} next @param {Restart} restart @param {Partial<State>} [patch] */
  const tryToBegin = ({ reached: _, ...next }, restart, patch) => {
    const { statistics, population } = engine.begin(next.experiment);
    forget();
    const before = store.get();
    store.update({
      history: [statistics],
      generation: 0,
      population,
      restart,
      catchingUp: null,
      // Nobody may have pressed Run for it.
      ...(before.catchingUp && { evolving: before.evolving && before.catchingUp.goesOn === true }),
      message: '',
      settings: { ...before.settings, error: null },
      work: afterWork(before, next.experiment),
      ...patch,
      ...next,
    });
  };

  /** @param {Experiment} experiment @param {Restart} restart @param {Partial<State>} [patch] */
  const begin = (experiment, restart, patch) => {
    const next = nextOf(experiment, patch);
    attempt(() => tryToBegin(next, restart, patch), { what: 'begin', next });
  };

  /** Now, or once the experiment that is asked for has begun, if it does. @param {() => void} act */
  const onceBegun = (act) => {
    const { computing, history: before } = store.get();
    if (!computing?.next) return act();
    const { experiment } = computing.next;
    whenIdle().then(() => {
      const { experiment: begun, history } = store.get();
      if (begun === experiment && history[0] !== before[0]) act();
    });
  };

  return { nextOf, tryToBegin, begin, onceBegun };
}

/** Robots drive again, and the box is around all that must be seen. @param {Means} means */
function createSight({ engine, store, paper, isStill }) {
  /** The robots drive from the start, or stand at the end. */
  const shown = () => (isStill() ? atEnd : fromStart);

  /** A robot at rest at its end shows what is new by driving again; one that was paused on the way stays there. */
  const driveAgain = () => {
    const { driver, handGains, work } = store.get();
    const tried = String(handGains);
    if (driver === 'hand' && tried !== work.tried)
      store.update({ work: { ...work, tries: work.tries + 1, tried } });
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

  /** The box becomes another, once it is known what must be seen. @param {() => State['box']} boxOf */
  const setBox = (boxOf) => {
    const { experiment } = store.get();
    // What cannot be driven is told where it should be seen.
    whenThere(
      orSay(
        () => store.update({ box: boxOf() }),
        () => {},
      ),
      () => store.get().experiment === experiment,
    );
  };

  const refitBox = () => setBox(() => refit(store.get().box, store.get().size, inSight()));

  /** The box is made anew, with what else should be seen. @param {() => Posture[]} [more] */
  const newBox = (more = () => []) => setBox(() => boxAround([...inSight(), ...more()]));

  const settle = () => {
    refitBox();
    driveAgain();
  };

  return { shown, driveAgain, drivenRun, refitBox, newBox, settle };
}

/** The drives of an evolution that is given up were made all the same, and a try was from as many starts as there were then. @param {State} state @param {Experiment} next @returns {State['work']} */
function afterWork({ work, history, experiment }, next) {
  const fewer = experiment.starts.length - next.starts.length;
  return { ...work, spent: work.spent + evolvedOf({ history, work }) + work.tries * fewer, counted: 0 };
}
