// What differs between the methods of search, in one row each: what is the core's own, tests hold equal to what it does.
/** @typedef {import('../../pkg/ep_locomotion.js').Method} Method */
/**
 * @typedef {object} Facts
 * @property {'population' | 1 | null} trials How many robots it tries in each generation; null: that depends on how they fare.
 * @property {'robot' | 'search' | 'first' | null} sigma What steps by σ, each from its place or all; `first`: σ is the first step alone.
 * @property {boolean} pairs Whether each offspring has a parent of its own.
 * @property {boolean} upsets Whether one may stay while a better one falls that it never met.
 * @property {boolean} forgets Whether nothing that was driven before is kept.
 */

/** @type {Readonly<Record<Method, Facts>>} */
export const methods = {
  ep: { trials: 'population', sigma: 'robot', pairs: true, upsets: true, forgets: false },
  random: { trials: 'population', sigma: null, pairs: false, upsets: false, forgets: true },
  de: { trials: 'population', sigma: null, pairs: true, upsets: true, forgets: false },
  'cma-es': { trials: 'population', sigma: 'search', pairs: false, upsets: false, forgets: true },
  'one-plus-one-es': { trials: 1, sigma: 'robot', pairs: true, upsets: false, forgets: false },
  'nelder-mead': { trials: null, sigma: 'first', pairs: false, upsets: false, forgets: false },
  'one-at-a-time': { trials: 1, sigma: 'search', pairs: true, upsets: false, forgets: false },
  'finite-differences': { trials: null, sigma: 'search', pairs: false, upsets: false, forgets: false },
};

/** Whether its robots have a step size σ; of the others the core's says nothing. @param {Method} method */
export const hasSigmas = (method) => ['robot', 'search'].includes(methods[method].sigma ?? '');

/** @param {Method} method */
export const hasPairs = (method) => methods[method].pairs;

/** @param {Method} method */
export const forgets = (method) => methods[method].forgets;
