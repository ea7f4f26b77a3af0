// How the starts of an experiment, of which there may be thousands, are handed to the core.
/** @import { Experiment, PartialExperiment } from '../../pkg/ep_locomotion.js' */

/** Fewer take no time as objects; of more the core says that they are too many. */
const least = 100;
const most = 10_000;

/** @param {any} start */
const isWhole = (start) =>
  typeof start?.x === 'number' &&
  typeof start.y === 'number' &&
  typeof start.theta === 'number' &&
  Object.keys(start).length === 3;

/** Thousands are read ten times sooner as one list of numbers. What is no posture the core has to see, and name. @template {PartialExperiment} T @param {T} from @returns {PartialExperiment} */
export function withStartsInOne(from) {
  // Nor what is no experiment.
  const starts = from?.starts;
  const isMany = Array.isArray(starts) && starts.length >= least && starts.length <= most;
  if (!isMany || !starts.every(isWhole)) return from;
  const numbers = new Float64Array(3 * starts.length);
  for (const [i, { x, y, theta }] of starts.entries()) numbers.set([x, y, theta], 3 * i);
  return { ...from, starts: numbers };
}

/** A robot drives from the first start alone. @param {Experiment} experiment @returns {Experiment} */
export const fromFirst = (experiment) => ({ ...experiment, starts: experiment.starts.slice(0, 1) });
