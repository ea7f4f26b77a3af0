// What Generation keeps in the state.
import { createSlice } from '../../run/store.js';

export const phases = /** @type {const} */ ([
  'parents',
  'mutation',
  'drive',
  'tournament',
  'ranking',
  'survivors',
]);

/** @typedef {typeof phases[number]} Phase */

/** @typedef {{ phase: Phase, chosen: number | null }} GenerationState The number of the chosen one in the record; null: the luckiest survivor, or the best offspring. */

export const generationSlice = createSlice(
  'generation',
  /** @type {GenerationState} */ ({ phase: 'parents', chosen: null }),
);

/** Whether it is no evolutionary programming. @param {import('../../core/engine.js').GenerationRecord} record */
export const isOtherSearch = ({ mutations, offspring }) => offspring.length > 0 && mutations.length === 0;
