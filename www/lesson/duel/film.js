// A clock of its own for what is watched beside the words: it runs once, until nothing moves any more, and then stands.
import { isStill } from '../../kit/host.js';

/** @import { Store } from '../../run/store.js' */

/** After a hidden tab no more than this is made up for, in seconds. */
const longestFrame = 0.1;

/** @type {Set<object>} */
const running = new Set();

/** Whether something is still to be seen. */
export const filmRuns = () => running.size > 0;

/** @param {Store} store */
export function createFilm(store) {
  let time = 0;
  let last = Number.NaN;
  let end = 0;
  const film = {
    /** Begins again. @param {number} seconds How long it lasts. */
    begin(seconds) {
      end = seconds;
      last = Number.NaN;
      time = isStill() ? seconds : 0;
      if (time < end) running.add(film);
    },

    /** The time now; while it runs, another frame is asked for. */
    now() {
      if (time >= end) {
        running.delete(film);
        return end;
      }
      const now = performance.now();
      if (!Number.isNaN(last)) time = Math.min(end, time + Math.min(longestFrame, (now - last) / 1000));
      last = now;
      store.redraw();
      return time;
    },

    /** It is no longer watched. */
    leave: () => running.delete(film),

    get isOver() {
      return time >= end;
    },
  };
  return film;
}
