// What the controller says in every language: its numbers with their names, and its comments.
/** @import { Controller } from './controller.js' */
/** @typedef {typeof import('./words/en.js')} Words */
/** Numbers that stand together, and what is said of them. @typedef {readonly [names: readonly string[], values: readonly number[], about: string]} Group */

/** What the law divides by is never smaller: the core's SMALLEST_DIVISOR. */
export const smallestDivisor = 1e-6;

/** The numbers of command(). @param {Controller} controller @param {Words['comments']} words @returns {Group[]} */
export function controlGroups({ gains, experiment }, words) {
  const { law, referenceVelocity, sampleTime, limits } = experiment;
  const { speed, turnRate, acceleration, turnAcceleration } = limits;
  /** @type {[string[], (number | null)[], string][]} */
  const groups = [
    [['KX', 'KY', 'KTHETA'], [...gains], words.gains],
    [['V_R', 'W_R'], [referenceVelocity.linear, referenceVelocity.angular], words.referenceVelocity],
    [['DT'], [sampleTime], words.sampleTime],
    [['SPEED', 'TURN_RATE'], [speed, turnRate], words.largestVelocity],
    [['ACCELERATION', 'TURN_ACCELERATION'], [acceleration, turnAcceleration], words.largestChange],
  ];
  if (law === 'shim-kim') groups.push([['SMALLEST'], [smallestDivisor], words.smallest]);
  return groups.map(withoutNull).filter(([names]) => names.length > 0);
}

/** The numbers of the drive that the program makes. @param {Controller} controller @param {Words['comments']} words @returns {Group[]} */
export function driveGroups({ experiment, isTracking }, words) {
  const { horizon, tolerance, weights } = experiment;
  /** @type {Group[]} */
  const groups = [[['HORIZON'], [horizon], words.horizon]];
  if (!isTracking) {
    groups.push([['POSITION', 'HEADING'], [tolerance.position, tolerance.heading], words.tolerance]);
    const slow = withoutNull([['SLOW', 'SLOW_TURN'], [tolerance.speed, tolerance.turnRate], words.slow]);
    if (slow[0].length > 0) groups.push(slow);
  }
  return [
    ...groups,
    [['W_X', 'W_Y', 'W_THETA'], weights.final, words.finalWeights],
    [['R_V', 'R_W'], weights.velocity, words.velocityWeights],
    [['PENALTY'], [weights.penalty], words.penalty],
  ];
}

/** Which of the limits there are, and whether any is. @param {Controller} controller */
export function limitsOf({ experiment: { limits } }) {
  const { speed, turnRate, acceleration, turnAcceleration } = limits;
  return {
    speed: speed !== null,
    turnRate: turnRate !== null,
    acceleration: acceleration !== null,
    turnAcceleration: turnAcceleration !== null,
    any: [speed, turnRate, acceleration, turnAcceleration].some((limit) => limit !== null),
  };
}

/** What else must be so for a robot to be parked: its velocity is no larger. @param {Controller} controller @param {{ and: string, abs: string, v: string, w: string, of?: string }} language How it says that. */
export function slowly({ experiment: { tolerance } }, { and, abs, v, w, of = '' }) {
  const speed = tolerance.speed === null ? '' : ` ${and} ${abs}(${v}) <= ${of}SLOW`;
  return tolerance.turnRate === null ? speed : `${speed} ${and} ${abs}(${w}) <= ${of}SLOW_TURN`;
}

/** What is said first. @param {Controller} controller @param {Words['comments']} words @param {string} run How the program is run. */
export function headOf({ experiment, version, link, isDisturbed, isSteady, page, isTracking }, words, run) {
  const { law, horizon } = experiment;
  const end = isTracking && page.outcome === 'horizon' ? 'tracking' : page.outcome;
  return [
    words.head[law],
    words.origin(version),
    link,
    words[isDisturbed ? 'undisturbed' : 'page'](
      page.cost,
      words.ends[end](Number(page.time.toPrecision(12)), horizon),
    ),
    ...(isDisturbed ? [words.disturbed] : []),
    ...(isSteady ? [] : [words.unsteady]),
    words.run(run),
  ];
}

/** What is printed at the end, in this order. */
export const rows = /** @type {const} */ (['t_f (s)', 'J', 'x (m)', 'y (m)', 'theta (rad)']);

/** @param {[string[], (number | null)[], string]} group @returns {Group} */
function withoutNull([names, values, about]) {
  const there = names.map((_, i) => i).filter((i) => values[i] !== null);
  return [there.map((i) => names[i]), there.map((i) => Number(values[i])), about];
}
