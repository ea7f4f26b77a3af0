// The core under Node: what tests and the written lesson compute, by the very module that the page is built with.
/** @import { Preset } from '../../pkg/ep_locomotion.js' */
import { readFile } from 'node:fs/promises';
import init, { paper } from '../../pkg/ep_locomotion.js';
import { engineOf } from './direct.js';
import { createJobs } from './jobs.js';

export * from '../../pkg/ep_locomotion.js';

/** @typedef {import('../../pkg/ep_locomotion.js').Experiment} Experiment */
/** @typedef {import('../../pkg/ep_locomotion.js').Gains} Gains */

export const wasm = new URL('../../pkg/ep_locomotion_bg.wasm', import.meta.url);
/** Of the one instance of the core. */
export const { memory } = await init({ module: await readFile(wasm) });

/** In the place of the page's workers, this thread. @type {import('./pool.js').Run} */
const run = async ({ call, parts }) => {
  const job = /** @type {(...args: any[]) => any} */ (jobs[call]);
  return parts.map((part) => (call === 'trials' ? known(part, job) : job(...part)));
};
const jobs = createJobs(() => {});

/** Runs of a contest, by what was asked: several claims rest on the same. @type {Map<string, unknown>} */
const runs = new Map();

/** @param {readonly unknown[]} asked @param {(...args: any[]) => unknown} job */
function known(asked, job) {
  const key = JSON.stringify(asked);
  if (!runs.has(key)) runs.set(key, job(...asked));
  return runs.get(key);
}

/** The page's engine, with an evolution of its own. */
export function createEngine() {
  const pool = { size: 1, run, soon: run, channel: () => ({ run }) };
  return engineOf({ pool: () => pool, lone: () => pool });
}

/** @param {Preset} preset @param {'ep' | 'arbitrary'} method */
export function paperGains(preset, method) {
  const row = paper().find((one) => one.preset === preset && one.method === method);
  if (!row) throw new Error(`the core has no ${method} gains for ${preset}`);
  return row.gains;
}
