// What the lesson keeps in this tab, which leaves with it.
import { createSlice } from '../run/store.js';

/** @import { Triple } from '../core/engine.js' */
/** @import { Duel } from './duel/duel.js' */

/** A prediction, and once it is known the right one and what is said of it; `said` in which language, if not in that of the page. @typedef {{ choice: number, right: number | null, why: string, said?: string }} Answer */
/** Drives with different gains, in the experiment with this text, the J of each, and the best that arrived, or of which most did. @typedef {{ experiment: string, drives: number, costs: readonly number[], best: { gains: Triple, cost: number } | null, lowest: { gains: Triple, cost: number } | null }} Tally */

/** @type {Tally} */
export const noTally = Object.freeze({ experiment: '', drives: 0, costs: [], best: null, lowest: null });

/** With `tallies` one of each experiment, the last driven first, `sees` whose robots of a contest are in sight, and `lapsed` the question whose run was changed before it was answered. @typedef {{ answers: Record<string, Answer>, lapsed: string | null, tallies: readonly Tally[], duel: Duel | null, sees: 'you' | 'evolution' }} Progress */

/** @type {Readonly<Progress>} */
export const noProgress = { answers: {}, lapsed: null, tallies: [], duel: null, sees: 'you' };

export const progressSlice = createSlice('progress', noProgress);

/** Under which name an answer is kept. @param {{ readonly name: string }} step @param {string} name of a question of it */
export const keyOf = (step, name) => `${step.name}.${name}`;
