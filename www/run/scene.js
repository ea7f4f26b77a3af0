// Everything that drives, as a function of the state.
/** @import { Experiment, Individual, PaperResult, Posture, Run, Triple } from '../core/engine.js' */
/** @import { Driven } from './pins.js' */
/** @import { Driver, State, Trial } from './state.js' */
import { Pending, together } from '../core/pending.js';
import { hasMovingReference } from '../core/reference.js';
import { remember } from '../kit/memo.js';
import { isLost } from '../words/errors.js';
import { gainsOf, rivalOf } from './drivers.js';
import { hidesPaper } from './exercise.js';
import { noTrial } from './state.js';

/** @typedef {{ gains: Triple, name: string }} Named */
/**
 * What drives in the place of the population, where a part of the page looks at one of it.
 * @typedef {object} ChosenDrives
 * @property {string} name
 * @property {Individual[]} population The one in ink, then the others.
 * @property {(others: number, arrived: number | null) => string} othersText
 * @property {Named | null} partner Its parent, or its offspring.
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
 * @property {Run | null} paperEp The gains that evolution found in the paper, unless an exercise hides them.
 * @property {Run[]} pins One for each pin.
 * @property {ChosenDrives | null} chosen Whose drive it is, if it is an individual of the shown generation.
 */

/** Most samples of all others together: more would be slow to draw and fill the memory. */
const mostSamples = 400_000;
const mostOthers = 100;

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

/** @param {Experiment} experiment @param {Trial} trial @returns {Experiment} */
export function tried(experiment, trial) {
  if (trial === noTrial) return experiment;
  const starts = trial.start ? [trial.start] : experiment.starts;
  if (!trial.disturbance) return { ...experiment, starts };
  const [first, ...others] = starts;
  return {
    ...experiment,
    starts: [offGoal(experiment, first), ...others],
    ...withDisturbance(trial.disturbance),
  };
}

/**
 * Where a drive begins that is disturbed: exactly at the goal it would have arrived before anything pushes it, so there it is turned
 * by what nobody sees.
 * @param {Pick<Experiment, 'goal' | 'referenceVelocity'>} experiment @param {Posture} start @returns {Posture}
 */
export function offGoal({ goal, referenceVelocity }, start) {
  const isThere =
    start.x === goal.x && start.y === goal.y && Math.abs(Math.sin((start.theta - goal.theta) / 2)) < 1e-10;
  if (!isThere || hasMovingReference({ referenceVelocity })) return start;
  // Towards 0, so that no heading leaves its range.
  return { ...start, theta: start.theta - (start.theta < 0 ? -1e-9 : 1e-9) };
}

/** A disturbed robot drives on at the goal, so that one sees how near it stays. @param {Experiment['disturbance']} disturbance */
export const withDisturbance = (disturbance) => ({
  disturbance,
  tolerance: { position: 0, heading: 0, speed: null, turnRate: null },
});

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
  const driveOne = (/** @type {Experiment} */ experiment, /** @type {Triple} */ gains) =>
    drive(experiment, [gains])[0];
  const driving = remember(driveOne);
  const comparison = remember(driveOne);
  const paperEp = remember(driveOne);
  const others = createOthers(drive);
  const pinned = remember((/** @type {State['pins']} */ pins) =>
    together(pins.map((pin) => () => driveOne(pin.experiment, pin.gains))),
  );
  const triedOf = remember(tried);
  const undisturbedOf = remember(undisturbed);
  /** @type {Run[]} */
  const none = [];
  return (state) => {
    const { population, driver, trial } = state;
    const experiment = triedOf(state.experiment, trial);
    const withoutDisturbance = trial.disturbance !== null && trial.disturbance.kind !== 'none';
    const comparisonDriver = withoutDisturbance ? driver : rivalOf(state);
    const comparisonExperiment = withoutDisturbance ? undisturbedOf(experiment) : experiment;
    const chosen = chosenDrives(state);
    const company = chosen?.population ?? (driver === 'evolved' && trial === noTrial ? population : null);
    const gains = chosen?.population[0].gains ?? gainsOf(state, driver, paper);
    const rival = chosen?.partner?.gains ?? gainsOf(state, comparisonDriver, paper);
    const [drivingRun, otherRuns, comparisonRun, paperRun, pins] = together([
      () => driving(experiment, gains),
      () => (company ? others(experiment, company) : none),
      () => comparison(comparisonExperiment, rival),
      () => (hidesPaper(state) ? null : paperEp(experiment, gainsOf(state, 'paper-ep', paper))),
      () => pinned(state.pins),
    ]);
    return {
      experiment,
      gains,
      driving: drivingRun,
      others: otherRuns,
      comparison: comparisonRun,
      comparisonDriver,
      compared: { experiment: comparisonExperiment, gains: rival },
      chosen,
      withoutDisturbance,
      paperEp: paperRun,
      pins,
    };
  };
}

/** `failure`: why what is asked for cannot be seen, or null; then the scene is of what drove before. @typedef {{ state: State, scene: Scene, isComputing: boolean, failure: unknown }} Seen */

/** Whether the same drives in both. @param {State} a @param {State} b */
const drivesAs = (a, b) =>
  a.experiment === b.experiment &&
  a.population === b.population &&
  a.driver === b.driver &&
  a.handGains === b.handGains &&
  a.trial === b.trial &&
  a.pins === b.pins &&
  a.page === b.page;

/**
 * The newest state whose drives are all there, with its scene: what takes long to drive is seen once it has been driven, and of
 * what is asked for meanwhile only the newest. What cannot be driven is told once, and asked for again when something else is to drive.
 * @param {(state: State) => Scene} sceneOf @param {State} first A state of which everything is driven at once. @param {() => void} onArrival @param {(error: unknown) => void} onFailure
 */
export function createSight(sceneOf, first, onArrival, onFailure) {
  let shown = { state: first, scene: sceneOf(first) };
  let isComputing = false;
  let isStale = false;
  let arriving = Promise.resolve();
  /** Of which no drives could be had, and why. @type {{ state: State, error: unknown } | null} */
  let failed = null;
  const fail = (/** @type {State} */ state, /** @type {unknown} */ error) => {
    if (isLost(error)) throw error;
    failed = { state, error };
    onFailure(error);
  };
  /** @param {State} state @returns {Promise<void> | void} */
  const ask = (state) => {
    isComputing = true;
    isStale = false;
    try {
      shown = { state, scene: sceneOf(state) };
      isComputing = false;
      failed = null;
    } catch (error) {
      if (!(error instanceof Pending)) {
        isComputing = false;
        return fail(state, error);
      }
      arriving = error.arrival
        // What it lacks then is waited for too.
        .then(() => ask(state))
        .catch((reason) => fail(state, reason))
        .finally(onArrival);
      return arriving;
    }
  };
  /** @param {State} state @returns {unknown} */
  const failureOf = (state) => (failed && drivesAs(failed.state, state) ? failed.error : null);
  /** @param {State} state @returns {Seen} */
  const of = (state) => {
    const isAsked = isStale || (state !== shown.state && failureOf(state) === null);
    if (!isComputing && isAsked) ask(state);
    return { ...shown, isComputing, failure: failureOf(state) };
  };
  return {
    of,
    /** Resolves once the state, or a later one, is seen or cannot be. @param {() => State} stateNow */
    async whenSeen(stateNow) {
      // What was asked for before, and then this.
      for (let i = 0; i < 2 && of(stateNow()).isComputing; i += 1) await arriving;
    },
    /** What drives in a state is another than it was: a part of the page has come that has a say in it. */
    renew() {
      isStale = true;
      onArrival();
    },
  };
}
