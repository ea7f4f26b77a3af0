// Every word of the pinned runs.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Driver } from '../common/kinds.js' */
import { foundName } from './lab.js';
import { fixed } from './numbers.js';

export * from '../common/pins.js';

export const pinThis = 'Pin this run';
export const unpinThis = 'Unpin this run';
/** @param {string} name */
export const pinnedAs = (name) => `pinned as “${name}”`;
export const noRoom = 'Four runs are pinned: unpin one first.';

/** @param {Driver} driver @param {{ generation: number, seed: number, gains: Triple, found: import('../common/kinds.js').Found }} of */
export const pinName = (driver, { generation, seed, gains, found }) =>
  ({
    evolved: `best of generation ${generation}, seed ${seed}`,
    hand: `${foundName[found]} ${gains.map((gain) => fixed(gain, 1)).join(', ')}`,
    'paper-ep': 'paper’s EP',
    'paper-arbitrary': 'paper’s arbitrary',
  })[driver];
