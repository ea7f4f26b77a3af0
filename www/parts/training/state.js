// What Training keeps in the state.
/** @import { Triple } from '../../core/engine.js' */
/** @import { Evolved, Result, RowName, Spec } from './request.js' */
/** @import { Spread } from './spread.js' */
import { createSlice } from '../../run/store.js';

/** For how many generations. */
export const lengths = /** @type {const} */ ([50, 100, 200]);

/** The three evolutions, or what was evolved with other seeds. @typedef {'evolved' | 'spread'} Work */

export const trainingSlice = createSlice(
  'training',
  {
    generations: 100,
    /** @type {RowName | null} */ chosen: null,
    /** From 0 to 1; null: nothing is evolved now. @type {number | null} */ progress: null,
    cancelled: false,
    message: '',
    /** @type {Evolved | null} */ evolved: null,
    /** Of what was evolved, with other seeds. @type {Spread | null} */ spread: null,
    /** What was not evolved here. @type {{ spec: Spec, results: Partial<Record<RowName, Result>> } | null} */
    given: null,
    /** What is under way while there is progress. @type {Work} */ begun: 'evolved',
    /** What somebody asks for; the evolutions are those of the present experiment. @type {Work | null} */
    wanted: null,
    /** Gains by hand, kept while a row of the table drives. @type {Triple | null} */ byHand: null,
  },
  ['chosen', 'cancelled'],
  ['chosen', 'evolved', 'spread', 'byHand'],
  ({ wanted, begun, progress }) => ({ wanted: wanted ?? (progress === null ? null : begun) }),
);

/** @typedef {ReturnType<typeof trainingSlice.of>} TrainingState */
