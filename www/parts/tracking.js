// A reference that moves is followed, and nobody arrives at it.
/** @import { Experiment } from '../core/engine.js' */

/** @param {Pick<Experiment, 'referenceVelocity'>} experiment */
export const isTracking = ({ referenceVelocity: { linear, angular } }) => linear !== 0 || angular !== 0;
