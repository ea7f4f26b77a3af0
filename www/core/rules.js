// What single values follow from, as the core has it: for who has waited for the core, as every view has.
/** @import { Experiment } from '../../pkg/ep_locomotion.js' */
import { winsBout } from '../../pkg/ep_locomotion.js';

export { lawTerms, startsOnGrid, winsBout } from '../../pkg/ep_locomotion.js';

/** In what the gains of a law are, in the order of kx, ky, kθ, as tables write it. @type {Readonly<Record<Experiment['law'], readonly [string, string, string]>>} */
export const gainUnits = {
  'shim-kim': ['1/s', '1/(m^2 s)', 'rad/s'],
  kanayama: ['1/s', 'rad/m^2', 'rad/m'],
};

/**
 * How many bouts each had to expect to win: its opponents are drawn evenly, with replacement and never itself, so that of each bout
 * it wins the share of all others that it would beat. Who beats whom is the core's rule, and holds of all from some J on.
 * @param {readonly number[]} costs @param {number} bouts
 */
export function expectedWins(costs, bouts) {
  const sorted = Float64Array.from(costs).sort();
  /** @type {Map<number, number>} */
  const beaten = new Map();
  let first = 0;
  for (const own of sorted) {
    while (first < sorted.length && !winsBout(own, sorted[first])) first += 1;
    beaten.set(own, sorted.length - first - (winsBout(own, own) ? 1 : 0));
  }
  return costs.map((own) => (bouts * (beaten.get(own) ?? 0)) / (costs.length - 1));
}
