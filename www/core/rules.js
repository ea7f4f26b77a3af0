// What single values follow from, as the core has it: for who has waited for the core, as every view has.
import { winsBout } from '../../pkg/ep_locomotion.js';

export { lawTerms, startsOnGrid, winsBout } from '../../pkg/ep_locomotion.js';

/**
 * How many bouts each had to expect to win: its opponents are drawn evenly, with replacement and never itself, so that of each bout
 * it wins the share of all others that it would beat. Who beats whom is the core's rule, and holds of all from some J on.
 * @param {readonly number[]} costs @param {number} bouts
 */
export function expectedWins(costs, bouts) {
  const sorted = Float64Array.from(costs).sort();
  return costs.map((own) => {
    let [first, last] = [0, sorted.length];
    while (first < last) {
      const middle = (first + last) >> 1;
      if (winsBout(own, sorted[middle])) last = middle;
      else first = middle + 1;
    }
    const beaten = sorted.length - first - (winsBout(own, own) ? 1 : 0);
    return (bouts * beaten) / (costs.length - 1);
  });
}
