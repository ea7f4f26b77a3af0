// What Training keeps in the state.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Evolved, Result, RowName, Spec } from './request.js' */
/** @import { Spread } from './spread.js' */
import { createSlice } from '../../run/store.js';

/**
 * @typedef {object} TrainingState
 * @property {number} generations
 * @property {RowName | null} chosen
 * @property {number | null} progress From 0 to 1; null: nothing is evolved now.
 * @property {boolean} cancelled
 * @property {string} message
 * @property {Evolved | null} evolved
 * @property {Spread | null} spread Of what was evolved, with other seeds.
 * @property {{ spec: Spec, results: Partial<Record<RowName, Result>> } | null} given What was not evolved here.
 * @property {boolean} wanted Somebody asks for the three evolutions of the present experiment.
 * @property {Triple | null} byHand Gains by hand, kept while a row of the table drives.
 */

export const trainingSlice = createSlice(
  'training',
  /** @type {TrainingState} */ ({
    generations: 100,
    chosen: null,
    progress: null,
    cancelled: false,
    message: '',
    evolved: null,
    spread: null,
    given: null,
    wanted: false,
    byHand: null,
  }),
  [],
  ['generations', 'chosen', 'evolved', 'spread', 'byHand'],
);
