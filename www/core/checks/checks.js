// The list of all checks: pure functions of the core and of the known values. It runs in a worker of the page, and in Node.
/** @import { Check, Core, Golden, Group, Result } from './check.js' */
import { bitChecks } from './bits.js';
import { costChecks } from './cost.js';
import { evolutionChecks } from './evolution.js';
import { motionChecks } from './motion.js';

/** @type {Record<Group, (golden: Golden) => Check[]>} */
const groups = {
  motion: motionChecks,
  cost: costChecks,
  evolution: evolutionChecks,
  bits: bitChecks,
};

/** All checks of a group, one after the other. @param {Core} core @param {Group} group @param {Golden} golden @param {(done: number) => void} [onProgress] @returns {Result[]} */
export function resultsOf(core, group, golden, onProgress) {
  return groups[group](golden).map(({ run, ...named }, i, all) => {
    const result = { ...named, ...run(core) };
    onProgress?.((i + 1) / all.length);
    return result;
  });
}
