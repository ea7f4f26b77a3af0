// Drives that are kept beside the one that is seen.
/** @import { Basis } from './basis.js' */
/** @import { Driven } from '../pins.js' */
import { isFull, pinOf, renamed, withoutPin, withPin } from '../pins.js';

/** @param {Basis} basis */
export function createPins({ store }) {
  return {
    /** Pins a run, or takes away its pin. @param {Driven} driven @param {string} name */
    togglePin(driven, name) {
      const { pins } = store.get();
      const pin = pinOf(pins, driven);
      if (pin) store.update({ pins: withoutPin(pins, pin.slot), unpinned: null });
      else if (isFull(pins)) store.update({ unpinned: driven });
      else store.update({ pins: withPin(pins, driven, name), unpinned: null });
    },

    /** @param {number} slot @param {string} name */
    renamePin(slot, name) {
      store.update({ pins: renamed(store.get().pins, slot, name) });
    },

    /** @param {number} slot */
    unpin(slot) {
      store.update({ pins: withoutPin(store.get().pins, slot) });
    },
  };
}
