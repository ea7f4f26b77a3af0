// Every word of the controller as code.
export * from './common.js';

export const texts = {
  codeHelp:
    'The controller of the drive on screen, to take to a robot, a simulator or a homework: one function, and a main that parks with it and prints its numbers beside the page’s.',
  codeCopy: 'Copy',
  codeSave: 'Save as file',
};

export const languageLegend = 'Programming language';
export const computing = 'The drive is being computed …';
export const copied = 'The code is copied.';
export const notCopied = 'This browser lets no page copy: the code is selected, copy it with the keyboard.';

/** @param {string} file */
export const codeLabel = (file) => `The code of ${file}`;

/** What stands in the code. */
export const comments = {
  head: {
    'shim-kim': 'The posture controller of Kim and Shim (1995) with the gains of one drive.',
    kanayama: 'The rule of Kanayama et al. (1990) with the gains of one drive.',
  },
  origin: (/** @type {string} */ version) => `From ep-locomotion ${version}:`,
  page: (/** @type {number} */ cost, /** @type {string} */ end) =>
    `On the page J = ${cost}; the robot ${end}.`,
  undisturbed: (/** @type {number} */ cost, /** @type {string} */ end) =>
    `Without the disturbance that the page adds, J = ${cost}; the robot ${end}.`,
  ends: {
    arrived: (/** @type {number} */ time) => `parks in ${time} s`,
    horizon: (/** @type {number} */ _time, /** @type {number} */ horizon) =>
      `does not park within ${horizon} s`,
    diverged: () => 'diverges',
    tracking: (/** @type {number} */ _time, /** @type {number} */ horizon) =>
      `follows a goal that moves for ${horizon} s`,
  },
  disturbed: 'This program has no disturbance either, and all numbers here are those without it.',
  unsteady:
    'This drive hangs on the last digits of its numbers: a start moved by a millionth of a micrometre ends differently. So another language or processor may come to other numbers than the page.',
  run: (/** @type {string} */ command) => `To run it: ${command}`,

  gains: {
    'shim-kim': 'kx (1/s), ky (1/(m² s)), kθ (rad/s); lengths in m only: ω has a hidden 1/m²',
    kanayama: 'kx (1/s), ky (rad/m²), kθ (rad/m)',
  },
  referenceVelocity: 'how the goal moves: m/s, rad/s',
  sampleTime: 's from one command to the next',
  largestVelocity: 'limits of velocity: m/s, rad/s',
  largestChange: 'limits of acceleration: m/s², rad/s²',
  smallest: 'never divide by less',
  start: 'x (m), y (m), θ (rad); at rest',
  goal: 'x (m), y (m), θ (rad)',
  horizon: 's; then it is over',
  samples: 'commands until then',
  driveTitle: 'the drive of the page',
  mainOfModule: 'run as a program, not when imported',
  tolerance: 'm, rad: so near is parked',
  slow: 'm/s, rad/s: and no faster',
  finalWeights: 'W, on the last error',
  velocityWeights: 'R, on the velocity',
  penalty: 'κ, on negative gains',
  pageNumbers: 'what the page says: t_f, J, and the last pose',
  float: 'float where the processor has no double: cc -DREAL=float',

  command:
    'The velocity (v, w), in m/s and rad/s, that the robot shall have until the next command: for its pose (x, y, theta), the goal, and the velocity that it had until now, (0, 0) at rest.',
  ros: 'In ROS 2, v is linear.x and w is angular.z of a geometry_msgs/msg/Twist, and all else in it is 0. Publish one every DT seconds; the pose is x, y and yaw of the odometry or of tf, in the frame in which the goal is given.',
  wheels:
    'Two wheels of radius r, with b between them, turn at (v + w b / 2) / r on the right and (v - w b / 2) / r on the left, in rad/s.',
  law: { 'shim-kim': 'the law (5)', kanayama: 'the rule of Kanayama' },
  limits: 'what the motors can do of it: the velocity first, then its change',
  error: {
    'shim-kim': 'The error posture (3): from the robot to the goal, along the axes of the goal.',
    kanayama: 'From the robot to the goal, along the axes of the robot.',
  },
  wrap: 'The same angle, in (-pi, pi].',
  inverse: '1 / s, as if |s| were never less than the smallest divisor.',
  advance: 'The pose one sample later: along an exact arc (2).',
  drive: 'Drives as the page does, and gives t_f, the cost J (9) and the last pose.',
  goalMoves: 'the goal moves as well',
  diverged: 'it has diverged',
  clamp: 'The value, within low and high; NaN stays NaN.',
  handle: 'The controller alone:',
};
