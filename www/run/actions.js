// What the controls do: each takes the page from one good state to the next, or leaves it and says why.
import { firstCurves } from '../parts/curves/page.js';
import { firstDisturbance } from '../parts/disturbance/request.js';
import { standsStill } from '../kit/host.js';
import { firstMaker, noExercise, wayOf } from './exercise.js';
import { firstGeneration } from '../parts/generation/record.js';
import { firstLandscape } from '../parts/landscape/request.js';
import { noTally } from '../lesson/tally.js';
import { firstLuck } from '../parts/luck/request.js';
import { isLost, messageOf } from '../words/errors.js';
import { atEnd, endsOf, fromStart, gainsOf, noTrial, pausesAt, playsPhases } from './state.js';
import { noPins } from './pins.js';
import { firstRobustness } from '../parts/robustness/page.js';
import { isTracking, stationsOf } from '../core/reference.js';
import { firstSettings } from '../settings/panel.js';
import { valueAt, withValue } from './paths.js';
import { firstTraining } from '../parts/training/request.js';
import { afterChange, afterDrag, noVersions, redone, undone } from './undo.js';
import { boxAround, refit } from '../kit/transform.js';
import { lab as strings, settings as settingWords } from '../words/index.js';

/** @typedef {import('../core/engine.js').Engine} Engine */
/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../core/engine.js').PaperResult} PaperResult */
/** @typedef {import('../core/engine.js').Posture} Posture */
/** @typedef {import('../core/engine.js').Preset} Preset */
/** @typedef {import('./state.js').Driver} Driver */
/** @typedef {import('./state.js').PageName} PageName */
/** @typedef {import('./state.js').Restart} Restart */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./state.js').Store} Store */
/** @typedef {import('./state.js').Triple} Triple */
/** @typedef {import('./state.js').Until} Until */
/** @typedef {import('../lab/handles.js').End} End */
/** @typedef {import('../link/link.js').Opened} Opened */
/** @typedef {ReturnType<typeof createActions>} Actions */

const noErrors = /** @type {const} */ (['', '', '']);
const stillPlease = matchMedia('(prefers-reduced-motion: reduce)');

