// Of the lab, what is the same in every language.

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
