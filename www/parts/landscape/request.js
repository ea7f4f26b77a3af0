// What the landscape shows, and asking the workers for it: coarse while something moves, fine when it rests.
/** @import { Engine, Experiment, PaperResult, Preset, Triple } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
/** @import { LandscapeState } from './state.js' */
import { messageOf } from '../../words/errors.js';
import { threeDigits } from '../../words/numbers.js';
import { gainNames, landscapeSlice } from './state.js';
import { createRefining } from '../../core/refine.js';
import { once, remember } from '../../kit/memo.js';
import { gainsOf } from '../../run/drivers.js';

/** @typedef {'kx' | 'ky' | 'ktheta'} GainName */
/** @typedef {{ gain: GainName, log: boolean }} AxisChoice */
/** @typedef {{ experiment: Experiment, x: AxisChoice, y: AxisChoice, range: readonly [number, number], third: number }} Spec */
/** @typedef {{ spec: Spec, count: number, costs: Float64Array, milliseconds: number }} Landscape */

export const linearRange = {
  'velocity-limits': /** @type {const} */ ([0, 12]),
  'acceleration-limits': /** @type {const} */ ([0, 32]),
};
const logFloor = 0.01;
/** Gains on an axis, from the coarse map that is short to the last. */
export const counts = /** @type {const} */ ([64, 128]);

/** @param {AxisChoice} axis @param {readonly [number, number]} range @returns {[number, number]} */
export const endsOfAxis = ({ log }, [low, high]) => (log ? [logFloor, 10 * high] : [low, high]);

/** The gain at a part of an axis, from 0 to 1. @param {AxisChoice} axis @param {readonly [number, number]} range @param {number} part */
export function gainOn(axis, range, part) {
  const [low, high] = endsOfAxis(axis, range);
  return axis.log ? low * (high / low) ** part : low + (high - low) * part;
}

/** The gain that is on no axis. @param {Pick<LandscapeState, 'x' | 'y'>} landscape */
export const thirdOf = ({ x, y }) => gainNames.findIndex((name) => name !== x.gain && name !== y.gain);

/** All three gains of a point. @param {Pick<Spec, 'x' | 'y' | 'third'>} spec @param {readonly [number, number]} point @returns {Triple} */
export const gainsAt = ({ x, y, third }, [across, up]) =>
  /** @type {[number, number, number]} */ (
    gainNames.map((name) => (name === x.gain ? across : name === y.gain ? up : third))
  );

/** Whether a point is in the slice that the map shows, as far as the gains are written; of others only the place is seen. @param {Pick<Spec, 'x' | 'y' | 'third'>} spec @param {Triple} gains */
export const isInSlice = (spec, gains) => threeDigits(gains[thirdOf(spec)]) === threeDigits(spec.third);

/** The landscape that a state asks for; the same object while nothing that matters has changed. @param {PaperResult[]} paper */
export function createSpec(paper) {
  const spec = remember(
    /** @param {Experiment} experiment @param {Preset} preset @param {AxisChoice} x @param {AxisChoice} y @param {number} third @returns {Spec} */
    (experiment, preset, x, y, third) => ({ experiment, x, y, range: linearRange[preset], third }),
  );
  return (/** @type {State} */ state) => {
    const { x, y, third } = landscapeSlice.of(state);
    const driven = gainsOf(state, state.driver, paper)[thirdOf(landscapeSlice.of(state))];
    return spec(state.experiment, state.preset, x, y, third ?? driven);
  };
}

/** What the core is asked for. @param {Spec} spec @param {number} count */
export function askedOf(spec, count) {
  const axis = (/** @type {AxisChoice} */ choice) => {
    const [from, to] = endsOfAxis(choice, spec.range);
    return { ...choice, from, to, count };
  };
  return { x: axis(spec.x), y: axis(spec.y), gains: gainsAt(spec, [1, 1]) };
}

/** @param {Engine} engine @param {Store} store */
export function createLandscapeRequests(engine, store) {
  const channel = once(() => engine.surveys.channel());
  const { update } = landscapeSlice.at(store);

  return createRefining({
    counts,
    /** @param {Spec} spec @param {number} count @returns {Promise<Landscape>} */
    async compute(spec, count) {
      const began = performance.now();
      const asked = askedOf(spec, count);
      const costs = await engine.surveys.landscape(spec.experiment, asked, { channel: channel() });
      return { spec, count, costs, milliseconds: performance.now() - began };
    },
    onResult: (result) => update({ result, message: '' }),
    onFailure: (error) => update({ message: messageOf(error) }),
  });
}
