// The one state of the page, and what follows from it.

import { remember } from '../kit/memo.js';

/** @typedef {import('../core/engine.js').Experiment} Experiment */
/** @typedef {import('../core/engine.js').Individual} Individual */
/** @typedef {import('../core/engine.js').PaperResult} PaperResult */
/** @typedef {import('../core/engine.js').Posture} Posture */
/** @typedef {import('../core/engine.js').Preset} Preset */
/** @typedef {import('../core/engine.js').Run} Run */
/** @typedef {import('../core/engine.js').Statistics} Statistics */
/** @typedef {import('../kit/transform.js').Box} Box */
/** @typedef {import('../parts/landscape/request.js').LandscapeState} LandscapeState */
/** @typedef {import('./pins.js').Driven} Driven */

/** @typedef {'evolved' | 'hand' | 'paper-ep' | 'paper-arbitrary'} Driver Whose gains drive the robot in ink. */
/** @typedef {typeof finds[number]} Found */
/** @typedef {'begin' | 'moved' | 'limits' | 'seed' | 'setting' | 'undone' | 'redone' | 'reset'} Restart Why evolution is at generation 0. */
/** @typedef {import('../core/engine.js').Triple} Triple */
/** @typedef {typeof pageNames[number]} PageName */
/** @typedef {{ start: Posture | null, disturbance: Experiment['disturbance'] | null }} Trial What a drive meets that evolution did not. */
/** @typedef {{ time: number, held: number, playing: boolean }} RobotClock Seconds of the model; seconds waited at the end of a loop. */

/**
 * @typedef {object} State
 * @property {PageName} page Which part of the page is open.
 * @property {number} lesson The step of the lesson that is open beside it; 0: none.
 * @property {number} lastStep The one that was open last.
 * @property {import('../lesson/page.js').Progress} progress What was done in the lesson.
 * @property {Preset} preset
 * @property {Experiment} experiment
 * @property {Statistics[]} history One entry a generation, the newest last.
 * @property {number} generation The one that is shown.
 * @property {Individual[]} population What that generation left, best first.
 * @property {boolean} evolving
 * @property {{ newest: number, generation: number } | null} catchingUp A run that was kept is made again up to its newest generation; then the other one is shown.
 * @property {number} pace Generations a second; Infinity: as fast as the machine goes; or one phase at a time.
 * @property {Until} until
 * @property {string} untilError
 * @property {Restart} restart
 * @property {Driver} driver
 * @property {Triple | null} handGains
 * @property {Found} found Where those are from.
 * @property {Trial} trial
 * @property {LandscapeState} landscape
 * @property {import('../parts/generation/record.js').GenerationState} anatomy
 * @property {import('../parts/curves/page.js').CurvesState} curves
 * @property {import('./pins.js').Pins} pins
 * @property {import('../parts/robustness/page.js').RobustnessState} robustness
 * @property {import('../parts/training/request.js').TrainingState} training
 * @property {import('../parts/disturbance/request.js').DisturbanceState} disturbance
 * @property {import('../parts/luck/request.js').LuckState} luck
 * @property {import('../settings/panel.js').SettingsState} settings
 * @property {import('./exercise.js').Exercise} exercise What the link asks for, and what it locks and hides.
 * @property {import('./exercise.js').MakerState} maker
 * @property {import('./undo.js').Versions} versions What the experiment was, and what was undone.
 * @property {RobotClock} robot
 * @property {number} speed
 * @property {boolean} dragging A posture or a setting is held.
 * @property {Box} box The part of the plane that must be seen.
 * @property {{ width: number, height: number }} size Of the plane, in pixels.
 * @property {number} theme Counts the changes of theme.
 * @property {string} message
 * @property {readonly [string, string, string]} gainErrors
 */

/** @typedef {(experiment: Experiment, gains: readonly Triple[]) => Run[]} Drive */

/**
 * @typedef {object} Scene
 * @property {Experiment} experiment In which it drives: with what is tried.
 * @property {Triple} gains With which it drives.
 * @property {Run} driving
 * @property {Run[]} others The rest of the population or the best of it, when the evolved best drives.
 * @property {Run} comparison
 * @property {Driver} comparisonDriver
 * @property {Driven} compared What the comparison follows from.
 * @property {boolean} withoutDisturbance The comparison is the driver itself, without the disturbance that is tried.
 * @property {Run} paperEp The gains that evolution found in the paper.
 * @property {Run[]} pins One for each pin.
 * @property {import('../parts/generation/record.js').ChosenDrives | null} chosen Whose drive it is, if it is an individual of the shown generation.
 */

export const pageNames = /** @type {const} */ ([
  'lab',
  'generation',
  'curves',
  'landscape',
  'robustness',
  'training',
  'disturbance',
  'luck',
]);

/** How gains by hand can be found: with the sliders, on the landscape, in Training, in Luck. */
export const finds = /** @type {const} */ (['hand', 'map', 'training', 'luck']);

/** @type {Trial} */
export const noTrial = Object.freeze({ start: null, disturbance: null });

/** Where evolution pauses by itself. By default at every so many generations, so that a forgotten page comes to rest. @typedef {{ kind: 'every' | 'generation' | 'cost', value: number }} Until */

export const generationsPerRun = 100;
/** The pace at which each phase of a generation is shown. */
export const phaseByPhase = 0;
export const paces = [phaseByPhase, 1, 8, 60, Number.POSITIVE_INFINITY];

/** Whether evolution runs as a play of phases. @param {State} state */
export const playsPhases = ({ evolving, catchingUp, pace }) =>
  evolving && !catchingUp && pace === phaseByPhase;

