// What the controls do: each takes the page from one good state to the next, or leaves it and says why.
import { firstDisturbance } from './disturbance/page.js';
import { firstLandscape } from './landscape/request.js';
import { firstLuck } from './luck/page.js';
import { messageOf } from './messages.js';
import { atEnd, endsOf, fromStart, gainsOf, generationsPerRun, noTrial } from './state.js';
import { firstRobustness } from './robustness/page.js';
import { firstTraining } from './training/page.js';
import { boxAround, refit } from './view.js';
import * as strings from './words/en/lab.js';

/** @typedef {import('./engine.js').Engine} Engine */
/** @typedef {import('./engine.js').Experiment} Experiment */
/** @typedef {import('./engine.js').PaperResult} PaperResult */
/** @typedef {import('./engine.js').Posture} Posture */
/** @typedef {import('./engine.js').Preset} Preset */
/** @typedef {import('./state.js').Driver} Driver */
/** @typedef {import('./state.js').PageName} PageName */
/** @typedef {import('./state.js').Restart} Restart */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./state.js').Store} Store */
/** @typedef {import('./state.js').Triple} Triple */
/** @typedef {import('./handles.js').End} End */
/** @typedef {ReturnType<typeof createActions>} Actions */

const noErrors = /** @type {const} */ (['', '', '']);
const stillPlease = matchMedia('(prefers-reduced-motion: reduce)');

/** The robots drive from the start, or stand at the end for who wants no motion. */
const shown = () => (stillPlease.matches ? atEnd : fromStart);

/** Whether a start is tried there, and not given to evolution. @param {PageName} page */
const triesStarts = (page) => ['robustness', 'training', 'disturbance'].includes(page);

/** @param {Posture} a @param {Posture} b */
const isSame = (a, b) => a.x === b.x && a.y === b.y && a.theta === b.theta;

/** The first state. @param {Engine} engine @param {Preset} preset @returns {State} */
export function firstState(engine, preset) {
  const experiment = engine.experiment(preset);
  const { statistics, population } = engine.begin(experiment);
  return {
    page: 'lab',
    preset,
    experiment,
    history: [statistics],
    population,
    evolving: false,
    restart: 'begin',
    driver: 'evolved',
    handGains: null,
    trial: noTrial,
    landscape: firstLandscape,
    robustness: firstRobustness,
    training: firstTraining,
    disturbance: firstDisturbance,
    luck: firstLuck,
    robot: shown(),
    speed: 1,
    dragging: false,
    box: boxAround([experiment.starts[0], experiment.goal]),
    size: { width: 0, height: 0 },
    theme: 0,
    message: '',
    gainErrors: noErrors,
  };
}

