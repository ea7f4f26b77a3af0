// What the map of robustness keeps in the state.
/** @import { Survey } from './request.js' */
import { createSlice } from '../../run/store.js';

/** What a colour means. */
export const quantities = /** @type {const} */ (['share', 'time', 'cost']);

export const halves = /** @type {const} */ ([2, 4, 8]);

export const robustnessSlice = createSlice(
  'robustness',
  {
    /** Metres from the goal to the map's edge. */ half: 4,
    /** @type {typeof quantities[number]} */ quantity: 'share',
    /** Its index; null: all of them together. @type {number | null} */ heading: null,
    /** Metres. @type {{ x: number, y: number } | null} */ cursor: null,
    /** The heading that one points at on the dial. @type {number | null} */ lit: null,
    /** @type {Survey | null} */ survey: null,
    /** The same starts with the gains that are compared. @type {Survey | null} */ rival: null,
    message: '',
  },
  ['cursor', 'lit'],
);

/** @typedef {ReturnType<typeof robustnessSlice.of>} RobustnessState */
