// The reference that a run follows: the goal, or a posture that moves.
/** @import { Experiment, Posture, Run } from './engine.js' */

/** Whether robots follow a reference that moves, at which none arrives. @param {Pick<Experiment, 'referenceVelocity'>} experiment */
export const hasMovingReference = ({ referenceVelocity: { linear, angular } }) =>
  linear !== 0 || angular !== 0;

/** Whether it moves. @param {Run} run */
export const isTracking = ({ referenceX: x, referenceY: y, referenceTheta: theta }) =>
  x.length > 1 && (x[1] !== x[0] || y[1] !== y[0] || theta[1] !== theta[0]);

/** Where it comes by, at a few of the samples. @param {Run} run @returns {Posture[]} */
export function stationsOf({ referenceX, referenceY, referenceTheta }) {
  const count = 32;
  const last = referenceX.length - 1;
  return Array.from({ length: count + 1 }, (_, i) => {
    const n = Math.round((i * last) / count);
    return { x: referenceX[n], y: referenceY[n], theta: referenceTheta[n] };
  });
}
