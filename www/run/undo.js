// What one can go back to, one for each gesture: experiments, and gains by hand that gave way to others.
/** @import { State } from './state.js' */

/** @typedef {Pick<State, 'driver' | 'handGains' | 'found'>} Hand */
/** `hand`: where the step is one of gains. @typedef {Pick<State, 'experiment' | 'preset'> & { hand?: Hand }} Version */
/** @typedef {{ past: readonly Version[], future: readonly Version[], held?: readonly Version[] }} Versions The nearest is the last of the past, the first of the future; `held`: the future before the last change, for a drag that comes back. */

const most = 200;

/** @type {Versions} */
export const noVersions = { past: [], future: [] };

/** @param {State} state @returns {Version} */
const now = ({ experiment, preset }) => ({ experiment, preset });

/** As a step over a version finds it. @param {State} state @param {Version} version @returns {Version} */
const counterpart = (state, { hand }) => (hand ? withHand(state) : now(state));

/** @param {State} state @returns {Version} */
const withHand = ({ experiment, preset, driver, handGains, found }) => ({
  experiment,
  preset,
  hand: { driver, handGains, found },
});

/** @param {Version | undefined} a @param {Version} b */
const isSame = (a, b) => JSON.stringify(a) === JSON.stringify(b);

/** Whether a version is of the experiment that is there. @param {State} state @param {Version} version */
export const isOfNow = (state, { experiment, preset }) => isSame({ experiment, preset }, now(state));

/** Before others' gains take the place of those by hand. @param {State} before @returns {Versions} */
export const afterHand = (before) => ({
  past: [...before.versions.past, withHand(before)].slice(-most),
  future: [],
});

/** After a change; all changes of one drag are one. @param {State} before @param {Version} after @returns {Versions} */
export function afterChange(before, after) {
  const { versions, dragging } = before;
  if (dragging || isSame(now(before), after)) return versions;
  return { past: [...versions.past, now(before)].slice(-most), future: [], held: versions.future };
}

/** After a drag, which may have come back to where it began. @param {State} state @returns {Versions} */
export function afterDrag(state) {
  const { past, future, held = future } = state.versions;
  return isSame(past.at(-1), now(state)) ? { past: past.slice(0, -1), future: held } : { past, future };
}

/** @param {State} state @returns {{ version: Version, versions: Versions } | null} */
export function undone(state) {
  const { past, future } = state.versions;
  const version = past.at(-1);
  return version
    ? { version, versions: { past: past.slice(0, -1), future: [counterpart(state, version), ...future] } }
    : null;
}

/** @param {State} state @returns {{ version: Version, versions: Versions } | null} */
export function redone(state) {
  const [version, ...future] = state.versions.future;
  return version
    ? { version, versions: { past: [...state.versions.past, counterpart(state, version)], future } }
    : null;
}
