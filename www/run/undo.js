// What one can go back to, one for each gesture: experiments with their runs, and gains by hand that gave way to others.
/** @import { State } from './state.js' */
import { caughtUp, evolvedOf } from './state.js';

/** @typedef {Pick<State, 'driver' | 'handGains' | 'found'>} Hand */
/** How far a run had come: its last generation, the one that was shown, up to which it had driven, and how many times, and as what it had begun. @typedef {{ newest: number, generation: number, counted: number, evolved: number, restart: State['restart'] }} Reached */
/** `hand`: where the step is one of gains. @typedef {Pick<State, 'experiment' | 'preset'> & { reached: Reached, hand?: Hand }} Version */
/** @typedef {{ past: readonly Version[], future: readonly Version[], held?: readonly Version[] }} Versions The nearest is the last of the past, the first of the future; `held`: the future before the last change, for a drag that comes back. */

const most = 200;

/** @type {Versions} */
export const noVersions = { past: [], future: [] };

/** @param {State} state @returns {Reached} */
function reachedBy(state) {
  const { computing, history, work, catchingUp, restart } = state;
  // What was asked for has not begun.
  if (computing?.next)
    return computing.next.reached ?? { newest: 0, generation: 0, counted: 0, evolved: 0, restart };
  const newest = catchingUp?.newest ?? history.length - 1;
  const { generation } = caughtUp(state);
  const counted = Math.max(history.length - 1, work.counted);
  return { newest, generation, counted, evolved: evolvedOf({ history, work }), restart };
}

/** @param {State} state @returns {Version} */
const now = (state) => ({ experiment: state.experiment, preset: state.preset, reached: reachedBy(state) });

/** As a step over a version finds it. @param {State} state @param {Version} version @returns {Version} */
const counterpart = (state, { hand }) => (hand ? withHand(state) : now(state));

/** @param {State} state @returns {Version} */
const withHand = (state) => ({
  ...now(state),
  hand: { driver: state.driver, handGains: state.handGains, found: state.found },
});

/** Whether two are of the same experiment. @param {Pick<State, 'experiment' | 'preset'>} a @param {Pick<State, 'experiment' | 'preset'>} b */
export const isSame = (a, b) =>
  a.preset === b.preset && JSON.stringify(a.experiment) === JSON.stringify(b.experiment);

/** Before others' gains take the place of those by hand. @param {State} before @returns {Versions} */
export const afterHand = (before) => ({
  past: [...before.versions.past, withHand(before)].slice(-most),
  future: [],
});

/** After a change; all changes of one drag are one. @param {State} before @param {Pick<State, 'experiment' | 'preset'>} after @returns {Versions} */
export function afterChange(before, after) {
  const { versions, dragging } = before;
  if (dragging || isSame(before, after)) return versions;
  return { past: [...versions.past, now(before)].slice(-most), future: [], held: versions.future };
}

/** What a drag has come back to, if it has. @param {State} state @returns {Version | null} */
export function cameBackTo(state) {
  const last = state.versions.past.at(-1);
  return last && !last.hand && isSame(last, state) ? last : null;
}

/** After a drag, which may have come back to where it began. @param {State} state @returns {Versions} */
export function afterDrag(state) {
  const { past, future, held = future } = state.versions;
  return cameBackTo(state) ? { past: past.slice(0, -1), future: held } : { past, future };
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
