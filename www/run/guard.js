// What the controls may do in an exercise. Links, files and the page around a figure are not bound by it.
/** @import { Actions } from './actions/actions.js' */
/** @import { Group } from './exercise.js' */
/** @import { State } from './state.js' */
/** @import { RunStore } from './store.js' */
import { shownExercise, wayOf } from './exercise.js';

/** The group that an action belongs to, whichever control asks for it: a press on a map chooses gains as a slider does. A free one changes only what is seen, or is the program's own. @type {Readonly<Record<keyof Actions, Group | 'free'>>} */
export const groupOf = {
  slideGain: 'gains',
  typeGain: 'gains',
  driveGains: 'gains',
  chooseDriver: 'drives',
  movePosture: 'postures',
  restorePostures: 'postures',
  tryStart: 'postures',
  evolve: 'run',
  forward: 'run',
  showGeneration: 'run',
  oneBack: 'run',
  oneGeneration: 'run',
  pauseEvolution: 'run',
  toggleEvolution: 'run',
  reset: 'run',
  setPace: 'run',
  setUntil: 'run',
  newSeed: 'seed',
  useSeed: 'seed',
  showSeed: 'seed',
  togglePlay: 'clock',
  scrub: 'clock',
  setSpeed: 'clock',
  choosePreset: 'settings',
  changeSetting: 'settings',
  refuseSetting: 'settings',
  backToPreset: 'settings',
  openSettings: 'settings',
  tryDisturbance: 'settings',
  openPage: 'parts',
  share: 'share',
  togglePin: 'free',
  renamePin: 'free',
  unpin: 'free',
  advance: 'free',
  driveAgain: 'free',
  standAt: 'free',
  backToExercise: 'free',
  undo: 'free',
  redo: 'free',
  postureOf: 'free',
  releasePosture: 'free',
  releaseSetting: 'free',
  stopComputing: 'free',
  whenIdle: 'free',
  openLinked: 'free',
  makeExercise: 'free',
  setWho: 'free',
  say: 'free',
  setSize: 'free',
  changeTheme: 'free',
};

/** @param {Pick<State, 'exercise' | 'maker'>} state @param {Group} group */
export const isFree = (state, group) => wayOf(shownExercise(state), group) === 'free';

/** What is computed can be stopped, but an exercise begins where its link says, unless one may run it on. @param {State} state */
export const canStop = (state) => !state.catchingUp || isFree(state, 'run');

/** What an action obeys besides, for what it is given. @param {keyof Actions} name @param {unknown} first @returns {readonly Group[]} */
function moreOf(name, first) {
  if (name === 'chooseDriver') return String(first).startsWith('paper-') ? ['paper'] : [];
  if (name === 'backToPreset') return ['postures', 'seed'];
  if (name !== 'changeSetting') return [];
  if (/^(?:starts|goal)\b/.test(String(first))) return ['postures'];
  return first === 'evolution.seed' ? ['seed'] : [];
}

/** What controls of other groups do by the way, and do without where it is locked. @type {readonly (keyof Actions)[]} */
const byTheWay = ['pauseEvolution'];

/** The actions as the controls have them: what is locked or hidden does nothing but say so. @param {Actions} actions @param {RunStore} store @returns {Actions} */
export function guarded(actions, store) {
  /** @param {keyof Actions} name @param {unknown[]} given */
  const mayDo = (name, [first]) => {
    const state = store.get();
    const group = groupOf[name];
    return [group, ...moreOf(name, first)].every((one) => one === 'free' || isFree(state, one));
  };
  const entries = Object.entries(actions).map(([name, act]) => [
    name,
    (/** @type {any[]} */ ...given) => {
      if (mayDo(/** @type {keyof Actions} */ (name), given))
        return /** @type {(...given: any[]) => unknown} */ (act)(...given);
      if (!byTheWay.includes(/** @type {keyof Actions} */ (name)))
        store.update({ refusals: store.get().refusals + 1 });
    },
  ]);
  return /** @type {Actions} */ (Object.fromEntries(entries));
}
