// What the methods have that not all of them have.
/** @import { Experiment } from '../../pkg/ep_locomotion.js' */

/** Whether its robots have a step size σ; of the others the core's says nothing. @param {Experiment['evolution']['method']} method */
export const hasSigmas = (method) => !['random', 'de', 'nelder-mead'].includes(method);
