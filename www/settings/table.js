// The settings of an experiment: the one table from which the panel is built. Names and help are in the words, units and allowed ranges in the core's fields.
/** @import { Experiment } from '../core/engine.js' */
/** @import { SliderRange } from './quantity.js' */
import { methods } from '../core/methods.js';

/** @typedef {import('../words/en/settings.js').GroupName} GroupName */
/** @typedef {{ letter: string, index?: string, colour?: 'x' | 'y' | 'theta' | 'linear' | 'angular' }} Symbol */
/** @typedef {{ path: string, symbol?: Symbol, slider?: SliderRange, isIdle?: (experiment: Experiment) => boolean, first?: number }} Row Idle while it changes nothing; `first`: where a limit that no preset has begins. */

/** @param {string} path @param {Symbol} [symbol] @param {SliderRange} [slider] @param {Row['isIdle']} [isIdle] @param {number} [first] @returns {Row} */
const row = (path, symbol, slider, isIdle, first) => ({ path, symbol, slider, isIdle, first });

/** @param {string} letter @param {string} [index] @param {Symbol['colour']} [colour] @returns {Symbol} */
const symbol = (letter, index, colour) => ({ letter, index, colour });

const weight = { from: 0.01, to: 100, log: true };
const turn = { from: -180, to: 180 };

/** @param {Experiment} experiment */
const isUndisturbed = ({ disturbance }) => disturbance.kind === 'none';
/** @param {Experiment} experiment */
const isWithoutNoise = ({ disturbance }) => disturbance.kind !== 'random';

/** @param {Experiment} experiment */
const isNoEp = ({ evolution }) => evolution.method !== 'ep';
/** Every σ is 0, and stays. @param {Experiment} experiment */
const isNoEpThatMoves = ({ evolution: { method, initialSigma, sigmaFloor } }) =>
  method !== 'ep' || (initialSigma === 0 && sigmaFloor === 0);
/** One parent has nobody to be crossed with, and of two the better stays, whoever chooses. @param {Experiment} experiment */
const isNoEpOfSome = ({ evolution: { method, population } }) => method !== 'ep' || population === 1;
/** @param {Experiment} experiment */
const isWithoutTournament = (experiment) =>
  isNoEpOfSome(experiment) || experiment.evolution.selection !== 'tournament';
/** @param {Experiment} experiment */
const goesPointByPoint = ({ evolution }) => methods[evolution.method].trials !== 'population';
/** @param {Experiment} experiment */
const hasNoStep = ({ evolution }) => methods[evolution.method].sigma === null;

/** @type {Readonly<Record<GroupName, readonly Row[]>>} */
export const table = {
  limits: [
    row('limits.speed', symbol('v', 'max', 'linear'), { from: 0, to: 5, step: 0.05 }),
    row('limits.turnRate', symbol('ω', 'max', 'angular'), { from: 0, to: 720, step: 5 }),
    row('limits.acceleration', symbol('v̇', 'max', 'linear'), { from: 0, to: 20, step: 0.1 }),
    row('limits.turnAcceleration', symbol('ω̇', 'max', 'angular'), { from: 0, to: 3600, step: 20 }),
  ],
  weights: [
    row('weights.final[0]', symbol('W', 'x', 'x'), weight),
    row('weights.final[1]', symbol('W', 'y', 'y'), weight),
    row('weights.final[2]', symbol('W', 'θ', 'theta'), weight),
    row('weights.velocity[0]', symbol('R', 'v', 'linear'), weight),
    row('weights.velocity[1]', symbol('R', 'ω', 'angular'), weight),
    row('weights.penalty', symbol('κ'), { from: 1, to: 100_000, log: true }),
  ],
  task: [
    row('starts[0].x', symbol('x', undefined, 'x')),
    row('starts[0].y', symbol('y', undefined, 'y')),
    row('starts[0].theta', symbol('θ', undefined, 'theta')),
    row('goal.x', symbol('x', 'r', 'x')),
    row('goal.y', symbol('y', 'r', 'y')),
    row('goal.theta', symbol('θ', 'r', 'theta')),
    row('referenceVelocity.linear', symbol('v', 'r', 'linear'), { from: -2, to: 2, step: 0.05 }),
    row('referenceVelocity.angular', symbol('ω', 'r', 'angular'), turn),
  ],
  arrival: [
    row('tolerance.position', undefined, { from: 0.001, to: 1, log: true }),
    row('tolerance.heading', undefined, { from: 0.1, to: 100, log: true }),
    row(
      'tolerance.speed',
      symbol('v', undefined, 'linear'),
      { from: 0.01, to: 10, log: true },
      undefined,
      0.1,
    ),
    row('tolerance.turnRate', symbol('ω', undefined, 'angular'), { from: 0, to: 360 }, undefined, 0.1),
    row('horizon', undefined, { from: 1, to: 30, step: 0.5 }),
    row('sampleTime', symbol('Δt'), { from: 0.001, to: 0.1, log: true }),
  ],
  law: [row('law')],
  disturbance: [
    row('disturbance.kind'),
    row('disturbance.linear', symbol('ε', '1', 'linear'), { from: -2, to: 2, step: 0.02 }, isUndisturbed),
    row('disturbance.angular', symbol('ε', '2', 'angular'), turn, isUndisturbed),
    row('disturbance.seed', undefined, undefined, isWithoutNoise),
  ],
  evolution: [
    row('evolution.population', symbol('N'), { from: 2, to: 100 }, goesPointByPoint),
    row('evolution.opponents', symbol('q'), { from: 1, to: 40 }, isWithoutTournament),
    row('evolution.seed'),
    row('evolution.initialRange[0]'),
    row('evolution.initialRange[1]'),
    row('evolution.initialSigma', symbol('σ'), { from: 0.01, to: 10, log: true }, hasNoStep),
  ],
  method: [
    row('evolution.method'),
    row('evolution.belowZero'),
    row('evolution.step', undefined, undefined, isNoEpThatMoves),
    row('evolution.adaptation', undefined, { from: 0, to: 3, step: 0.05 }, isNoEpThatMoves),
    row('evolution.sigmaFloor', symbol('σ', 'min'), { from: 0, to: 1, step: 0.01 }, isNoEp),
    row('evolution.selection', undefined, undefined, isNoEpOfSome),
    row('evolution.crossover', undefined, { from: 0, to: 1, step: 0.05 }, isNoEpOfSome),
  ],
};

export const rows = Object.values(table).flat();
