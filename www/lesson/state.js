// What the lesson keeps in this tab, which leaves with it.
import { createSlice } from '../run/store.js';

/** @import { Triple } from '../core/engine.js' */
/** @import { Duel } from './duel.js' */
/** @import { Answer } from './page.js' */

/** Drives with different gains, in the experiment with this text, the J of each, and the best that arrived. @typedef {{ experiment: string, drives: number, costs: readonly number[], best: { gains: Triple, cost: number } | null }} Tally */

/** @type {Tally} */
export const noTally = Object.freeze({ experiment: '', drives: 0, costs: [], best: null });

/** @typedef {{ answers: Record<string, Answer>, tally: Tally, duel: Duel | null }} Progress */

export const progressSlice = createSlice(
  'progress',
  /** @type {Progress} */ ({ answers: {}, tally: noTally, duel: null }),
);
