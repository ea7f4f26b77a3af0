// Every word of the pinned drives.
/** @import { Run, Triple } from '../../core/engine.js' */
/** @import { Driver } from '../common/kinds.js' */
import { comparisonText, foundName } from './lab.js';
import { fixed } from './numbers.js';

export * from '../common/pins.js';

export const pinThis = 'Pin this drive';
export const unpinThis = 'Unpin this drive';
/** @param {string} name */
export const pinnedAs = (name) => `pinned as “${name}”`;
export const noRoom = 'Four drives are pinned: unpin one first.';

/** Beside its J. @type {Record<import('../common/kinds.js').Difference, string>} */
const others = {
  limits: 'other limits',
  goal: 'other goal',
  start: 'other start',
  weights: 'other weights',
  settings: 'other settings',
};
/** @param {string} name @param {Run} run @param {import('../common/kinds.js').Difference | null} difference Of its settings from those that drive now. */
export const pinText = (name, run, difference) =>
  comparisonText(name, run) + (difference ? ` (${others[difference]})` : '');

/** @param {Driver} driver @param {{ generation: number, seed: number, gains: Triple, found: import('../common/kinds.js').Found }} of */
export const pinName = (driver, { generation, seed, gains, found }) =>
  ({
    evolved: `best of generation ${generation}, seed ${seed}`,
    hand: `${foundName[found]} ${gains.map((gain) => fixed(gain, 1)).join(', ')}`,
    'paper-ep': 'paper’s EP',
    'paper-arbitrary': 'paper’s arbitrary',
  })[driver];
