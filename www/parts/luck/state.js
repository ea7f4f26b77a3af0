// What Luck keeps in the state.
/** @import { Contest } from './contest-request.js' */
/** @import { Contestant } from './contestants.js' */
/** @import { SeedSurvey } from './request.js' */
import { createSlice } from '../../run/store.js';

export const views = /** @type {const} */ (['seeds', 'contest']);
/** J over the drives, what of many targets is reached, where the runs end, and in a small frame the table. */
export const readings = /** @type {const} */ (['course', 'targets', 'ends', 'table']);
export const contestSeeds = /** @type {const} */ ([15, 51, 101]);
export const budgets = /** @type {const} */ ([1000, 4000, 20_000]);

/** How many seeds one search runs with, and for how many generations. */
export const counts = /** @type {const} */ ([20, 100, 500]);
export const lengths = /** @type {const} */ ([50, 100, 200]);

/**
 * @typedef {object} LuckState
 * @property {typeof views[number]} view
 * @property {readonly Contestant[]} others Who runs beside the lab's own search.
 * @property {number} seeds With how many seeds each of them.
 * @property {number} budget For how many drives.
 * @property {number | null} target The J that is to be reached; null: a little above the lowest that was found.
 * @property {string} targetError
 * @property {typeof readings[number]} reading Which picture of the contest is shown.
 * @property {number | null} until The budget at which it is read, in drives; null: the whole.
 * @property {number | null} only Had one run only so many seeds; null: all.
 * @property {number} draw Which of them: the first, or others.
 * @property {Contest | null} contest
 * @property {boolean} contestRuns
 * @property {boolean} wanted Somebody asks for the contest that is set up.
 * @property {boolean} seedsWanted Somebody asks for the runs of many seeds.
 * @property {string} contestMessage
 * @property {number} count How many seeds to run next.
 * @property {number} generations For how many generations.
 * @property {boolean} log Costs are shown as the logarithm of their distance to the lowest.
 * @property {number | null} progress From 0 to 1 while seeds run.
 * @property {SeedSurvey | null} soFar While seeds run: those that have run.
 * @property {SeedSurvey | null} result
 * @property {number | null} chosen The index of a run.
 * @property {number | null} pointed The run under the pointer.
 * @property {boolean} cancelled
 * @property {string} message
 */

export const luckSlice = createSlice(
  'luck',
  /** @type {LuckState} */ ({
    view: 'seeds',
    others: ['truncation', 'fixed', 'de'],
    seeds: 51,
    budget: 4000,
    target: null,
    targetError: '',
    reading: 'course',
    until: null,
    only: null,
    draw: 0,
    contest: null,
    contestRuns: false,
    wanted: false,
    seedsWanted: false,
    contestMessage: '',
    count: 100,
    generations: 200,
    log: false,
    progress: null,
    soFar: null,
    result: null,
    chosen: null,
    pointed: null,
    cancelled: false,
    message: '',
  }),
  ['targetError', 'reading', 'until', 'only', 'draw'],
  ['contest', 'result', 'chosen'],
  ({ wanted, contestRuns, seedsWanted, progress }) => ({
    wanted: wanted || contestRuns,
    seedsWanted: seedsWanted || progress !== null,
  }),
);
