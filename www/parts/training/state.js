// What Training keeps in the state.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Evolved, Result, RowName, Spec } from './request.js' */
/** @import { Spread } from './spread.js' */
import { createSlice } from '../../run/store.js';

/** For how many generations. */
export const lengths = /** @type {const} */ ([50, 100, 200]);

/** The three evolutions, or what was evolved with other seeds. @typedef {'evolved' | 'spread'} Work */

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
 * @property {Work} begun What is under way while there is progress.
 * @property {Work | null} wanted What somebody asks for; the evolutions are those of the present experiment.
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
    begun: 'evolved',
    wanted: null,
    byHand: null,
  }),
  [],
  ['chosen', 'evolved', 'spread', 'byHand'],
  ({ wanted, begun, progress }) => ({ wanted: wanted ?? (progress === null ? null : begun) }),
);
