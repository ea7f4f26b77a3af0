// Runs that stay on screen to be compared with. Each has a hue, a dash and a mark of its own for as long as it is pinned.
/** @import { Experiment, Triple } from '../core/engine.js' */
/** @import { Difference } from '../words/common/kinds.js' */
import { pins as words } from '../words/index.js';

/** @typedef {{ experiment: Experiment, gains: Triple }} Driven What a run follows from. */
/** @typedef {Driven & { slot: number, name: string }} Pin Plain data; its slot says how it looks. */
/** @typedef {readonly Pin[]} Pins */

/** @type {Pins} */
export const noPins = [];

/** By slot: the colour's token, the dash in pixels, and the mark as a path around (0, 0). */
export const styles = /** @type {const} */ ([
  { token: '--pin-1', dash: [12, 5], mark: 'M-4.5-4.5h9v9h-9z' },
  { token: '--pin-2', dash: [10, 4, 2, 4], mark: 'M0-6 5.6 4.2H-5.6z' },
  { token: '--pin-3', dash: [5, 4], mark: 'M0 6 5.6-4.2H-5.6z' },
  { token: '--pin-4', dash: [10, 3, 2, 3, 2, 3], mark: 'M-2-6h4v4h4v4h-4v4h-4v-4h-4v-4h4z' },
]);

export const isFull = (/** @type {Pins} */ pins) => pins.length === styles.length;

/** @param {Pins} pins @param {Driven} driven @param {string} name @returns {Pins} The same when there is no room. */
export function withPin(pins, { experiment, gains }, name) {
  const slot = styles.findIndex((_, i) => pins.every((pin) => pin.slot !== i));
  if (slot < 0) return pins;
  const pin = { slot, name: unused(pins, name), experiment, gains };
  return [...pins, pin].sort((a, b) => a.slot - b.slot);
}

/** @param {Pins} pins @param {number} slot */
export const withoutPin = (pins, slot) => pins.filter((pin) => pin.slot !== slot);

/** @param {Pins} pins @param {number} slot @param {string} name */
export const renamed = (pins, slot, name) => {
  const others = withoutPin(pins, slot);
  return pins.map((pin) => (pin.slot === slot ? { ...pin, name: unused(others, name) } : pin));
};

/** The pin that shows the very same run, if there is one. @param {Pins} pins @param {Driven} driven */
export const pinOf = (pins, { experiment, gains }) =>
  pins.find((pin) => String(pin.gains) === String(gains) && isSame(pin.experiment, experiment));

/** @param {Experiment} a @param {Experiment} b */
const isSame = (a, b) => a === b || JSON.stringify(a) === JSON.stringify(b);

/** What decides over a drive and its J beside the gains. @param {Experiment} experiment @returns {Record<Difference, unknown>} */
const partsOf = ({ evolution, starts, goal, limits, weights, ...settings }) => ({
  limits,
  goal,
  start: starts[0],
  weights,
  settings,
});

/** What keeps two drives from being compared by their gains alone: `settings` is anything else, or more than one. @param {Experiment} a @param {Experiment} b @returns {Difference | null} */
export function differenceOf(a, b) {
  const [own, other] = [partsOf(a), partsOf(b)];
  const parts = /** @type {Difference[]} */ (Object.keys(own));
  const found = parts.filter((part) => JSON.stringify(own[part]) !== JSON.stringify(other[part]));
  return found.length > 1 ? 'settings' : (found[0] ?? null);
}

/** @param {Pins} pins @param {string} name */
function unused(pins, name) {
  const isTaken = (/** @type {string} */ text) => pins.some((pin) => pin.name === text);
  // In links ~ ends the name.
  const wanted = name.replaceAll('~', '-');
  let text = wanted;
  for (let i = 2; isTaken(text); i += 1) text = words.again(wanted, i);
  return text;
}
