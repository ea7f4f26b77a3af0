// The one state of a run: plain values, of which everything on screen is a function.
/** @import { Experiment, Individual, Posture, Preset, Statistics, Triple } from '../core/engine.js' */
/** @import { Box } from '../kit/transform.js' */
/** @import { Places } from './actions/basis.js' */
/** @import { Exercise, MakerState } from './exercise.js' */
/** @import { Until } from './pace.js' */
/** @import { Driven, Pins } from './pins.js' */
/** @import { Reached, Versions } from './undo.js' */
/** @import { Student } from './variant.js' */

/** @typedef {'evolved' | 'hand' | 'paper-ep' | 'paper-arbitrary'} Driver Whose gains drive the robot in ink. */
/** @typedef {typeof finds[number]} Found */
/** @typedef {'begin' | 'moved' | 'limits' | 'seed' | 'setting' | 'undone' | 'redone' | 'given' | 'reset'} Restart Why evolution is at generation 0. */
/** @typedef {Experiment['disturbance']} Disturbance */
/** @typedef {{ start: Posture | null, disturbance: Disturbance | null }} Trial What a drive meets that evolution did not. */
/** What an experiment that begins makes of the state, to which what is changed meanwhile is added; `reached`: where one goes back to it. @typedef {Pick<State, 'experiment' | 'preset' | 'versions' | 'dragging'> & { reached?: Reached }} Next */
/** What a worker computes: an experiment that begins, the next generation, or a recorded one. Since when, in milliseconds, and how much of it is done, if that is known. `next`: where a setting was changed; what a link opens is not changed before it is there, and a change takes its place. `generation`: the recorded one. @typedef {{ what: 'begin' | 'generation' | 'recorded', since: number, share: () => number | null, next?: Next, generation?: number }} Computing */
/** What was done: gains that were tried by hand, one after the other, and drives of evolutions that were given up, or made before. `since`: when the link was opened, in milliseconds; `begun`: when the work began, which may be before; `opened`: the generation that the link shows; `counted`: up to where evolution counts although it may not have come so far again. @typedef {{ tries: number, tried: string, spent: number, since: number, begun: number, opened: number, counted: number }} Work */
/** @typedef {{ time: number, held: number, playing: boolean }} RobotClock Seconds of the model; seconds waited at the end of a loop. */

/**
 * @typedef {object} State
 * @property {string} page Which part of the page is open.
 * @property {number} lesson The step of the lesson that is open beside it; 0: none.
 * @property {number} lastStep The one that was open last.
 * @property {Preset} preset
 * @property {Experiment} experiment
 * @property {Statistics[]} history One entry a generation, the newest last.
 * @property {number} generation The one that is shown.
 * @property {Individual[]} population What that generation left, best first.
 * @property {boolean} evolving
 * @property {{ newest: number, generation: number, goesOn?: boolean } | null} catchingUp A run that was kept is made again up to its newest generation; then the other one is shown, or it evolves on.
 * @property {Computing | null} computing What the run waits for.
 * @property {number} pace Generations a second; Infinity: as fast as the machine goes; or one phase at a time.
 * @property {Until} until
 * @property {string} untilError
 * @property {Restart} restart
 * @property {Driver} driver
 * @property {Triple | null} handGains
 * @property {Found} found Where those are from.
 * @property {readonly [string, string, string]} gainErrors
 * @property {Trial} trial
 * @property {Disturbance} tried The disturbance that is tried wherever one is.
 * @property {Pins} pins
 * @property {Driven | null} unpinned The run for which there was no room among the pins.
 * @property {{ open: boolean, error: { path: string, text: string } | null }} settings
 * @property {Exercise} exercise What the link asks for, and what it locks and hides.
 * @property {number} refusals Counts what was asked for though it is locked.
 * @property {Student} student
 * @property {Work} work
 * @property {MakerState} maker
 * @property {Versions} versions What the experiment was, and what was undone.
 * @property {RobotClock} robot
 * @property {number} speed
 * @property {boolean} dragging A posture or a setting is held.
 * @property {Box} box The part of the plane that must be seen.
 * @property {{ width: number, height: number }} size Of the plane, in pixels.
 * @property {number} theme Counts the changes of theme.
 * @property {string} message
 * @property {Readonly<Record<string, unknown>>} slices What each part of the page keeps for itself, by its name.
 */

