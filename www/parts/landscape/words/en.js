// Every word of the landscape.
/** @import { Run } from '../../../core/engine.js' */
import { costText, grouped, tookText } from '../../../words/en/numbers.js';

export * from './common.js';

export const texts = {
  landscapePicture: 'The landscape of J',
  landscapeTitle: 'Landscape of J',
  landscapeAcross: 'Gain on the horizontal axis',
  landscapeUp: 'Gain on the vertical axis',
  landscapeFollows: 'as driven',
};

export const mapLabel =
  'Landscape of J over two gains. Arrow keys move a cursor, with Shift by larger steps; Enter drives the gains under it.';

/** @param {string} name */
export const thirdLabel = (name) => `${name}, the same at every point`;

/** @param {string} gain */
export const onLogAxis = (gain) => `${gain}, log`;

/** @param {number} drives @param {number} milliseconds */
export const drivesText = (drives, milliseconds) => `${grouped(drives)} drives in ${tookText(milliseconds)}`;

export const computing = 'the robots are driving …';

/** @param {string} message @param {boolean} kept */
export const failed = (message, kept) =>
  `${kept ? 'The landscape is the last that could be computed' : 'This could not be computed'}: ${message}`;

/** @param {string} who Empty for the cursor. @param {string} gains @param {Run} run @param {string} outcome @param {boolean} isOneOfMany J is from the first start, the map from all. */
export const readout = (who, gains, run, outcome, isOneOfMany) =>
  `${who ? `${who}, ` : ''}${gains}: J ${costText(run.cost.total)}${isOneOfMany ? ' from the first start' : ''}, ${outcome}`;

/** At its mark on the map. */
export const lowest = 'lowest';
/** @param {number} points @param {string} gains @param {number} cost */
export const lowestText = (points, gains, cost) =>
  `Lowest of these ${grouped(points)} points: J ${costText(cost)} at ${gains}`;

/** @param {number} count */
export const outside = (count) =>
  count === 1 ? '1 robot of the population lies outside' : `${count} of the population lie outside`;

export const paperEp = 'paper’s EP';
export const paperArbitrary = 'paper’s arbitrary';
export const hand = 'by hand';

/** What is drawn of a method, beside its robots. @type {Readonly<Record<import('../../../core/methods.js').Method, string>>} */
const sketches = {
  ep: '',
  random: '',
  'cma-es':
    'The ellipses are the distribution that these robots were drawn from, at one and at two standard deviations.',
  de: 'The other lines lead to the trials: each begins at a robot and goes by half the difference of two others. Solid: the trial took a place; its difference is dashed.',
  'nelder-mead':
    'The other lines are the simplex. Dashed: to what was tried in the place of its worst corner or, where that was taken, to the corner that went.',
  'one-plus-one-es': 'The other line is the step that was tried.',
  'one-at-a-time': 'The other line is the step that was tried.',
  'finite-differences':
    'The other lines are the steps that were tried: three short ones for the slope, or one down it.',
};
/** Marks that are not in the slice. @param {string} name Of the gain that is on no axis. */
export const paler = (name) => `Paler: other ${name}.`;

/** @type {Partial<typeof sketches>} */
const crosses = { ep: 'Crosses: robots ±σ.', 'one-plus-one-es': 'Cross: robot ±σ.' };

/** @param {import('../../../core/methods.js').Method} method @param {boolean} [isStill] No σ is above 0. */
export const methodSketch = (method, isStill = false) =>
  [
    (!isStill && crosses[method]) || 'Dots: robots.',
    'Line: best so far. Contours: equal J.',
    sketches[method],
  ]
    .filter(Boolean)
    .join(' ');
