// What is drawn: the newest state of which everything is there, its drives and the part that is open.
/** @import { Scene, Seen } from './scene.js' */
/** @import { State } from './state.js' */
/** @import { Store } from './store.js' */

/** @param {Store} store @param {{ of: (state: State) => Seen }} sight @param {(state: State) => boolean} isComing Whether what is open is on its way, and what was open stays meanwhile. */
export function createBehind(store, sight, isComing) {
  /** What was seen last. @type {Pick<Seen, 'state' | 'scene'> | null} */
  let last = null;
  /** `state`: that of which everything is there; `now`: what is asked for. @returns {{ now: State, state: State, scene: Scene, isBehind: boolean }} */
  return () => {
    const now = store.get();
    const seen = sight.of(now);
    const isHeld = last !== null && isComing(now);
    if (!last || !isHeld) last = seen;
    const isBehind = isHeld || seen.isComputing;
    const { size, theme, message, evolving } = now;
    // What was open and only stays has its own clock.
    const { robot } = isHeld ? last.state : now;
    const state = isBehind ? { ...last.state, robot, size, theme, message, evolving } : now;
    return { now, state, scene: last.scene, isBehind };
  };
}