/** How gains by hand can be found: with the sliders, on the landscape, in Training, in Luck. */
export const finds = /** @type {const} */ (['hand', 'map', 'training', 'luck']);

/** @type {readonly Driver[]} */
export const drivers = ['evolved', 'hand', 'paper-ep', 'paper-arbitrary'];

/** @type {readonly Preset[]} */
export const presets = ['velocity-limits', 'acceleration-limits'];

/** @type {Trial} */
export const noTrial = Object.freeze({ start: null, disturbance: null });

/** What a part that is opened tries. @param {Pick<Places, 'triesStarts' | 'triesDisturbance'>} places @param {string} page @param {Posture | null} start @param {Disturbance} tried @returns {Trial} */
export function trialIn({ triesStarts, triesDisturbance }, page, start, tried) {
  if (triesDisturbance(page)) return { start, disturbance: tried };
  return start && triesStarts(page) ? { start, disturbance: null } : noTrial;
}

/** Outside of the lesson, of a run in which nothing has been done yet. @type {Readonly<Pick<State, 'lesson' | 'generation' | 'driver' | 'handGains' | 'found' | 'trial'>>} */
export const nothingDone = Object.freeze({
  lesson: 0,
  generation: 0,
  driver: 'evolved',
  handGains: null,
  found: 'hand',
  trial: noTrial,
});

/** @param {string} tried Gains that need no try. @param {number} [opened] @param {number} [spent] Drives that were made before. @returns {Work} */
export function newWork(tried, opened = 0, spent = 0) {
  const since = performance.now();
  return { tries: 0, tried, spent, since, begun: since, opened, counted: opened };
}

/** How many times evolution has driven by a generation. Those that are not yet made again count as many as the others did, which most methods do. The first is driven for whoever looks, and counts when there are more. @param {State['history']} history @param {number} generation */
function drivenBy(history, generation) {
  if (generation === 0 || history.length === 0) return 0;
  const known = history[Math.min(generation, history.length - 1)].evaluations;
  const missing = Math.max(0, generation + 1 - history.length);
  return known + Math.round((missing * known) / history.length);
}

/** How many times evolution has driven for this run. @param {Pick<State, 'history' | 'work'>} state */
export const evolvedOf = ({ history, work }) => drivenBy(history, Math.max(history.length - 1, work.counted));

/** How many times a robot was driven for this answer, once from each start: what evolution drove up to the generation that is shown, or all that was driven here. @param {Pick<State, 'driver' | 'history' | 'generation' | 'work' | 'experiment'>} state */
export function drivesOf({ driver, history, generation, work, experiment }) {
  if (driver === 'evolved') return history[generation].evaluations;
  return work.tries * experiment.starts.length + work.spent + evolvedOf({ history, work });
}

/** Of all that was driven here, what is not driven again when the generation that is shown, which another run may have, is made again. @param {Pick<State, 'history' | 'generation' | 'work' | 'experiment'>} state */
export const spentOf = ({ history, generation, ...state }) =>
  drivesOf({ ...state, history, generation, driver: 'hand' }) - drivenBy(history, generation);

/** The state as it has been asked for, of which an experiment may still be on its way: what controls show, and change further. @param {State} state @returns {State} */
export const asked = (state) => ({ ...state, ...state.computing?.next });

/** A run that still catches up with what opened it, as that has it. @param {State} state @returns {State} */
export const caughtUp = (state) =>
  state.catchingUp ? { ...state, generation: state.catchingUp.generation } : state;

/** Start and goal of what drives. @param {State} state */
export const endsOf = ({ experiment, trial }) => ({
  start: trial.start ?? experiment.starts[0],
  goal: experiment.goal,
});