/** @param {Engine} engine @param {Store} store @param {PaperResult[]} paper @param {() => number} finalTime Of the robot in ink. */
export function createActions(engine, store, paper, finalTime) {
  /** @param {() => void} act */
  const attempt = (act) => {
    try {
      act();
    } catch (error) {
      store.update({ message: messageOf(error), evolving: false });
    }
  };

  /** @param {Experiment} experiment @param {Restart} restart @param {Partial<State>} [patch] */
  const begin = (experiment, restart, patch = {}) =>
    attempt(() => {
      const { statistics, population } = engine.begin(experiment);
      store.update({ experiment, history: [statistics], population, restart, message: '', ...patch });
    });

  /** A robot at rest at its end shows what is new by driving again; one that was paused on the way stays there. */
  const driveAgain = () => {
    if (store.get().robot.time === atEnd.time) store.update({ robot: shown() });
  };

  const refitBox = () => {
    const { box, size } = store.get();
    store.update({ box: refit(box, size, Object.values(endsOf(store.get()))) });
  };

  /** @param {readonly number[]} gains */
  const driveByHand = (gains) => {
    const handGains = /** @type {Triple} */ (gains);
    engine.drive(store.get().experiment, [handGains]);
    store.update({ handGains, driver: 'hand', gainErrors: noErrors, message: '' });
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

  const step = () =>
    attempt(() => {
      const { statistics, population } = engine.step();
      store.update({ history: [...store.get().history, statistics], population, message: '' });
    });

  return {
    /** Some generations more; the run pauses by itself at a round number. @param {number} generations */
    evolve(generations) {
      for (let i = 0; i < generations && store.get().evolving; i += 1) {
        step();
        if ((store.get().history.length - 1) % generationsPerRun === 0) store.update({ evolving: false });
      }
    },

    toggleEvolution() {
      const evolving = !store.get().evolving;
      store.update({ evolving });
      if (evolving && !stillPlease.matches)
        store.update({
          robot: store.get().robot.time === atEnd.time ? fromStart : { ...store.get().robot, playing: true },
        });
    },

    oneGeneration() {
      store.update({ evolving: false });
      step();
      driveAgain();
    },

    reset() {
      begin(store.get().experiment, 'reset', { evolving: false, robot: shown() });
    },

    newSeed() {
      attempt(() => {
        const { experiment } = store.get();
        const next = engine.experiment({
          ...experiment,
          evolution: { ...experiment.evolution, seed: engine.randomSeed() },
        });
        begin(next, 'seed', { evolving: false, robot: shown() });
      });
    },

    /** Other limits; start, goal and seed stay, so that only the limits differ. @param {Preset} preset */
    choosePreset(preset) {
      attempt(() => {
        const next = engine.experiment({
          ...store.get().experiment,
          limits: engine.experiment(preset).limits,
        });
        begin(next, 'limits', { preset, evolving: false, robot: shown() });
      });
    },

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

    /** Drives by hand with all three gains. @param {Triple} gains */
    driveGains(gains) {
      attempt(() => driveByHand(gains));
    },

    driveAgain,

    /** @param {number} index @param {string} text */
    typeGain(index, text) {
      const value = strings.numberOf(text);
      const { name } = strings.gains[index];
      if (!Number.isFinite(value)) return refuseGain(index, strings.notANumber(name, text));
      try {
        driveByHand(withGain(index, value));
        driveAgain();
      } catch (error) {
        refuseGain(index, strings.gainRefused(name, messageOf(error)));
      }
    },

    /** @param {End} end */
    postureOf: (end) => endsOf(store.get())[end],

    /** @param {End} end @param {Posture} posture @param {boolean} dragging */
    movePosture(end, posture, dragging) {
      const { experiment, trial, page } = store.get();
      if (isSame(endsOf(store.get())[end], posture)) return;
      if (end === 'start' && triesStarts(page)) {
        store.update({ trial: { ...trial, start: posture }, dragging });
        if (!dragging) refitBox();
        return;
      }
      const next =
        end === 'goal'
          ? { ...experiment, goal: posture }
          : { ...experiment, starts: [posture, ...experiment.starts.slice(1)] };
      begin(next, 'moved', { dragging });
      if (!dragging) refitBox();
    },

    releasePosture() {
      store.update({ dragging: false });
      refitBox();
      driveAgain();
    },

    /** Start and goal of the paper. */
    restorePostures() {
      const { experiment, preset, trial } = store.get();
      if (trial.start) return this.tryStart(null);
      const { starts, goal } = engine.experiment(preset);
      begin({ ...experiment, starts, goal }, 'moved');
      store.update({ box: boxAround([starts[0], goal]), robot: shown() });
    },

    /** Drives from a start that evolution does not see, or again from its own. @param {Posture | null} start */
    tryStart(start) {
      const { trial } = store.get();
      store.update({
        trial: start || trial.disturbance ? { ...trial, start } : noTrial,
        robot: shown(),
      });
      refitBox();
    },

    /** @param {PageName} page */
    openPage(page) {
      if (page === store.get().page) return;
      const tried = store.get().trial !== noTrial;
      store.update({ page, trial: noTrial });
      if (tried) refitBox();
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

    /** @param {number} time */
    scrub(time) {
      store.update({ robot: time >= finalTime() ? atEnd : { time, held: 0, playing: false } });
    },
  };
}
