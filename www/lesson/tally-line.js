// The best by hand so far, in one line.
import { create, write } from '../kit/elements.js';
import { progressSlice } from './state.js';

/** @import { Block, Tools } from './page.js' */
/** @import { Tally } from './state.js' */

/** @param {Tools} _tools @param {{ tally: (tally: Tally) => string }} words @returns {Block} */
export function createTallyLine(_tools, words) {
  const element = create('p', 'tally');
  element.id = 'tally';
  return { element, draw: ({ state }) => write(element, words.tally(progressSlice.of(state).tally)) };
}
