// What an exercise had set that its students could not choose, where it may be known from nothing but what they handed in.
/** @import { Linked } from '../../link/keys.js' */
/** @import { Prepared } from '../../run/prepared.js' */
import { isOpen, preparedIn } from '../../run/prepared.js';

/** What more than half of these are. @template {string | number} T @param {readonly T[]} all @returns {T | null} */
function mostOf(all) {
  const counts = new Map();
  for (const one of all) counts.set(one, (counts.get(one) ?? 0) + 1);
  return all.find((one) => counts.get(one) > all.length / 2) ?? null;
}

/** As the exercise's own link has it; where it is known only from hand-ins, as most of those do. @param {Linked} given @param {readonly Linked[]} handedIn Of this exercise. @returns {Prepared} */
export function preparedBy(given, handedIn) {
  const { exercise, student } = given;
  if (student.who === '' && student.handin === '') return preparedIn(given);
  // A slider that is moved makes it one's own gains that drive.
  const fixed = handedIn.filter(({ driver }) => driver !== 'hand' || !isOpen(exercise, 'gains'));
  const gains = mostOf(handedIn.map(({ driver, handGains }) => (driver === 'hand' ? String(handGains) : '')));
  return {
    driver: mostOf(fixed.map(({ driver }) => driver)),
    gains: handedIn.find(({ handGains }) => String(handGains) === gains)?.handGains ?? null,
    generation: mostOf(
      handedIn.filter(({ driver }) => driver === 'evolved').map(({ generation }) => generation),
    ),
  };
}
