// The tables of a run as files for other programs.
import assert from 'node:assert/strict';
import { driveCsv, driveOrigin, generationsCsv } from '../../../www/share/csv.js';
import { Evolution, experiment, simulate, stability } from '../harness/core.js';
import { test } from '../harness/once.js';

const velocityLimits = experiment('velocity-limits');

test('the tables have units in their headers and every digit of the numbers', () => {
  const evolution = new Evolution(velocityLimits);
  const history = [evolution.statistics()];
  while (history.length < 5) history.push(evolution.step());
  const origin = ['ep-locomotion 0.1.0', 'http://host/#lab'];
  const [first, second, header, ...rows] = generationsCsv({ history, experiment: velocityLimits }, origin)
    .trim()
    .split('\r\n');
  assert.deepEqual([first, second], ['# ep-locomotion 0.1.0', '# http://host/#lab']);
  assert.equal(
    header,
    'generation,drives,J best,J median,J worst,kx (1/s),ky (1/(m^2 s)),ktheta (rad/s),' +
      'mean sigma_x (1/s),mean sigma_y (1/(m^2 s)),mean sigma_theta (rad/s)',
  );
  const kanayama = experiment({ law: 'kanayama' });
  assert.match(
    generationsCsv({ history, experiment: kanayama }, origin),
    /,kx \(1\/s\),ky \(rad\/m\^2\),ktheta \(rad\/m\),/,
  );
  assert.equal(rows.length, 5);
  const { generation, evaluations, best, median, worst, meanSigmas } = history[4];
  assert.deepEqual(rows[4].split(',').map(Number), [
    generation,
    evaluations,
    best.cost,
    median,
    worst,
    ...best.gains,
    ...meanSigmas,
  ]);

  const run = simulate(velocityLimits, [3, 0.1, 5]);
  const v = stability(velocityLimits, [3, 0.1, 5]);
  const drive = driveCsv(run, v, origin).trim().split('\r\n').slice(2);
  assert.deepEqual(drive[0].split(','), [
    ...['t (s)', 'x (m)', 'y (m)', 'theta (rad)', 'v (m/s)', 'omega (rad/s)'],
    ...['v commanded (m/s)', 'omega commanded (rad/s)', 'x_e (m)', 'y_e (m)', 'theta_e (rad)', 'V (m^2)'],
    ...['x_e', 'y_e', 'theta_e'].map((part) => `dV/dt promised on ${part} (m^2/s)`),
    'dV/dt (m^2/s)',
  ]);
  assert.equal(drive.length, run.time.length + 1);
  // At the first the limits cut what is commanded.
  for (const i of [0, run.time.length - 1])
    assert.deepEqual(
      drive[i + 1].split(',').map(Number),
      [
        ...[run.time, run.x, run.y, run.theta],
        ...[run.linear, run.angular, run.commandLinear, run.commandAngular],
        ...[v.errorX, v.errorY, v.errorTheta, v.lyapunov],
        ...[v.promisedX, v.promisedY, v.promisedTheta, v.rate],
      ].map((column) => column[i]),
    );
});

test('the table of a drive says what it follows from, with every digit, in lines that readers of tables skip', () => {
  const from = experiment({
    starts: [
      { x: 0.5, y: 0, theta: 0.27 },
      { x: -1, y: 0, theta: 0 },
    ],
    goal: { x: 1 / 3, y: 2, theta: 0.1 },
    limits: { speed: null },
    referenceVelocity: { linear: 0.11, angular: 0.23 },
    sampleTime: 0.013,
    horizon: 3.7,
    tolerance: { heading: 0.057 },
    weights: { velocity: [0.3, 0.71] },
    disturbance: { kind: 'random', linear: 0.019, angular: 0.083, seed: 4711 },
  });
  const gains = /** @type {[number, number, number]} */ ([Math.PI, 1e-7, 5]);
  const run = simulate(from, gains);
  const lines = driveCsv(run, stability(from, gains), driveOrigin(from, gains, run)).split('\r\n');
  const head = lines.filter((line) => line.startsWith('# ')).join('\n');
  const { weights, tolerance, disturbance } = from;
  for (const value of [
    ...[...gains, from.goal.x, from.limits.turnRate, run.cost.total, run.finalTime],
    ...[from.starts[0].theta, from.referenceVelocity.angular, from.sampleTime, from.horizon],
    ...[tolerance.heading, weights.velocity[1], disturbance.linear, disturbance.angular, disturbance.seed],
  ])
    assert.ok(head.includes(String(value)), `${value} is missing: ${head}`);
  assert.match(
    head,
    /shim-kim; kx = .* 1\/s, ky = .* 1\/\(m\^2 s\), ktheta = 5 rad\/s\n.*\n.*\n.*speed none.*\n.*\n.*\n.*(arrived|horizon)/,
  );
  assert.equal(lines.length, 7 + 1 + run.time.length + 1);
  assert.match(head, /start x = 0\.5 m, .*, the first of 2: of it alone are the drive and its J\n/);
});
