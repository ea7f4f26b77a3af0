// Experiments that one can go back to, one for each gesture.
/** @import { State } from './state.js' */

/** @typedef {Pick<State, 'experiment' | 'preset'>} Version */
/** @typedef {{ past: readonly Version[], future: readonly Version[] }} Versions The nearest is the last of the past, the first of the future. */

const most = 200;

/** @type {Versions} */
export const noVersions = { past: [], future: [] };

/** @param {State} state @returns {Version} */
const now = ({ experiment, preset }) => ({ experiment, preset });

/** @param {Version | undefined} a @param {Version} b */
const isSame = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** After a change; all changes of one drag are one. @param {State} before @param {Version} after @returns {Versions} */
export function afterChange(before, after) {
  const { versions, dragging } = before;
  if (dragging || isSame(now(before), after)) return versions;
  return { past: [...versions.past, now(before)].slice(-most), future: [] };
}

/** After a drag, which may have come back to where it began. @param {State} state @returns {Versions} */
export function afterDrag(state) {
  const { past, future } = state.versions;
  return isSame(past.at(-1), now(state)) ? { past: past.slice(0, -1), future } : state.versions;
}

/** @param {State} state @returns {{ version: Version, versions: Versions } | null} */
export function undone(state) {
  const { past, future } = state.versions;
  const version = past.at(-1);
  return version ? { version, versions: { past: past.slice(0, -1), future: [now(state), ...future] } } : null;
}

/** @param {State} state @returns {{ version: Version, versions: Versions } | null} */
export function redone(state) {
  const [version, ...future] = state.versions.future;
  return version ? { version, versions: { past: [...state.versions.past, now(state)], future } } : null;
}
