// Holds the state. Whoever draws may read it, and keep what is its own in a slice; the run itself only actions write.
/** @import { State } from './state.js' */

/**
 * What the parts of the page get.
 * @typedef {object} Store
 * @property {() => State} get
 * @property {(name: string, slice: unknown) => void} keep Replaces one slice.
 * @property {() => void} redraw Asks for a frame, though nothing of the state has changed.
 */
/** What only actions get. @typedef {Store & { update: (patch: Partial<State>) => void }} RunStore */

/** @param {State} initial @param {() => void} onChange @returns {RunStore} */
export function createStore(initial, onChange) {
  let state = initial;
  /** @param {Partial<State>} patch */
  const update = (patch) => {
    state = { ...state, ...patch };
    onChange();
  };
  return {
    get: () => state,
    keep: (name, slice) => update({ slices: { ...state.slices, [name]: slice } }),
    redraw: onChange,
    update,
  };
}

/**
 * What one part of the page keeps in the state, of which only it knows the type.
 * @template {object} S
 * @param {string} name @param {S} first @param {readonly (keyof S)[]} [passing] What does not outlast the link that is opened next. @param {readonly (keyof S)[]} [lasting] What was found, in no words, which a change of language keeps. @param {(slice: S) => Partial<S>} [asked] What was under way then, asked for anew.
 */
export function createSlice(name, first, passing = [], lasting = [], asked = () => ({})) {
  const of = (/** @type {Pick<State, 'slices'>} */ { slices }) => /** @type {S} */ (slices[name] ?? first);
  const update = (/** @type {Store} */ store, /** @type {Partial<S>} */ patch) =>
    store.keep(name, { ...of(store.get()), ...patch });
  return {
    name,
    first,
    of,
    update,
    /** The slice as it is now, and what changes it, for who has the one store. @param {Store} store */
    at: (store) => ({
      now: () => of(store.get()),
      update: (/** @type {Partial<S>} */ patch) => update(store, patch),
    }),
    /** @param {Pick<State, 'slices'>} state @returns {Partial<S>} */
    lasting: (state) => ({
      .../** @type {Partial<S>} */ (Object.fromEntries(lasting.map((field) => [field, of(state)[field]]))),
      ...asked(of(state)),
    }),
    /** As the next link finds it. @param {Pick<State, 'slices'>} state @param {object} [patch] @returns {object} */
    opened: (state, patch) => ({
      ...of(state),
      ...Object.fromEntries(passing.map((field) => [field, first[field]])),
      ...patch,
    }),
  };
}

/** @template {object} S @typedef {ReturnType<typeof createSlice<S>>} Slice */
