// The best by hand so far, and what it has beaten.
import { create, write } from '../../kit/elements.js';
import { lowestOf } from './duel.js';
import { marksOfDrive } from './marks.js';
import { progressSlice } from '../state.js';
import { tallyOf } from './tally.js';
import shared from '../words/index.js';

/** @import { Block, Live, Tools } from '../page.js' */
/** @import { Tally } from '../state.js' */

/** @param {Tools} _tools @param {{ tally: (tally: Tally) => string }} words @returns {Block} */
export function createTallyLine(_tools, words) {
  const best = create('p', '');
  const beaten = create('p', { id: 'tally-beaten' });
  const element = create('div', { id: 'tally', class: 'tally', role: 'status' }, best, beaten);
  return {
    element,
    draw(/** @type {Live} */ live) {
      const tally = tallyOf(progressSlice.of(live.state).tallies, live.scene.experiment);
      write(best, words.tally(tally));
      const lowest = lowestOf(tally.costs);
      write(beaten, shared.beaten(marksOfDrive(live).filter(({ cost }) => lowest < cost)));
    },
  };
}
