// What a step asks its reader to do.
/** @import { Store } from '../../run/store.js' */
/** @import { Quiz } from './quiz.js' */
/** @import { Try } from '../steps.js' */

/** A question. @param {string} name as in the words of the step @param {Quiz} quiz */
export const quiz = (name, quiz) => ({ kind: /** @type {const} */ ('quiz'), name, quiz });

/** @param {readonly Try[]} tries @param {(store: Store) => void} [begins] What a press sets going. */
export const tries = (tries, begins) => ({ kind: /** @type {const} */ ('tries'), tries, begins });
