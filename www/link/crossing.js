// What a page that loads itself again, for another language or for a part that could not be loaded, takes along beside the link: how
// far evolution has come, whether it goes on, how fast and until when, an exercise in the making, and what parts have found.
/** @import { Exercise } from '../run/exercise.js' */
/** @import { Opened } from '../run/actions/page.js' */
/** @import { State } from '../run/state.js' */
/** @import { Slice } from '../run/store.js' */
import { isEmpty } from '../run/exercise.js';

/** @typedef {Pick<State, 'pace' | 'until' | 'speed'> & { draft: Exercise }} Kept What no link says, and nobody has taken back. */
/** @typedef {{ newest: number, evolving: boolean, kept: Kept, parts: Record<string, object> }} Crossing */

/** Lays it beside the address. @param {State} state @param {readonly Slice<any>[]} slices */
export function takeAlong(state, slices) {
  const { pace, until, speed, maker, catchingUp } = state;
  /** @type {Crossing} */
  const crossing = {
    newest: catchingUp?.newest ?? state.history.length - 1,
    evolving: state.evolving && !catchingUp,
    kept: { pace, until, speed, draft: maker.draft },
    parts: Object.fromEntries(slices.map((slice) => [slice.name, slice.lasting(state)])),
  };
  try {
    history.replaceState({ crossing }, '');
  } catch {
    // A browser that keeps nothing so large has the link.
  }
}

/** Takes it up, once. @param {Opened} opened @returns {{ opened: Opened, newest: number, evolving: boolean, kept: Kept | null }} */
export function takeUp(opened) {
  /** @type {Crossing | undefined} */
  const crossing = history.state?.crossing;
  if (!crossing) return { opened, newest: opened.generation, evolving: false, kept: null };
  history.replaceState(null, '');
  const parts = { ...opened.parts };
  for (const [name, found] of Object.entries(crossing.parts)) parts[name] = { ...parts[name], ...found };
  // In an exercise the link counts the drives that were made, which would count once more.
  const newest = isEmpty(opened.exercise) ? Math.max(crossing.newest, opened.generation) : opened.generation;
  return { opened: { ...opened, parts }, newest, evolving: crossing.evolving, kept: crossing.kept };
}
