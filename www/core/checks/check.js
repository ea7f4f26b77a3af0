// What a check is: one law or known value, worked out anew by the core, beside what it must be.
/** @import { PartialExperiment, Preset } from '../../../pkg/ep_locomotion.js' */

/** @typedef {readonly [number, number, number]} Triple */
/** @typedef {'parking' | 'noise' | 'tracking' | 'unlimited'} Task */

/** What holds, as one sentence, and what was measured. @typedef {readonly [sentence: string, measure: string]} Said */
/**
 * What every language says of each check, from what the check is about. `count` things were looked at.
 * @typedef {object} Sentences
 * @property {(number: number) => Said} command
 * @property {(count: number) => Said} errorPosture
 * @property {(count: number) => Said} lyapunovRate
 * @property {(count: number) => Said} halfArcs
 * @property {(count: number) => Said} circle
 * @property {(count: number) => Said} speeds
 * @property {(count: number) => Said} accelerations
 * @property {(count: number) => Said} limitsTwice
 * @property {(count: number) => Said} mirror
 * @property {(count: number) => Said} parked
 * @property {(preset: Preset, gains: Triple, withPosture: boolean) => Said} run
 * @property {() => Said} paperOrder
 * @property {(count: number) => Said} parts
 * @property {(count: number, preset: Preset) => Said} lanes
 * @property {(count: number) => Said} lanesFromStarts
 * @property {(rows: number) => Said} mapRows
 * @property {() => Said} learningRates
 * @property {(generations: number) => Said} offspringGains
 * @property {() => Said} offspringSigmas
 * @property {() => Said} drawMean
 * @property {() => Said} drawVariance
 * @property {() => Said} drawCorrelation
 * @property {() => Said} offspringCosts
 * @property {() => Said} strangers
 * @property {() => Said} wins
 * @property {() => Said} survivors
 * @property {() => Said} parents
 * @property {(generations: number) => Said} neverWorse
 * @property {(generations: number) => Said} optimum
 * @property {(task: Task, preset: Preset, seed: number, generations: number) => Said} hash
 * @property {(generations: number) => Said} watched
 * @property {(seed: number) => Said} draws
 * @property {(generations: number) => Said} worker
 */

/**
 * What the checks need of the core.
 * @typedef {Pick<typeof import('../../../pkg/ep_locomotion.js'), 'Evolution' | 'Simulation' | 'evaluate' | 'experiment' | 'fares' | 'landscape' | 'learningRates' | 'paper' | 'simulate' | 'simulateAll'>} Core
 */

/**
 * The known values: tests/golden.json, which tests/golden.rs describes and checks natively and under Node.
 * @typedef {object} Golden
 * @property {{ tolerance: number, rows: readonly { error: Triple, gains: Triple, reference: readonly [number, number], command: readonly [number, number] }[] }} commands
 * @property {{ tolerance: number, rows: readonly { preset: Preset, gains: Triple, finalTime: number, cost: number, end: Triple | null }[] }} runs
 * @property {{ seed: number, parent: Triple, gains: Triple, common: number, sigmas: Triple, opponents: readonly number[], noise: readonly [number, number] }} draws
 * @property {readonly KnownEvolution[]} evolutions
 * @property {{ seed: number, generations: number, cost: readonly [number, number] }} optimum
 */
/** @typedef {{ task: Task, preset: Preset, changes: PartialExperiment, generations: number, hash: string }} KnownEvolution */

/** `expected` holds as many values as `found`; `between` has its two ends there. @typedef {'same' | 'near' | 'atMost' | 'below' | 'between'} Bound */
/**
 * @typedef {object} Outcome
 * @property {Bound} bound
 * @property {readonly (number | string)[]} expected
 * @property {readonly (number | string)[]} found
 * @property {readonly string[]} units Of each value; none where there is none.
 * @property {number} tolerance How near is near, relatively.
 * @property {boolean} passed
 */

/** `about` is what its sentence tells of it. @typedef {{ name: keyof Sentences, about: readonly unknown[], run: (core: Core) => Outcome }} Check */
/** @typedef {Omit<Check, 'run'> & Outcome} Result */

/** @typedef {typeof groupNames[number]} Group */
export const groupNames = /** @type {const} */ (['motion', 'cost', 'evolution', 'bits']);

/**
 * @template {keyof Sentences} N
 * @param {N} name @param {Parameters<Sentences[N]>} about @param {Check['run']} run
 * @returns {Check}
 */
export const check = (name, about, run) => ({ name, about, run });

/** @param {Bound} bound @param {Outcome['expected']} expected @param {Outcome['found']} found @param {readonly string[]} units @param {boolean} passed */
const outcome = (bound, expected, found, units, passed, tolerance = 0) => ({
  bound,
  expected,
  found,
  units,
  tolerance,
  passed: passed && found.length > 0,
});

// A number that is not a number passes nowhere, because every comparison with it is false.

/** The same to the last bit. @param {string | number} expected @param {string | number} found @returns {Outcome} */
export const same = (expected, found) => outcome('same', [expected], [found], [], found === expected);

/** Each within a relative tolerance. @param {readonly number[]} expected @param {readonly number[]} found @param {number} tolerance @param {readonly string[]} units @returns {Outcome} */
export function near(expected, found, tolerance, units) {
  const passed = expected.every((value, i) => Math.abs(found[i] / value - 1) <= tolerance);
  return outcome('near', expected, found, units, passed, tolerance);
}

/** Each at most its limit, but for rounding. @param {readonly number[]} limits @param {readonly number[]} found @param {readonly string[]} [units] @returns {Outcome} */
export function atMost(limits, found, units = []) {
  const passed = limits.every((limit, i) => found[i] <= limit * (1 + 1e-12));
  return outcome('atMost', limits, found, units, passed);
}

/** Each under its limit. @param {readonly number[]} limits @param {readonly number[]} found @returns {Outcome} */
export function below(limits, found) {
  const passed = limits.every((limit, i) => found[i] < limit);
  return outcome('below', limits, found, [], passed);
}

/** @param {number} low @param {number} high @param {number} found @returns {Outcome} */
export const between = (low, high, found) =>
  outcome('between', [low, high], [found], [], low <= found && found <= high);

const primes = [2, 3, 5, 7, 11, 13, 17, 19];

/** Places that are scattered in the ranges, the same on every machine. @param {number} count @param {...readonly [number, number]} ranges */
export const scattered = (count, ...ranges) =>
  Array.from({ length: count }, (_, i) =>
    ranges.map(([low, high], j) => low + (high - low) * (((i + 1) * Math.sqrt(primes[j])) % 1)),
  );

/** The largest magnitude; of nothing there is none. @param {readonly number[]} values */
export const largest = (values) =>
  values.length === 0 ? Number.NaN : values.reduce((most, value) => Math.max(most, Math.abs(value)), 0);

/** How many differ in any bit: none may. @param {ArrayLike<number>} a @param {ArrayLike<number>} b */
export function sameBits(a, b) {
  let count = Math.abs(a.length - b.length);
  for (let i = 0; i < Math.min(a.length, b.length); i++) if (!Object.is(a[i], b[i])) count += 1;
  return same(0, a.length === 0 ? Number.NaN : count);
}

/** The angle in (−π, π] that points the same way. @param {number} angle */
export const wrap = (angle) => angle - 2 * Math.PI * Math.ceil((angle - Math.PI) / (2 * Math.PI));
