// The core in the page: loaded once, for the page and its workers. Everything else receives plain numbers from here.
import init from '../../pkg/ep_locomotion.js';
import { engineOf } from './direct.js';
import { createPool } from './pool.js';
import SurveyWorker from './worker.js?worker';

/** @typedef {import('../../pkg/ep_locomotion.js').ErrorParts} ErrorParts */
/** @typedef {import('../../pkg/ep_locomotion.js').Range} Range */
/** @typedef {import('../../pkg/ep_locomotion.js').RemainingErrors} RemainingErrors */
/** @typedef {import('../../pkg/ep_locomotion.js').Robustness} Robustness */
/** @typedef {import('../../pkg/ep_locomotion.js').SeedRun} SeedRun */
/** @typedef {import('../../pkg/ep_locomotion.js').Trial} Trial */
/** @typedef {import('../../pkg/ep_locomotion.js').Experiment} Experiment */
/** @typedef {import('../../pkg/ep_locomotion.js').PartialExperiment} PartialExperiment */
/** @typedef {import('../../pkg/ep_locomotion.js').Field} Field */
/** @typedef {import('../../pkg/ep_locomotion.js').Individual} Individual */
/** @typedef {import('../../pkg/ep_locomotion.js').PaperResult} PaperResult */
/** @typedef {import('../../pkg/ep_locomotion.js').Posture} Posture */
/** @typedef {import('../../pkg/ep_locomotion.js').Preset} Preset */
/** @typedef {import('../../pkg/ep_locomotion.js').Run} Run */
/** @typedef {import('../../pkg/ep_locomotion.js').Stability} Stability */
/** @typedef {import('../../pkg/ep_locomotion.js').Cost} Cost */
/** @typedef {import('../../pkg/ep_locomotion.js').GenerationRecord} GenerationRecord */
/** @typedef {import('../../pkg/ep_locomotion.js').Sample} Sample */
/** @typedef {import('../../pkg/ep_locomotion.js').Statistics} Statistics */
/** @typedef {readonly [number, number, number]} Triple kx, ky, kθ */

/** @typedef {{ statistics: Statistics, population: Individual[] }} Generation The newest one; its population is best first. */
/** @typedef {import('./samples.js').Samples} Samples */
/** @typedef {ReturnType<typeof engineOf>} Engine */

/** Loads the core. */
export async function createEngine() {
  const module = await compileCore();
  // Not at once: on the main thread some browsers refuse a module as large as this.
  await init({ module });

  /** A worker makes no request of its own: it gets the core from here. */
  function spawn() {
    const worker = new SurveyWorker();
    worker.postMessage({ core: module });
    return worker;
  }

  return engineOf({ pool: () => createPool({ spawn }), lone: () => createPool({ spawn, size: 1 }) });
}

/** What the one file has within. @param {string} data What follows `data:`, of bytes that are packed. */
function unpacked(data) {
  const packed = Uint8Array.from(atob(data.slice(data.indexOf(',') + 1)), (one) => one.charCodeAt(0));
  const bytes = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(bytes).arrayBuffer();
}

/** Compiled once, for the page and its workers. */
async function compileCore() {
  const address = new URL('../../pkg/ep_locomotion_bg.wasm', import.meta.url);
  // The one file has it within: not every server lets a page fetch even that.
  if (address.protocol === 'data:') return WebAssembly.compile(await unpacked(address.pathname));
  const response = await fetch(address);
  if (!response.ok) throw new Error(`the core is missing: ${response.status} ${response.statusText}`);
  return WebAssembly.compile(await response.arrayBuffer());
}