/** Whether evolution is to pause at this generation. @param {Until} until @param {Statistics} statistics */
export const pausesAt = ({ kind, value }, { generation, best }) =>
  kind === 'cost'
    ? best.cost < value
    : kind === 'generation'
      ? generation === value
      : generation % generationsPerRun === 0;

const holdSeconds = 0.8;
/** Most samples of all others together: more would be slow to draw and fill the memory. */
const mostSamples = 400_000;
const mostOthers = 100;

/** @param {State} initial @param {() => void} onChange */
export function createStore(initial, onChange) {
  let state = initial;
  return {
    get: () => state,
    /** @param {Partial<State>} patch */
    update(patch) {
      state = { ...state, ...patch };
      onChange();
    },
  };
}

/** @typedef {ReturnType<typeof createStore>} Store */

/**
 * The gains that someone drives with.
 * @param {State} state @param {Driver} driver @param {PaperResult[]} paper
 * @returns {Triple}
 */
export function gainsOf(state, driver, paper) {
  if (driver === 'evolved') return state.population[0].gains;
  if (driver === 'hand' && state.handGains) return state.handGains;
  const method = driver === 'paper-arbitrary' ? 'arbitrary' : 'ep';
  const row = paper.find((one) => one.preset === state.preset && one.method === method);
  if (!row) throw new Error(`paper: no ${method} gains for ${state.preset}`);
  return row.gains;
}

/** Whom a driver is compared with: paper's choices with evolution, evolution with the paper. @param {Driver} driver @returns {Driver} */
const rivalOf = (driver) =>
  driver === 'hand' || driver === 'paper-arbitrary' ? 'evolved' : 'paper-arbitrary';

/**
 * The drives of all but the best. Those who survived a generation are not driven again.
 * @param {Drive} drive
 */
function createOthers(drive) {
  /** @type {Map<string, Run>} */
  let known = new Map();
  /** @type {Experiment | null} */
  let knownExperiment = null;
  return remember((/** @type {Experiment} */ experiment, /** @type {Individual[]} */ population) => {
    /** @type {Map<string, Run>} */
    const before = experiment === knownExperiment ? known : new Map();
    const drawn =
      1 + Math.min(mostOthers, Math.floor((mostSamples * experiment.sampleTime) / experiment.horizon));
    const gains = population.slice(0, drawn).map((individual) => individual.gains);
    const newborn = gains.filter((triple) => !before.has(String(triple)));
    const driven = drive(experiment, newborn);
    for (const [i, triple] of newborn.entries()) before.set(String(triple), driven[i]);
    const runs = gains.map((triple) => /** @type {Run} */ (before.get(String(triple))));
    known = new Map(gains.map((triple, i) => [String(triple), runs[i]]));
    knownExperiment = experiment;
    return runs.slice(1);
  });
}

/** Start and goal of what drives. @param {State} state */
export const endsOf = ({ experiment, trial }) => ({
  start: trial.start ?? experiment.starts[0],
  goal: experiment.goal,
});

/** @param {Experiment} experiment @param {Trial} trial @returns {Experiment} */
const tried = (experiment, trial) =>
  trial === noTrial
    ? experiment
    : {
        ...experiment,
        starts: trial.start ? [trial.start] : experiment.starts,
        ...(trial.disturbance && withDisturbance(trial.disturbance)),
      };

/** A disturbed robot drives on at the goal, so that one sees how near it stays. @param {Experiment['disturbance']} disturbance */
export const withDisturbance = (disturbance) => ({ disturbance, tolerance: { position: 0, heading: 0 } });

/** @param {Experiment} experiment @returns {Experiment} */
export const undisturbed = (experiment) => ({
  ...experiment,
  disturbance: { ...experiment.disturbance, kind: 'none' },
});

/**
 * Everything that drives, as a pure function of the state.
 * @param {Drive} drive @param {PaperResult[]} paper @param {(state: State) => Scene['chosen']} chosenDrives
 * @returns {(state: State) => Scene}
 */
export function createScene(drive, paper, chosenDrives) {
  const driveOne = () =>
    remember((/** @type {Experiment} */ e, /** @type {Triple} */ gains) => drive(e, [gains])[0]);
  const driving = driveOne();
  const comparison = driveOne();
  const paperEp = driveOne();
  const others = createOthers(drive);
  const pinned = remember((/** @type {State['pins']} */ pins) =>
    pins.map(({ experiment, gains }) => drive(experiment, [gains])[0]),
  );
  const triedOf = remember(tried);
  const undisturbedOf = remember(undisturbed);
  /** @type {Run[]} */
  const none = [];
  return (state) => {
    const { population, driver, trial } = state;
    const experiment = triedOf(state.experiment, trial);
    const withoutDisturbance = trial.disturbance !== null && trial.disturbance.kind !== 'none';
    const comparisonDriver = withoutDisturbance ? driver : rivalOf(driver);
    const comparisonExperiment = withoutDisturbance ? undisturbedOf(experiment) : experiment;
    const chosen = chosenDrives(state);
    const company = chosen?.population ?? (driver === 'evolved' && trial === noTrial ? population : null);
    const gains = chosen?.population[0].gains ?? gainsOf(state, driver, paper);
    const rival = chosen?.partner?.gains ?? gainsOf(state, comparisonDriver, paper);
    return {
      experiment,
      gains,
      driving: driving(experiment, gains),
      others: company ? others(experiment, company) : none,
      comparison: comparison(comparisonExperiment, rival),
      comparisonDriver,
      compared: { experiment: comparisonExperiment, gains: rival },
      chosen,
      withoutDisturbance,
      paperEp: paperEp(experiment, gainsOf(state, 'paper-ep', paper)),
      pins: pinned(state.pins),
    };
  };
}

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
