// J as it is paid along a run.
/** @import { Run } from './engine.js' */

/** Time, path and energy until sample `i`; what is due at the end is not yet in it. @param {Run} run @param {number} i */
export const paidAt = ({ time, pathCost, energyCost }, i) => time[i] + pathCost[i] + energyCost[i];

/** The same, and all of J at the last sample. @param {Run} run @param {number} i */
export const paidUntil = (run, i) => (i === run.time.length - 1 ? run.cost.total : paidAt(run, i));
