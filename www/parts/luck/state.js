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

export const luckSlice = createSlice(
  'luck',
  {
    /** @type {typeof views[number]} */ view: 'seeds',
    /** Who runs beside the lab's own search. @type {readonly Contestant[]} */
    others: ['truncation', 'fixed', 'de'],
    /** With how many seeds each of them. */ seeds: 51,
    /** For how many drives. */ budget: 4000,
    /** The J that is to be reached; null: a little above the lowest that was found. @type {number | null} */
    target: null,
    targetError: '',
    /** Which picture of the contest is shown. @type {typeof readings[number]} */ reading: 'course',
    /** The budget at which it is read, in drives; null: the whole. @type {number | null} */ until: null,
    /** Had one run only so many seeds; null: all. @type {number | null} */ only: null,
    /** Which of them: the first, or others. */ draw: 0,
    /** @type {Contest | null} */ contest: null,
    contestRuns: false,
    /** Somebody asks for the contest that is set up. */ wanted: false,
    /** Somebody asks for the runs of many seeds. */ seedsWanted: false,
    contestMessage: '',
    /** How many seeds to run next. */ count: 100,
    /** For how many generations. */ generations: 200,
    /** Costs are shown as the logarithm of their distance to the lowest. */ log: false,
    /** What the newest run was begun with. @type {Pick<SeedSurvey, 'experiment' | 'count' | 'generations'> | null} */
    asked: null,
    /** From 0 to 1 while seeds run. @type {number | null} */ progress: null,
    /** While seeds run: those that have run. @type {SeedSurvey | null} */ soFar: null,
    /** @type {SeedSurvey | null} */ result: null,
    /** The index of a run. @type {number | null} */ chosen: null,
    /** The run under the pointer. @type {number | null} */ pointed: null,
    cancelled: false,
    message: '',
  },
  ['targetError', 'reading', 'until', 'only', 'draw', 'contestMessage', 'cancelled', 'message'],
  ['contest', 'result', 'chosen'],
  ({ wanted, contestRuns, seedsWanted, progress }) => ({
    wanted: wanted || contestRuns,
    seedsWanted: seedsWanted || progress !== null,
  }),
);

/** @typedef {ReturnType<typeof luckSlice.of>} LuckState */
