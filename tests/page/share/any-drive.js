// Drives of every kind, to try programs on.
/** @import { Triple } from '../../../www/core/engine.js' */
/** @import { Experiment } from '../harness/core.js' */
import { experiment } from '../harness/core.js';

/** Numbers in [0, 1) that are the same each time. @param {number} seed */
export function createChance(seed) {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

/** Any drive at all: both laws, every limit there or not, goals at rest and moving. @param {() => number} chance @returns {[Experiment, Triple]} */
export function anyDrive(chance) {
  const among = (/** @type {number} */ low, /** @type {number} */ high) => low + (high - low) * chance();
  const often = (/** @type {number} */ share) => chance() < share;
  const posture = () => ({ x: among(-3, 3), y: among(-3, 3), theta: among(-4, 4) });
  const limit = (/** @type {number} */ low, /** @type {number} */ high) =>
    often(0.85) ? among(low, high) : null;
  const from = experiment({
    law: often(0.8) ? 'shim-kim' : 'kanayama',
    starts: [posture()],
    goal: posture(),
    referenceVelocity: often(0.25)
      ? { linear: among(-1, 1), angular: among(-1, 1) }
      : { linear: 0, angular: 0 },
    sampleTime: often(0.5) ? 0.01 : among(0.003, 0.03),
    horizon: among(1, 12),
    limits: {
      speed: limit(0.5, 3),
      turnRate: limit(1, 8),
      acceleration: often(0.5) ? among(2, 20) : null,
      turnAcceleration: often(0.5) ? among(5, 60) : null,
    },
    tolerance: {
      position: among(0.01, 0.2),
      heading: among(0.01, 0.2),
      speed: often(0.3) ? among(0.02, 1) : null,
      turnRate: often(0.3) ? among(0.05, 3) : null,
    },
    weights: {
      final: [among(0, 3), among(0, 3), among(0, 3)],
      velocity: [among(0, 2), among(0, 2)],
      penalty: among(0, 1000),
    },
  });
  return [from, [among(-0.2, 10), among(-0.05, 10), among(-0.2, 10)]];
}
