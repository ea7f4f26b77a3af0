// What two experiments have in common.
/** @import { Experiment } from '../../core/engine.js' */

/** Whether two experiments differ in nothing but the seed. @param {Experiment} a @param {Experiment} b */
export function isSameButSeed(a, b) {
  const [one, other] = [a, b].map((experiment) =>
    JSON.stringify({ ...experiment, evolution: { ...experiment.evolution, seed: 0 } }),
  );
  return one === other;
}
