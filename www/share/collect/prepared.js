// What an exercise had set, that its students could not choose: whose gains drive, which by hand, and which generation. Links are
// free, so a hand-in may have something else all the same.
/** @import { Linked } from '../../link/keys.js' */
/** @import { Exercise } from '../../run/exercise.js' */
import { wayOf } from '../../run/exercise.js';

/** Null is what nobody can tell. @typedef {{ driver: Linked['driver'] | null, gains: Linked['handGains'], generation: number | null }} Prepared */

/** What more than half of these are. @template {string | number} T @param {readonly T[]} all @returns {T | null} */
function mostOf(all) {
  const counts = new Map();
  for (const one of all) counts.set(one, (counts.get(one) ?? 0) + 1);
  return all.find((one) => counts.get(one) > all.length / 2) ?? null;
}

/** @param {Exercise} exercise @param {import('../../run/exercise.js').Group} group */
const isFree = (exercise, group) => wayOf(exercise, group) === 'free';

/** As the exercise's own link has it; where it is known only from hand-ins, as most of those do. @param {Linked} given @param {readonly Linked[]} handedIn Of this exercise. @returns {Prepared} */
export function preparedBy(given, handedIn) {
  const { exercise, student } = given;
  if (student.who === '' && student.handin === '')
    return { driver: given.driver, gains: given.handGains, generation: given.generation };
  // A slider that is moved makes it one's own gains that drive.
  const fixed = handedIn.filter(({ driver }) => driver !== 'hand' || !isFree(exercise, 'gains'));
  const gains = mostOf(handedIn.map(({ driver, handGains }) => (driver === 'hand' ? String(handGains) : '')));
  return {
    driver: mostOf(fixed.map(({ driver }) => driver)),
    gains: handedIn.find(({ handGains }) => String(handGains) === gains)?.handGains ?? null,
    generation: mostOf(
      handedIn.filter(({ driver }) => driver === 'evolved').map(({ generation }) => generation),
    ),
  };
}

/** What of a run its student could not have come to by pressing, by the names of links. @param {Linked} run @param {Exercise} exercise As it was given. @param {Prepared} prepared */
export function unreachable({ driver, handGains, generation }, exercise, prepared) {
  const isChosen = isFree(exercise, 'drives') && (!driver.startsWith('paper-') || isFree(exercise, 'paper'));
  const isMoved = driver === 'hand' && isFree(exercise, 'gains');
  const names = {
    drives: prepared.driver !== null && driver !== prepared.driver && !isChosen && !isMoved,
    gains:
      prepared.gains !== null &&
      driver === 'hand' &&
      String(handGains) !== String(prepared.gains) &&
      !isFree(exercise, 'gains'),
    // What is set anew begins with generation 0.
    generation:
      prepared.generation !== null &&
      driver === 'evolved' &&
      ![0, prepared.generation].includes(generation) &&
      !isFree(exercise, 'run'),
  };
  return Object.entries(names).flatMap(([name, isSo]) => (isSo ? [name] : []));
}
