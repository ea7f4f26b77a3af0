// Laws of the robot: the control law, the arcs of its motion, the Lyapunov function, the limits.
/** @import { Gains, PartialExperiment } from '../../../pkg/ep_locomotion.js' */
/** @import { Check, Core, Golden } from './check.js' */
import { once } from '../once.js';
import { atMost, check, largest, near, same, sameBits, scattered, wrap } from './check.js';

const origin = { x: 0, y: 0, theta: 0 };
const unlimited = { speed: null, turnRate: null, acceleration: null, turnAcceleration: null };

/** @param {Golden} golden @returns {Check[]} */
export const motionChecks = ({ commands }) => [
  ...commands.rows.map(({ error, gains, reference, command }, i) =>
    check('command', [i + 1], (core) => {
      const { linear, angular } = sampleAt(core, error, reference, gains).command;
      return near(command, [linear, angular], commands.tolerance, ['m/s', 'rad/s']);
    }),
  ),
  ...errorChecks(),
  ...arcChecks(),
  ...limitChecks(),
  ...symmetryChecks(),
];

/** The first sample of a robot without limits that has this error posture: the goal is the origin. @param {Core} core @param {readonly number[]} error @param {readonly number[]} reference @param {Gains} gains */
function sampleAt(core, [x, y, theta], [linear, angular], gains) {
  const starts = [{ x: -x, y: -y, theta: -theta }];
  const referenceVelocity = { linear, angular };
  return firstSample(core, { starts, goal: origin, referenceVelocity, limits: unlimited }, gains);
}

/** @param {Core} core @param {PartialExperiment} experiment @param {Gains} gains */
function firstSample(core, experiment, gains) {
  const robot = new core.Simulation(experiment, gains);
  const sample = robot.step();
  robot.free();
  return sample;
}

/** @returns {Check[]} */
function errorChecks() {
  const metres = /** @type {const} */ ([-3, 3]);
  const angles = /** @type {const} */ ([-3.1, 3.1]);
  const gain = /** @type {const} */ ([-10, 10]);
  const pairs = scattered(30, metres, metres, angles, metres, metres, angles);
  // Away from the places where the law divides by less than it may.
  const errors = scattered(60, metres, metres, angles, gain, gain, gain, metres, metres).filter(
    ([, , theta]) => Math.min(Math.abs(Math.sin(theta)), Math.abs(Math.cos(theta))) > 0.05,
  );
  return [
    check('errorPosture', [pairs.length], (core) => {
      const differences = pairs.flatMap(([x, y, theta, goalX, goalY, goalTheta]) => {
        const goal = { x: goalX, y: goalY, theta: goalTheta };
        const { error } = firstSample(core, { starts: [{ x, y, theta }], goal }, [1, 1, 1]);
        const [cos, sin] = [Math.cos(goalTheta), Math.sin(goalTheta)];
        return [
          error.x - (cos * (goalX - x) + sin * (goalY - y)),
          error.y - (cos * (goalY - y) - sin * (goalX - x)),
          error.theta - wrap(goalTheta - theta),
        ];
      });
      return atMost([1e-13], [largest(differences)]);
    }),
    check('lyapunovRate', [errors.length], (core) => {
      const differences = errors.map(([x, y, theta, kx, ky, ktheta, ...reference]) => {
        const sample = sampleAt(core, [x, y, theta], reference, [kx, ky, ktheta]);
        const [cos, sin] = [Math.cos(theta), Math.sin(theta)];
        const expected = -kx * x ** 2 * cos ** 2 - ky * y ** 4 - ktheta * sin ** 2;
        const { linear, angular } = sample.velocity;
        // The terms that cancel are as large as the velocity times the error.
        const scale = 1 + (Math.abs(linear) + Math.abs(angular)) * sample.lyapunov;
        return (sample.lyapunovRate - expected) / scale;
      });
      return atMost([1e-13], [largest(differences)]);
    }),
  ];
}

