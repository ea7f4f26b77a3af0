// The way from the best gains by hand to evolution's.
/** @import { Triple } from '../../../core/engine.js' */
/** @import { Store } from '../../../run/store.js' */
/** @import { ParkState } from '../state.js' */
import { filmOf, later } from '../film.js';
import { parkSlice } from '../state.js';

/** The best by hand, or where nobody has tried the gains that the sliders have. @param {Pick<ParkState, 'best'>} state @param {Triple} gains */
export const mineOf = ({ best }, gains) => best?.gains ?? gains;

/** Evenly, as the sliders are: from 0 no factor leads away. @param {Triple} from @param {Triple} to @param {number} share @returns {Triple} */
export function gainsBetween(from, to, share) {
  const [kx, ky, ktheta] = from.map((gain, i) => (1 - share) * gain + share * to[i]);
  return [kx, ky, ktheta];
}

/** @param {Store} store @param {ReturnType<typeof import('../task.js').createTask>} task @param {ReturnType<typeof import('../play.js').createPlay>} play */
export const createWalk = (store, task, play) => (/** @type {number} */ share) => {
  const found = parkSlice.of(store.get()).bred.at(-1);
  if (!found) return;
  const gains = gainsBetween(mineOf(parkSlice.of(store.get()), play.gains()), found.gains, share);
  parkSlice.update(store, { between: { share, gains } });
  // At once as they end, so that the count follows the hand.
  play.show(later(filmOf(task.drive([gains])[0], [], 'hand'), Number.POSITIVE_INFINITY));
};
