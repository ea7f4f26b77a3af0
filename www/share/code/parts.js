// What the controller says in every language: its numbers with their names, and its comments.
/** @import { Posture } from '../../core/engine.js' */
/** @import { Controller } from './controller.js' */
import { comment, literal } from './text.js';

/** @typedef {typeof import('./words/en.js')} Words */
/** Numbers that stand together, of which those that are null are left out, and what is said of them. @typedef {readonly [names: readonly string[], values: readonly (number | null)[], about: string]} Group */
/** A line of the program, and the comment beside it. @typedef {[text: string, about: string]} Line */
/**
 * How a language writes what all of them have.
 * @typedef {object} Syntax
 * @property {string} mark Before each line of a comment.
 * @property {string} infinity
 * @property {(name: string, numbers: readonly string[]) => string} posture
 * @property {(names: readonly string[], numbers: readonly string[]) => string} numbers One or several, each with its name.
 */
/** What a program is put together from. @typedef {ReturnType<typeof piecesOf>} Pieces */

/** What the law divides by is never smaller: the core's SMALLEST_DIVISOR. */
export const smallestDivisor = 1e-6;

/** @param {Controller} controller @param {Words['comments']} words @param {Syntax} syntax @param {string} run How the program is run. */
export function piecesOf(controller, words, { mark, infinity, posture, numbers }, run) {
  const { experiment, page, start } = controller;
  const { law, goal, limits } = experiment;
  const number = (/** @type {number} */ value) => literal(value, infinity);
  /** @param {string} name @param {Posture} pose */
  const postureOf = (name, { x, y, theta }) => posture(name, [x, y, theta].map(number));
  /** @param {Group} group @returns {Line[]} */
  const lineOf = ([names, values, about]) => {
    const there = names.filter((_, i) => values[i] !== null);
    const given = values.filter((value) => value !== null);
    return there.length > 0 ? [[numbers(there, given.map(number)), about]] : [];
  };
  return {
    ...controller,
    isPaper: law === 'shim-kim',
    limits,
    isLimited: Object.values(limits).some((limit) => limit !== null),
    head: headOf(controller, words, run)
      .map((text) => comment(text, mark))
      .join('\n'),
    /** The numbers of command(). */
    control: controlGroups(controller, words).flatMap(lineOf),
    /** @type {Line[]} */
    ends: [
      [postureOf('START', start), words.start],
      [postureOf('GOAL', goal), words.goal],
    ],
    /** The other numbers of the drive that the program makes. */
    drive: driveGroups(controller, words).flatMap(lineOf),
    /** What the page says of it, in the order of the rows. */
    said: [page.time, page.cost, page.pose.x, page.pose.y, page.pose.theta].map(number),
  };
}

/** @param {Controller} controller @param {Words['comments']} words @returns {Group[]} */
function controlGroups({ gains, experiment }, words) {
  const { law, referenceVelocity, sampleTime, limits } = experiment;
  const { speed, turnRate, acceleration, turnAcceleration } = limits;
  return [
    [['KX', 'KY', 'KTHETA'], gains, words.gains[law]],
    [['V_R', 'W_R'], [referenceVelocity.linear, referenceVelocity.angular], words.referenceVelocity],
    [['DT'], [sampleTime], words.sampleTime],
    [['SPEED', 'TURN_RATE'], [speed, turnRate], words.largestVelocity],
    [['ACCELERATION', 'TURN_ACCELERATION'], [acceleration, turnAcceleration], words.largestChange],
    [['SMALLEST'], [law === 'shim-kim' ? smallestDivisor : null], words.smallest],
  ];
}

/** @param {Controller} controller @param {Words['comments']} words @returns {Group[]} */
function driveGroups({ experiment, isTracking }, words) {
  const { horizon, tolerance, weights } = experiment;
  /** @type {Group[]} */
  const parking = [
    [['POSITION', 'HEADING'], [tolerance.position, tolerance.heading], words.tolerance],
    [['SLOW', 'SLOW_TURN'], [tolerance.speed, tolerance.turnRate], words.slow],
  ];
  return [
    [['HORIZON'], [horizon], words.horizon],
    ...(isTracking ? [] : parking),
    [['W_X', 'W_Y', 'W_THETA'], weights.final, words.finalWeights],
    [['R_V', 'R_W'], weights.velocity, words.velocityWeights],
    [['PENALTY'], [weights.penalty], words.penalty],
  ];
}

/** What else must be so for a robot to be parked: its velocity is no larger. @param {Pieces} pieces @param {{ and: string, abs: string, v: string, w: string, of?: string }} language How it says that. */
export function slowly({ experiment: { tolerance } }, { and, abs, v, w, of = '' }) {
  const speed = tolerance.speed === null ? '' : ` ${and} ${abs}(${v}) <= ${of}SLOW`;
  return tolerance.turnRate === null ? speed : `${speed} ${and} ${abs}(${w}) <= ${of}SLOW_TURN`;
}

/** What is said first. @param {Controller} controller @param {Words['comments']} words @param {string} run */
function headOf({ experiment, version, link, isDisturbed, isSteady, page, isTracking }, words, run) {
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
