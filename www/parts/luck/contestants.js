// Who may enter the contest: the search as it is in the lab, the same with one ingredient changed, and its rivals.
/** @import { Experiment } from '../../core/engine.js' */
/** @typedef {Partial<Experiment['evolution']>} Change */
/** @typedef {keyof typeof ingredients} Ingredient */
/** @typedef {keyof typeof rivals} Rival */
/** @typedef {Ingredient | Rival} Contestant */

/** By their names in links. */
export const ingredients = /** @satisfies {Record<string, Change>} */ ({
  cauchy: { step: 'cauchy' },
  fixed: { adaptation: 0 },
  'floor-0.01': { sigmaFloor: 0.01 },
  'floor-0.1': { sigmaFloor: 0.1 },
  truncation: { selection: 'truncation' },
  parent: { selection: 'parent' },
  crossover: { crossover: 0.5 },
  'n-6': { population: 6 },
  'n-100': { population: 100 },
  mirror: { belowZero: 'mirror' },
});

export const rivals = /** @satisfies {Record<string, Change>} */ ({
  random: { method: 'random' },
  de: { method: 'de' },
  'cma-es': { method: 'cma-es' },
  // As many as its authors advise for three variables: 4 + ⌊3 ln 3⌋.
  'cma-es-7': { method: 'cma-es', population: 7 },
  'cma-es-7-mirror': { method: 'cma-es', population: 7, belowZero: 'mirror' },
  'one-plus-one-es': { method: 'one-plus-one-es' },
  'nelder-mead': { method: 'nelder-mead' },
  'one-at-a-time': { method: 'one-at-a-time' },
  // With sliders, which end at 0.
  hand: { method: 'one-at-a-time', belowZero: 'clamp' },
  'finite-differences': { method: 'finite-differences' },
});

/** @type {Readonly<Record<Contestant, Change>>} */
const changes = { ...ingredients, ...rivals };

export const ingredientNames = /** @type {Ingredient[]} */ (Object.keys(ingredients));
export const rivalNames = /** @type {Rival[]} */ (Object.keys(rivals));
export const contestants = /** @type {Contestant[]} */ (Object.keys(changes));

/** Beside the lab's own: as many as there are colours left. */
export const mostOthers = 3;

/** What a contestant runs; null is the lab's own. @param {Experiment} experiment @param {Contestant | null} name @returns {Experiment} */
export const entered = (experiment, name) =>
  name ? { ...experiment, evolution: { ...experiment.evolution, ...changes[name] } } : experiment;