/** @returns {Check[]} */
function arcChecks() {
  const metres = /** @type {const} */ ([-3, 3]);
  const arcs = scattered(25, metres, metres, metres, [-2, 2], [-8, 8]);
  const duration = 0.5;
  const distance = (/** @type {number[]} */ a, /** @type {number[]} */ b) =>
    Math.hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);

  /** A robot whose gains are 0 does only what the slip does to it. @param {Core} core @param {number[]} arc @param {number} samples */
  function endOf(core, [x, y, theta, linear, angular], samples) {
    const experiment = {
      starts: [{ x, y, theta }],
      disturbance: { kind: /** @type {const} */ ('slip'), linear, angular },
      sampleTime: duration / samples,
      horizon: duration,
    };
    const run = core.simulate(experiment, [0, 0, 0]);
    return [run.x[samples], run.y[samples], run.theta[samples]];
  }

  /** @param {number[]} arc */
  function onCircle([x, y, theta, linear, angular]) {
    const half = (angular * duration) / 2;
    const chord = (linear * duration * Math.sin(half)) / half;
    return [x + chord * Math.cos(theta + half), y + chord * Math.sin(theta + half), theta + 2 * half];
  }

  const wholes = once((/** @type {Core} */ core) => arcs.map((arc) => endOf(core, arc, 1)));
  return [
    check('halfArcs', [arcs.length], (core) => {
      const differences = wholes(core).map((whole, i) => distance(whole, endOf(core, arcs[i], 2)));
      return atMost([1e-13], [largest(differences)]);
    }),
    check('circle', [arcs.length], (core) => {
      const differences = wholes(core).map((whole, i) => distance(whole, onCircle(arcs[i])));
      return atMost([1e-13], [largest(differences)]);
    }),
  ];
}

/** @returns {Check[]} */
function limitChecks() {
  const gains = scattered(10, [0, 30], [0, 30], [0, 30]);
  const drives = once((/** @type {Core} */ core) => {
    const experiment = { ...core.experiment('acceleration-limits'), horizon: 3 };
    return { ...experiment, runs: core.simulateAll(experiment, gains.flat()) };
  });
  /** The changes from sample to sample, from rest; the last sample repeats the one before. @param {Float64Array} velocity */
  const changes = (velocity) => [...velocity].map((value, n) => value - (n === 0 ? 0 : velocity[n - 1]));
  return [
    check('speeds', [gains.length], (core) => {
      const { limits, runs } = drives(core);
      const found = [runs.flatMap((run) => [...run.linear]), runs.flatMap((run) => [...run.angular])];
      return atMost([Number(limits.speed), Number(limits.turnRate)], found.map(largest), ['m/s', 'rad/s']);
    }),
    check('accelerations', [gains.length], (core) => {
      const { limits, runs, sampleTime } = drives(core);
      const found = [runs.flatMap((run) => changes(run.linear)), runs.flatMap((run) => changes(run.angular))];
      const rates = found.map((all) => largest(all) / sampleTime);
      const most = [Number(limits.acceleration), Number(limits.turnAcceleration)];
      return atMost(most, rates, ['m/s²', 'rad/s²']);
    }),
    check('limitsTwice', [gains.length], (core) => {
      const { limits, runs, sampleTime } = drives(core);
      const counts = runs.flatMap(({ linear, angular, commandLinear, commandAngular }) => [
        differentTwice(commandLinear, linear, limits.speed, limits.acceleration, sampleTime),
        differentTwice(commandAngular, angular, limits.turnRate, limits.turnAcceleration, sampleTime),
      ]);
      return same(
        0,
        counts.reduce((sum, count) => sum + count, 0),
      );
    }),
  ];
}

/** How many of the applied velocities are not the limited command, or change when they are limited again. @param {Float64Array} commands @param {Float64Array} applied @param {number | null} speed @param {number | null} acceleration @param {number} sampleTime */
function differentTwice(commands, applied, speed, acceleration, sampleTime) {
  const [largestSpeed, change] = [Number(speed), Number(acceleration) * sampleTime];
  const limited = (/** @type {number} */ value, /** @type {number} */ before) => {
    const clamped = Math.min(Math.max(value, -largestSpeed), largestSpeed);
    return Math.min(Math.max(clamped, before - change), before + change);
  };
  let count = 0;
  for (let n = 0; n + 1 < applied.length; n++) {
    const before = n === 0 ? 0 : applied[n - 1];
    const first = limited(commands[n], before);
    if (first !== applied[n] || limited(first, before) !== first) count += 1;
  }
  return count;
}

/** @returns {Check[]} */
function symmetryChecks() {
  const gains = scattered(20, [0, 10], [0, 10], [0, 10]).flat();
  return [
    check('mirror', [gains.length / 3], (core) => {
      const starts = [{ x: 0.5, y: -1, theta: 0.3 }];
      const goal = { x: 2, y: 2, theta: 1 };
      /** @param {typeof goal} posture */
      const mirrored = ({ x, y, theta }) => ({ x, y: -y, theta: -theta });
      const costs = core.evaluate({ starts, goal }, gains);
      const others = core.evaluate({ starts: starts.map(mirrored), goal: mirrored(goal) }, gains);
      return sameBits(costs, others);
    }),
    check('parked', [gains.length / 3], (core) => {
      const runs = core.simulateAll({ law: 'kanayama', horizon: 2 }, gains);
      return same(0, largest(runs.flatMap((run) => [...run.angular])));
    }),
  ];
}
