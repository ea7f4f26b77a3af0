// The best by hand so far, in one line.
import { create } from '../kit/elements.js';
import { progressSlice } from './state.js';
import { watch } from '../kit/memo.js';

/** @typedef {import('./state.js').Tally} Tally */

/** @param {import("./page.js").Tools} _tools @param {{ tally: (tally: Tally) => string }} words @returns {import('./page.js').Block} */
export function createTallyLine(_tools, words) {
  const element = create('p', 'tally');
  element.id = 'tally';
  const changed = watch();
  return {
    element,
    draw({ state }) {
      const { tally } = progressSlice.of(state);
      if (changed(tally)) element.textContent = words.tally(tally);
    },
  };
}
