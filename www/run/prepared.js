// What an exercise has set that its students cannot choose: whose gains drive, which by hand, and which generation. A step of the
// lesson may have others within the exercise, and links are free.
/** @import { Group, Exercise } from './exercise.js' */
/** @import { State } from './state.js' */
import { wayOf } from './exercise.js';

/** @typedef {Pick<State, 'driver' | 'handGains' | 'generation'>} Drive */
/** Null is what is free to choose, and what nobody can tell. @typedef {{ driver: Drive['driver'] | null, gains: Drive['handGains'], generation: number | null }} Prepared */
/** @typedef {'drives' | 'gains' | 'generation'} Unreachable */

/** @type {Prepared} */
export const nothingPrepared = Object.freeze({ driver: null, gains: null, generation: null });

/** @param {Exercise} exercise @param {Group} group */
export const isOpen = (exercise, group) => wayOf(exercise, group) === 'free';

/** What of a run nobody can choose where it is given as an exercise. @param {Drive} given @param {Exercise} exercise @returns {Prepared} */
export function preparedAs({ driver, handGains, generation }, exercise) {
  const isOwn = /** @type {const} */ (['drives', 'gains', 'paper']).every((group) => isOpen(exercise, group));
  return {
    driver: isOwn ? null : driver,
    gains: isOwn ? null : handGains,
    generation: isOpen(exercise, 'run') ? null : generation,
  };
}

/** Whether a link tells of as much as it now would: older ones do not. @param {Drive} run @param {Exercise} exercise @param {Prepared} prepared */
export function isAllTold(run, exercise, prepared) {
  const names = /** @type {const} */ (['driver', 'gains', 'generation']);
  const own = preparedAs(run, exercise);
  return names.every((name) => (own[name] === null) === (prepared[name] === null));
}

/** @param {Drive & Pick<State, 'exercise' | 'student'>} run As it was opened. */
export const preparedIn = (run) => run.student.base?.prepared ?? preparedAs(run, run.exercise);

/** What of a run its student could not have come to by pressing, by the names of links. @param {Drive} run @param {Exercise} exercise As it was given. @param {Prepared} prepared @returns {Unreachable[]} */
export function unreachable({ driver, handGains, generation }, exercise, prepared) {
  const isChosen = isOpen(exercise, 'drives') && (!driver.startsWith('paper-') || isOpen(exercise, 'paper'));
  const isMoved = driver === 'hand' && isOpen(exercise, 'gains');
  const isSo = {
    drives: prepared.driver !== null && driver !== prepared.driver && !isChosen && !isMoved,
    gains:
      prepared.gains !== null &&
      driver === 'hand' &&
      String(handGains) !== String(prepared.gains) &&
      !isOpen(exercise, 'gains'),
    // What is set anew begins with generation 0.
    generation:
      prepared.generation !== null &&
      driver === 'evolved' &&
      ![0, prepared.generation].includes(generation) &&
      !isOpen(exercise, 'run'),
  };
  return /** @type {Unreachable[]} */ (Object.keys(isSo)).filter((name) => isSo[name]);
}
