// What became of one robot, from the last sample of its drive.
/** @import { Engine, Experiment, Posture, Triple } from '../../../core/engine.js' */
import { lawTerms } from '../../../core/rules.js';
import { lab } from '../../../words/index.js';

/** `ahead`, `aside` in metres and `degrees` are 0 where they are within the tolerance; `asks`: what the gain of the largest of them asks for. @typedef {{ seconds: number, ahead: number, aside: number, degrees: number, gain: string, asks: { value: number, unit: string }[] }} Missed */

/** @param {Engine} engine @param {Experiment} experiment From its start alone. @param {Triple} gains @returns {Missed | { parkedAfter: number }} */
export function toldOf(engine, experiment, gains) {
  const { arrived, time, error } = engine.samples(experiment, gains).at(-1);
  if (arrived) return { parkedAfter: time };
  const { command } = lawTerms(experiment, gains, error);
  const off = offOf(error, experiment.tolerance);
  const turn = (/** @type {number} */ value) => ({ value, unit: 'rad/s' });
  const speed = (/** @type {number} */ value) => ({ value, unit: 'm/s' });
  const { kx, ky, ktheta } = command;
  const told = (/** @type {number} */ index, /** @type {Missed['asks']} */ asks) => ({
    ...{ seconds: time, ...off },
    ...{ gain: lab.gains[index].name, asks },
  });
  if (off.aside && Math.abs(error.y) >= Math.abs(error.x))
    return told(1, [speed(ky.linear), turn(ky.angular)]);
  return off.ahead ? told(0, [speed(kx.linear), turn(kx.angular)]) : told(2, [turn(ktheta.angular)]);
}

/** @param {Posture} error @param {Experiment['tolerance']} tolerance */
function offOf({ x, y, theta }, { position, heading }) {
  const isFar = Math.hypot(x, y) > position;
  // Of two lengths, the one that alone would be within it says little.
  const far = (/** @type {number} */ length, /** @type {number} */ other) =>
    isFar && (Math.abs(length) > position || Math.abs(length) >= Math.abs(other)) ? length : 0;
  return {
    ahead: far(x, y),
    aside: far(y, x),
    degrees: Math.abs(theta) > heading ? (180 / Math.PI) * theta : 0,
  };
}
