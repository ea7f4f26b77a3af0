// Of the lab, what is the same in every language.
import { sixDigits } from '../numbers.js';

export const speeds = /** @type {const} */ ([
  [0.125, '⅛×'],
  [0.25, '¼×'],
  [0.5, '½×'],
  [1, '1×'],
  [2, '2×'],
  [4, '4×'],
]);

export const costSymbol = 'J';

export const gains = /** @type {const} */ ([
  { id: 'kx', name: 'kx', letter: 'k', index: 'x' },
  { id: 'ky', name: 'ky', letter: 'k', index: 'y' },
  { id: 'ktheta', name: 'kθ', letter: 'k', index: 'θ' },
]);

/** A line that runs above the picture. @param {string} line */
export const above = (line) => `${line} ↑`;

/** @param {number} cost */
export const paidText = (cost) => `J ${sixDigits(cost)}`;
