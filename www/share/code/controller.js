// What is taken away of a drive: its controller, what it was driven in, and what the page says of it. Plain values, no language.
/** @import { Experiment, Posture, Run, Triple } from '../../core/engine.js' */
import { hasMovingReference } from '../../core/reference.js';
import { fromFirst } from '../../core/starts.js';
import { undisturbed } from '../../run/scene.js';
import { fingerprintOf } from './fingerprint.js';

/** @typedef {(experiment: Experiment, gains: readonly Triple[]) => Run[]} Drive */

/**
 * @typedef {object} Controller
 * @property {string} name That of the file, other for other drives; a word that every language takes for a name.
 * @property {string} version Of the program.
 * @property {string} link
 * @property {Triple} gains
 * @property {Experiment} experiment Without a disturbance.
 * @property {Posture} start
 * @property {number} samples Until the horizon.
 * @property {boolean} isTracking The goal moves.
 * @property {boolean} canDiverge Nothing keeps a velocity finite.
 * @property {{ time: number, cost: number, pose: Posture, outcome: Run['outcome'] }} page What the page says of the drive.
 * @property {boolean} isDisturbed On the page something pushes the robot.
 * @property {boolean} isSteady Rounding does not decide how it ends.
 */

/** By how much a start is moved to see whether the drive hangs on rounding (m), and how little that may change J and the last pose. */
const nudge = 1e-12;
const mostChange = 1e-9;

/** Samples until the horizon, as the core counts them: the first n with n · sampleTime ≥ horizon. @param {Experiment} experiment */
function samplesOf({ horizon, sampleTime }) {
  const n = Math.floor(horizon / sampleTime);
  return n * sampleTime < horizon ? n + 1 : n;
}

/** Whether a drive from a hair's breadth beside ends the same. @param {Drive} drive @param {Experiment} experiment @param {Triple} gains @param {Run} run */
function isSteady(drive, experiment, gains, run) {
  const [{ x, y, theta }] = experiment.starts;
  const numbers = endOf(run);
  const isNear = (/** @type {number} */ value, /** @type {number} */ i) =>
    value === numbers[i] || Math.abs(value - numbers[i]) <= mostChange * Math.max(1, Math.abs(value));
  return [-nudge, nudge].every((by) => {
    const [other] = drive({ ...experiment, starts: [{ x: x + by, y: y + by, theta }] }, [gains]);
    return other.finalTime === run.finalTime && endOf(other).every(isNear);
  });
}

/** @param {Run} run */
const lastPose = ({ x, y, theta }) => ({
  x: x[x.length - 1],
  y: y[y.length - 1],
  theta: theta[theta.length - 1],
});

/** @param {Run} run */
const endOf = (run) => {
  const { x, y, theta } = lastPose(run);
  return [run.cost.total, x, y, theta];
};

/**
 * The controller that drives from the first start of an experiment.
 * @param {Drive} drive @param {Experiment} from @param {Triple} gains @param {{ version: string, link: string }} about
 * @returns {Controller}
 */
export function controllerOf(drive, from, gains, { version, link }) {
  const experiment = undisturbed(fromFirst(from));
  const [run] = drive(experiment, [gains]);
  const { speed, turnRate, acceleration, turnAcceleration } = experiment.limits;
  return {
    name: `controller_${fingerprintOf(experiment, gains)}`,
    version,
    // It stands in a comment of one line.
    link: link.replace(/[\s\\]/g, encodeURIComponent),
    gains,
    experiment,
    start: experiment.starts[0],
    samples: samplesOf(experiment),
    isTracking: hasMovingReference(experiment),
    canDiverge: (speed ?? acceleration) === null || (turnRate ?? turnAcceleration) === null,
    page: { time: run.finalTime, cost: run.cost.total, pose: lastPose(run), outcome: run.outcome },
    isDisturbed: from.disturbance.kind !== 'none',
    isSteady: isSteady(drive, experiment, gains, run),
  };
}
