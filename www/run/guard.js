// What the controls may do in an exercise. Links, files and the page around a figure are not bound by it.
import { shownExercise, wayOf } from './exercise.js';

/** @typedef {import('./actions.js').Actions} Actions */
/** @typedef {import('./state.js').State} State */
/** @typedef {import('./exercise.js').Group} Group */

/** The group that an action belongs to, whichever control asks for it: a press on a map chooses gains as a slider does. Any other changes only what is seen. @type {Partial<Record<keyof Actions, Group>>} */
const groupOf = {
  slideGain: 'gains',
  typeGain: 'gains',
  driveGains: 'gains',
  chooseDriver: 'drives',
  movePosture: 'postures',
  restorePostures: 'postures',
  tryStart: 'postures',
  forward: 'run',
  showGeneration: 'run',
  oneBack: 'run',
  oneGeneration: 'run',
  toggleEvolution: 'run',
  reset: 'run',
  setPace: 'run',
  setUntil: 'run',
  newSeed: 'seed',
  useSeed: 'seed',
  choosePreset: 'settings',
  changeSetting: 'settings',
  backToPreset: 'settings',
  openSettings: 'settings',
  tryDisturbance: 'settings',
  openPage: 'parts',
};

/** @param {Pick<State, 'exercise' | 'maker'>} state @param {Group} group */
export const isFree = (state, group) => wayOf(shownExercise(state), group) === 'free';

/** The actions as the controls have them: what is locked or hidden does nothing. @param {Actions} actions @param {import('./state.js').Store} store @returns {Actions} */
export function guarded(actions, store) {
  /** @param {string} name @param {unknown[]} given */
  const mayDo = (name, [first]) => {
    const state = store.get();
    const group = groupOf[/** @type {keyof Actions} */ (name)];
    const asksForPaper = name === 'chooseDriver' && String(first).startsWith('paper-');
    return (!group || isFree(state, group)) && (!asksForPaper || isFree(state, 'paper'));
  };
  const entries = Object.entries(actions).map(([name, act]) => [
    name,
    (/** @type {any[]} */ ...given) =>
      mayDo(name, given) ? /** @type {(...given: any[]) => unknown} */ (act)(...given) : undefined,
  ]);
  return /** @type {Actions} */ (Object.fromEntries(entries));
}
