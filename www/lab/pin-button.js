// The button that pins the run on screen, beside the choice of who drives.
/** @import { Driven } from '../run/pins.js' */
/** @import { Scene } from '../run/scene.js' */
/** @import { State } from '../run/state.js' */
import { byId, create, write } from '../kit/elements.js';
import { watch } from '../kit/memo.js';
import { gainsOf } from '../run/drivers.js';
import { pins as words } from '../words/index.js';
import { isFull, pinOf } from '../run/pins.js';

/** @param {{ store: import('../run/store.js').Store, actions: import('../run/actions/actions.js').Actions, paper: import('../core/engine.js').PaperResult[] }} parts @param {(state: State) => Scene} sceneOf */
export function createPinButton({ store, actions, paper }, sceneOf) {
  const button = byId('pin');
  const note = byId('pin-note');
  // Both texts stay in the button: a press in which the text is written again is no click in WebKit.
  const [pinText, unpinText] = [words.pinThis, words.unpinThis].map((text) => create('span', '', text));
  button.replaceChildren(pinText, unpinText);
  /** The run on screen. @param {State} state @param {Scene} scene @returns {Driven} */
  const drivenIn = (state, { experiment }) => ({ experiment, gains: gainsOf(state, state.driver, paper) });

  const press = () => {
    const state = store.get();
    const driven = drivenIn(state, sceneOf(state));
    actions.togglePin(driven, nameOf(state, driven));
  };
  button.addEventListener('click', press);

  const changed = watch();
  return {
    /** @param {State} state @param {Scene} scene */
    draw(state, scene) {
      const driven = drivenIn(state, scene);
      const { experiment, gains } = driven;
      if (!changed(state.pins, state.unpinned, experiment, gains)) return;
      const pin = pinOf(state.pins, driven);
      const { unpinned: refused } = state;
      const isRefused = refused !== null && refused.experiment === experiment && refused.gains === gains;
      unpinText.hidden = !pin;
      pinText.hidden = pin !== undefined;
      const said = pin ? words.pinnedAs(pin.name) : isRefused && isFull(state.pins) ? words.noRoom : '';
      write(note, said);
      note.classList.toggle('field-error', !pin && said !== '');
    },
  };
}

/** @param {State} state @param {Driven} driven */
function nameOf({ driver, found, generation }, { experiment, gains }) {
  return words.pinName(driver, { generation, seed: experiment.evolution.seed, gains, found });
}
