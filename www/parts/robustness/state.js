// What the map of robustness keeps in the state.
/** @import { Survey } from './request.js' */
import { createSlice } from '../../run/store.js';

/**
 * @typedef {object} RobustnessState
 * @property {number} half Metres from the goal to the map's edge.
 * @property {typeof quantities[number]} quantity
 * @property {number | null} heading Its index; null: all of them together.
 * @property {{ x: number, y: number } | null} cursor Metres.
 * @property {number | null} lit The heading that one points at on the dial.
 * @property {Survey | null} survey
 * @property {Survey | null} rival The same starts with the gains that are compared.
 * @property {string} message
 */

/** What a colour means. */
export const quantities = /** @type {const} */ (['share', 'time', 'cost']);

export const halves = /** @type {const} */ ([2, 4, 8]);

export const robustnessSlice = createSlice(
  'robustness',
  /** @type {RobustnessState} */ ({
    half: 4,
    quantity: 'share',
    heading: null,
    cursor: null,
    lit: null,
    survey: null,
    rival: null,
    message: '',
  }),
  ['cursor', 'lit'],
);
