// A run as tables for other programs. Headers carry the units; numbers have all their digits.
/** @import { Experiment, Posture, Run, Stability, Statistics, Triple } from '../core/engine.js' */
/** @import { State } from '../run/state.js' */
import { gainUnits } from '../core/rules.js';

/** Lines that say where the numbers come from, which readers of tables can skip. @typedef {readonly string[]} Origin */

/** What stands in a column, from above. @typedef {readonly [head: string, values: ArrayLike<number>]} Column */

/** @param {Pick<State, 'history' | 'experiment'>} evolved @param {Origin} origin */
export function generationsCsv({ history, experiment: { law } }, origin) {
  /** @param {string} head @param {(statistics: Statistics) => number} of @returns {Column} */
  const column = (head, of) => [head, history.map(of)];
  const named = (/** @type {readonly string[]} */ names) =>
    names.map((name, i) => `${name} (${gainUnits[law][i]})`);
  const gains = named(['kx', 'ky', 'ktheta']);
  const sigmas = named(['mean sigma_x', 'mean sigma_y', 'mean sigma_theta']);
  return csv(origin, [
    column('generation', ({ generation }) => generation),
    column('drives', ({ evaluations }) => evaluations),
    column('J best', ({ best }) => best.cost),
    column('J median', ({ median }) => median),
    column('J worst', ({ worst }) => worst),
    ...gains.map((head, i) => column(head, ({ best }) => best.gains[i])),
    ...sigmas.map((head, i) => column(head, ({ meanSigmas }) => meanSigmas[i])),
  ]);
}

/** What a drive follows from and what it came to, so that its table can be read by itself. @param {Experiment} experiment @param {Triple} gains @param {Run} run @returns {Origin} */
export function driveOrigin(experiment, [kx, ky, ktheta], run) {
  const { law, starts, goal, referenceVelocity, limits, tolerance, weights, disturbance } = experiment;
  const limit = (/** @type {number | null} */ value, /** @type {string} */ unit) =>
    value === null ? 'none' : `${value} ${unit}`;
  const [x, y, theta] = gainUnits[law];
  const { kind, linear, angular, seed } = disturbance;
  const disturbed =
    kind === 'none' ? '' : ` ${linear} m/s, ${angular} rad/s${kind === 'random' ? `, seed ${seed}` : ''}`;
  return [
    `law ${law}; kx = ${kx} ${x}, ky = ${ky} ${y}, ktheta = ${ktheta} ${theta}`,
    `start ${postureOf(starts[0])}${starts.length > 1 ? `, the first of ${starts.length}: of it alone are the drive and its J` : ''}`,
    `goal ${postureOf(goal)}; reference v_r = ${referenceVelocity.linear} m/s, omega_r = ${referenceVelocity.angular} rad/s`,
    `limits: speed ${limit(limits.speed, 'm/s')}, turn rate ${limit(limits.turnRate, 'rad/s')}, acceleration ${limit(limits.acceleration, 'm/s^2')}, turn acceleration ${limit(limits.turnAcceleration, 'rad/s^2')}; disturbance ${kind}${disturbed}`,
    `sample time ${experiment.sampleTime} s, horizon ${experiment.horizon} s; tolerance: position ${tolerance.position} m, heading ${tolerance.heading} rad, speed ${limit(tolerance.speed, 'm/s')}, turn rate ${limit(tolerance.turnRate, 'rad/s')}`,
    `weights of J: W ${weights.final.join(' ')}, R ${weights.velocity.join(' ')}, kappa ${weights.penalty}`,
    `J = ${run.cost.total}; t_f = ${run.finalTime} s; ${run.outcome}`,
  ];
}

const postureOf = (/** @type {Posture} */ { x, y, theta }) => `x = ${x} m, y = ${y} m, theta = ${theta} rad`;

/** @param {Run} run @param {Stability} stability Of the same run. @param {Origin} origin */
export const driveCsv = (run, stability, origin) =>
  csv(origin, [
    ['t (s)', run.time],
    ['x (m)', run.x],
    ['y (m)', run.y],
    ['theta (rad)', run.theta],
    ['v (m/s)', run.linear],
    ['omega (rad/s)', run.angular],
    ['v commanded (m/s)', run.commandLinear],
    ['omega commanded (rad/s)', run.commandAngular],
    ['x_e (m)', stability.errorX],
    ['y_e (m)', stability.errorY],
    ['theta_e (rad)', stability.errorTheta],
    ['V (m^2)', stability.lyapunov],
    ['dV/dt promised on x_e (m^2/s)', stability.promisedX],
    ['dV/dt promised on y_e (m^2/s)', stability.promisedY],
    ['dV/dt promised on theta_e (m^2/s)', stability.promisedTheta],
    ['dV/dt (m^2/s)', stability.rate],
  ]);

/** @param {Origin} origin @param {readonly Column[]} columns As long as each other. */
function csv(origin, columns) {
  const rows = Array.from(columns[0][1], (_, i) => columns.map(([, values]) => values[i]));
  const lines = [columns.map(([head]) => head), ...rows].map((cells) => cells.join(','));
  return [...origin.map((line) => `# ${line}`), ...lines].map((line) => `${line}\r\n`).join('');
}
