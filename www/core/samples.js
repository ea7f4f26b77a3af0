// All samples of a run as columns of numbers, which go from a worker to the page without a copy.
/** @import { Outcome, Sample, Simulation } from '../../pkg/ep_locomotion.js' */
/** Like a list, of which one asks only for samples that there are. @typedef {Pick<readonly Sample[], 'length' | 'map'> & { at: (i: number) => Sample }} Samples */
/** @typedef {{ outcome: Outcome | null, rows: Float64Array }} Columns One row a sample. */

/** @type {readonly (keyof Sample)[]} */
const numbers = ['time', 'lyapunov', 'lyapunovRate'];
const postures = /** @type {const} */ (['posture', 'reference', 'error']);
const velocities = /** @type {const} */ (['command', 'velocity']);
const width = numbers.length + 3 * postures.length + 2 * velocities.length;

/** Drives to the end. @param {Simulation} robot @param {(sample: Sample) => void} see */
export function driveOn(robot, see) {
  let sample;
  do {
    sample = robot.step();
    see(sample);
  } while (sample.outcome === null);
  robot.free();
}

/** @param {Simulation} robot @param {number} most How many samples there may be. @returns {Columns} */
export function columnsOf(robot, most) {
  let rows = new Float64Array(most * width);
  let at = 0;
  /** @type {Outcome | null} */
  let outcome = null;
  driveOn(robot, (sample) => {
    const row = [
      ...numbers.map((name) => /** @type {number} */ (sample[name])),
      ...postures.flatMap((name) => [sample[name].x, sample[name].y, sample[name].theta]),
      ...velocities.flatMap((name) => [sample[name].linear, sample[name].angular]),
    ];
    rows.set(row, at);
    at += width;
    outcome = sample.outcome;
  });
  rows = rows.slice(0, at);
  return { outcome, rows };
}

/** The samples, each made when it is looked at. @param {Columns} columns @returns {Samples} */
export function samplesOf({ outcome, rows }) {
  const length = rows.length / width;
  /** @param {number} i @returns {Sample} */
  const sampleAt = (i) => {
    const row = rows.subarray(i * width, (i + 1) * width);
    const posture = (/** @type {number} */ from) => ({
      x: row[from],
      y: row[from + 1],
      theta: row[from + 2],
    });
    const velocity = (/** @type {number} */ from) => ({ linear: row[from], angular: row[from + 1] });
    const own = i === length - 1 ? outcome : null;
    return {
      time: row[0],
      posture: posture(3),
      reference: posture(6),
      command: velocity(12),
      velocity: velocity(14),
      error: posture(9),
      lyapunov: row[1],
      lyapunovRate: row[2],
      arrived: own === 'arrived',
      outcome: own,
    };
  };
  return {
    length,
    at: (i) => sampleAt(i < 0 ? i + length : i),
    map: (use) => Array.from({ length }, (_, i) => sampleAt(i)).map(use),
  };
}
