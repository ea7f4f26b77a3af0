// The cost J: known values, its parts added up again, and the same J however a robot is driven.
/** @import { Experiment, Run } from '../../../pkg/ep_locomotion.js' */
/** @import { Check, Golden } from './check.js' */
import { atMost, below, check, largest, near, sameBits, scattered, wrap } from './check.js';

const presets = /** @type {const} */ (['velocity-limits', 'acceleration-limits']);

/** @param {Golden} golden @returns {Check[]} */
export const costChecks = ({ runs }) => [
  ...runs.rows.map(({ preset, gains, cost, finalTime, end }) =>
    check('run', [preset, gains, end !== null], (core) => {
      const run = core.simulate(core.experiment(preset), gains);
      const last = run.time.length - 1;
      const posture = end ? [run.x[last], run.y[last], run.theta[last]] : [];
      const units = ['', 's', 'm', 'm', 'rad'];
      const expected = [cost, finalTime, ...(end ?? [])];
      return near(expected, [run.cost.total, run.finalTime, ...posture], runs.tolerance, units);
    }),
  ),
  check('paperOrder', [], (core) => {
    const costsOf = (/** @type {'ep' | 'arbitrary'} */ method) =>
      core
        .paper()
        .filter((row) => row.method === method)
        .map(({ preset, gains }) => core.evaluate(core.experiment(preset), gains)[0]);
    return below(costsOf('arbitrary'), costsOf('ep'));
  }),
  partsCheck(),
  ...laneChecks(),
];

/** @returns {Check} */
function partsCheck() {
  // Some of them negative, for the penalty.
  const gains = scattered(20, [-1, 10], [-1, 10], [-1, 10]);
  return check('parts', [gains.length], (core) => {
    const experiment = core.experiment('velocity-limits');
    const differences = gains.map((k) => {
      const run = core.simulate(experiment, k);
      return costAgain(experiment, run, k) / run.cost.total - 1;
    });
    return atMost([1e-12], [largest(differences)]);
  });
}

/** J by equation (9), from the path alone. @param {Experiment} experiment @param {Run} run @param {number[]} gains */
function costAgain({ goal, sampleTime, weights }, { x, y, theta, linear, angular, finalTime }, gains) {
  const error = (/** @type {number} */ n) => [x[n] - goal.x, y[n] - goal.y, wrap(theta[n] - goal.theta)];
  const last = x.length - 1;
  let sum = 0;
  for (let n = 0; n < last; n++) {
    const [dx, dy, turn] = error(n);
    const energy = weights.velocity[0] * linear[n] ** 2 + weights.velocity[1] * angular[n] ** 2;
    sum += dx ** 2 + dy ** 2 + turn ** 2 + energy;
  }
  const finalError = error(last).reduce((total, value, i) => total + weights.final[i] * value ** 2, 0);
  const penalty = gains.reduce((total, gain) => total + weights.penalty * Math.max(0, -gain), 0);
  return finalTime + finalError + 0.5 * sampleTime * sum + penalty;
}

/** @returns {Check[]} */
function laneChecks() {
  const gains = scattered(60, [0, 10], [0, 10], [0, 10]).flat();
  const starts = scattered(20, [-3, 3], [-3, 3], [-3, 3]).map(([x, y, theta]) => ({ x, y, theta }));
  const robot = /** @type {const} */ ([3, 0.1, 5]);
  const rows = 24;
  return [
    ...presets.map((preset) =>
      check('lanes', [gains.length / 3, preset], (core) => {
        const experiment = { ...core.experiment(preset), horizon: 4 };
        const single = core.simulateAll(experiment, gains).map((run) => run.cost.total);
        return sameBits(core.evaluate(experiment, gains), single);
      }),
    ),
    check('lanesFromStarts', [starts.length], (core) => {
      const disturbance = { kind: /** @type {const} */ ('random'), linear: 0.2, angular: 0.3, seed: 4 };
      const experiment = { starts, disturbance, horizon: 4 };
      const single = starts.map((_, start) => core.simulate(experiment, robot, start).cost.total);
      return sameBits(core.fares(experiment, robot).cost, single);
    }),
    check('mapRows', [rows], (core) => {
      /** @type {import('../../../pkg/ep_locomotion.js').Landscape} */
      const map = {
        x: { gain: 'kx', from: 0.5, to: 10, count: rows },
        y: { gain: 'ktheta', from: 0.5, to: 10, count: rows },
        gains: robot,
      };
      const whole = core.landscape({}, map);
      const parts = Array.from({ length: rows }, (_, row) => [
        ...core.landscape({}, { ...map, rows: [row, row + 1] }),
      ]);
      return sameBits(whole, parts.flat());
    }),
  ];
}