/** The robots drive from the start, or stand at the end for who wants no motion, or none yet. */
const shown = () => (stillPlease.matches || standsStill() ? atEnd : fromStart);

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
    lesson: 0,
    lastStep: 1,
    progress: { answers: {}, tally: noTally, duel: null },
    preset,
    experiment,
    history: [statistics],
    generation: 0,
    population,
    evolving: false,
    catchingUp: null,
    pace: 8,
    until: { kind: 'every', value: 100 },
    untilError: '',
    restart: 'begin',
    driver: 'evolved',
    handGains: null,
    found: 'hand',
    trial: noTrial,
    landscape: firstLandscape,
    anatomy: firstGeneration,
    curves: firstCurves,
    pins: noPins,
    robustness: firstRobustness,
    training: firstTraining,
    disturbance: firstDisturbance,
    luck: firstLuck,
    settings: firstSettings,
    exercise: noExercise,
    maker: firstMaker,
    versions: noVersions,
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

  /** A robot at rest at its end shows what is new by driving again; one that was paused on the way stays there. */
  const driveAgain = () => {
    if (store.get().robot.time === atEnd.time) store.update({ robot: shown() });
  };

  /** @param {number} seed */
  const useSeed = (seed) =>
    attempt(() => {
      const { experiment } = store.get();
      const next = engine.experiment({ ...experiment, evolution: { ...experiment.evolution, seed } });
      begin(next, 'seed', { evolving: false, robot: shown() });
    });

  const refitBox = () => {
    const { box, size } = store.get();
    store.update({ box: refit(box, size, inSight()) });
  };

  /** What must be seen: start and goal, and where the reference comes by. */
  const inSight = () => {
    const state = store.get();
    const ends = Object.values(endsOf(state));
    const [run] = engine.drive(state.experiment, [gainsOf(state, state.driver, paper)]);
    return isTracking(run) ? [...ends, ...stationsOf(run)] : ends;
  };

  /** Where the robot in ink comes to rest, if that is not far away. */
  const nearEnd = () => {
    const state = store.get();
    const [run] = engine.drive(state.experiment, [gainsOf(state, state.driver, paper)]);
    const last = run.time.length - 1;
    const end = { x: run.x[last], y: run.y[last], theta: run.theta[last] };
    const { start, goal } = endsOf(state);
    const away = Math.hypot(end.x - goal.x, end.y - goal.y);
    return away < Math.hypot(start.x - goal.x, start.y - goal.y) ? [end] : [];
  };

  const settle = () => {
    refitBox();
    driveAgain();
  };

  /** A posture or a setting is let go. */
  const release = () => {
    store.update({ dragging: false, versions: afterDrag(store.get()) });
    settle();
  };

  /** @param {Restart} restart @param {ReturnType<typeof undone>} step */
  const goTo = (restart, step) => {
    if (!step || store.get().dragging) return;
    const { preset, experiment } = step.version;
    begin(experiment, restart, { preset, versions: step.versions });
    settle();
  };

  /** @param {string} path @param {string} text */
  const refuseSetting = (path, text) =>
    store.update({ settings: { ...store.get().settings, error: { path, text } } });

  /** @param {readonly number[]} gains @param {State['found']} [found] */
  const driveByHand = (gains, found = 'hand') => {
    const handGains = /** @type {Triple} */ (gains);
    engine.drive(store.get().experiment, [handGains]);
    store.update({ handGains, found, driver: 'hand', gainErrors: noErrors, message: '' });
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

  /** One generation on: the next that is recorded, or a new one. @param {State['history']} [known] A copy of the history, which takes the new one: whoever goes on and on makes only one, for it may be long. */
  const forward = (known = [...store.get().history]) =>
    attempt(() => {
      const generation = store.get().generation + 1;
      if (generation === known.length) known.push(engine.step());
      store.update({ history: known, generation, population: engine.population(generation), message: '' });
    });

  /** Evolves as far as a run has come: at once if that is soon done, else while the page looks on. @param {number} newest @param {number} generation The one that is shown then. */
  const catchUp = (newest, generation) => {
    const end = performance.now() + 300;
    const known = [...store.get().history];
    while (store.get().generation < newest && performance.now() < end) forward(known);
    if (store.get().generation < newest) store.update({ evolving: true, catchingUp: { newest, generation } });
    else showGeneration(generation);
  };

  /** Another generation that is recorded. @param {number} generation */
  const showGeneration = (generation) =>
    attempt(() =>
      store.update({ evolving: false, generation, population: engine.population(generation), message: '' }),
    );

  /** Drives from a start that evolution does not see, or again from its own. @param {Posture | null} start */
  const tryStart = (start) => {
    const { trial } = store.get();
    store.update({
      trial: start || trial.disturbance ? { ...trial, start } : noTrial,
      robot: shown(),
    });
    refitBox();
  };

  /** @param {PageName} page */
  const openPage = (page) => {
    const { page: before, trial, disturbance } = store.get();
    if (page === before) return;
    if (page === 'disturbance')
      store.update({ page, trial: { start: null, disturbance: disturbance.tried }, robot: shown() });
    else store.update({ page, trial: noTrial });
    // Phases that nobody sees need not be played.
    if (page !== 'generation' && playsPhases(store.get())) store.update({ evolving: false });
    if (trial !== noTrial) refitBox();
  };

  /** Where phases are played they are seen, from the first one on. */
  const seePhases = () => {
    if (!playsPhases(store.get()) || store.get().page === 'generation') return;
    store.update({ anatomy: firstGeneration });
    openPage('generation');
  };

  return {
    /** Goes on while `more` says so, or until the run has to pause. @param {() => boolean} more */
    evolve(more) {
      const known = [...store.get().history];
      while (store.get().evolving && more()) {
        forward(known);
        const { until, history, generation, catchingUp } = store.get();
        if (generation === catchingUp?.newest) showGeneration(catchingUp.generation);
        else if (!catchingUp && pausesAt(until, history[generation])) store.update({ evolving: false });
      }
    },

    forward: () => forward(),

    showGeneration,

    oneBack() {
      const { generation } = store.get();
      if (generation > 0) showGeneration(generation - 1);
    },

    /** @param {number} pace */
    setPace(pace) {
      store.update({ pace, catchingUp: null });
      seePhases();
    },

    /** @param {Until['kind']} kind @param {string} text */
    setUntil(kind, text) {
      const value = strings.numberOf(text);
      const wrong = kind === 'every' ? '' : strings.untilRefused(kind, value, text);
      store.update(wrong ? { untilError: wrong } : { until: { kind, value }, untilError: '' });
    },

    toggleEvolution() {
      const evolving = !store.get().evolving;
      store.update({ evolving, catchingUp: null });
      seePhases();
      if (evolving && !stillPlease.matches)
        store.update({
          robot: store.get().robot.time === atEnd.time ? fromStart : { ...store.get().robot, playing: true },
        });
    },

    oneGeneration() {
      store.update({ evolving: false });
      forward();
      driveAgain();
    },

    reset() {
      begin(store.get().experiment, 'reset', { evolving: false, robot: shown() });
    },

    newSeed: () => useSeed(engine.randomSeed()),

    useSeed,

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

    /** Drives by hand with all three gains. @param {Triple} gains @param {State['found']} [found] */
    driveGains(gains, found) {
      attempt(() => driveByHand(gains, found));
    },

    driveAgain,

    /** What the lab shows over the generations. @param {State['curves']['lab']} lab */
    chooseCurve(lab) {
      store.update({ curves: { ...store.get().curves, lab } });
    },

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

    releasePosture: release,

    /** @param {string} path @param {import('./paths.js').Value} value @param {boolean} dragging */
    changeSetting(path, value, dragging) {
      const { experiment, settings } = store.get();
      if (valueAt(experiment, path) === value) {
        if (settings.error) store.update({ settings: { ...settings, error: null } });
        return;
      }
      try {
        tryToBegin(withValue(experiment, path, value), 'setting', { dragging });
        if (!dragging) settle();
      } catch (error) {
        refuseSetting(path, settingWords.named(messageOf(error)));
      }
    },

    releaseSetting: release,

    refuseSetting,

    backToPreset() {
      begin(engine.experiment(store.get().preset), 'setting');
      settle();
    },

    undo() {
      goTo('undone', undone(store.get()));
    },

    redo() {
      goTo('redone', redone(store.get()));
    },

    /** @param {boolean} open */
    openSettings(open) {
      const { maker } = store.get();
      // The two stand in the same place.
      store.update({ settings: { open, error: null }, maker: { ...maker, open: maker.open && !open } });
    },

    /** @param {Partial<State['maker']>} patch */
    makeExercise(patch) {
      const { settings, maker } = store.get();
      store.update({ maker: { ...maker, ...patch }, settings: { ...settings, open: false } });
    },

    /** Start and goal of the paper. */
    restorePostures() {
      const { experiment, preset, trial } = store.get();
      if (trial.start) return tryStart(null);
      const { starts, goal } = engine.experiment(preset);
      begin({ ...experiment, starts, goal }, 'moved');
      store.update({ box: boxAround(inSight()), robot: shown() });
    },

    tryStart,

    /** Drives under a disturbance that evolution does not see. The core throws if it is out of range. @param {Experiment['disturbance']} tried */
    tryDisturbance(tried) {
      const { experiment, trial, disturbance } = store.get();
      engine.experiment({ ...experiment, disturbance: tried });
      store.update({
        trial: { ...trial, disturbance: tried },
        disturbance: { ...disturbance, tried, error: null },
      });
    },

    /**
     * Begins what a link holds, and evolves to its generation or further.
     * @param {Opened} opened @param {readonly string[]} problems @param {number} [newest]
     */
    openLinked({ experiment, generation, view, ...rest }, problems, newest = generation) {
      attempt(() => {
        const { disturbance, landscape, anatomy, curves, robustness, settings } = store.get();
        const { exercise } = rest;
        const tried = rest.trial.disturbance ?? disturbance.tried;
        tryToBegin(experiment, 'begin', {
          ...rest,
          lastStep: rest.lesson || store.get().lastStep,
          trial: rest.page === 'disturbance' ? { ...rest.trial, disturbance: tried } : rest.trial,
          disturbance: { ...disturbance, tried, error: null },
          landscape: { ...landscape, ...view.landscape, cursor: null, thirdError: '' },
          anatomy: { ...anatomy, ...view.anatomy },
          curves: { ...curves, ...view.curves },
          robustness: { ...robustness, ...view.robustness, cursor: null },
          evolving: false,
          robot: shown(),
          // Nothing leads back out of an exercise, and what is locked is not open.
          ...(exercise !== noExercise && { versions: noVersions }),
          settings: { open: settings.open && wayOf(exercise, 'settings') === 'free', error: null },
        });
        store.update({ box: boxAround([...inSight(), ...nearEnd()]) });
        catchUp(newest, generation);
        if (problems.length > 0) store.update({ message: problems.join(' ') });
      });
    },

    /** @param {PageName} page */
    openPage(page) {
      store.update({ lesson: 0 });
      openPage(page);
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
