// One evolution that stays on this thread between questions, whichever generation they are about.
/** @import { Experiment, GenerationRecord } from '../../pkg/ep_locomotion.js' */
import { Evolution } from '../../pkg/ep_locomotion.js';

/** @typedef {Omit<GenerationRecord, 'opponents'> & { opponents: Uint16Array }} PackedRecord All opponents in one row. */

/** @param {(done: number) => void} tell */
export function createHistory(tell) {
  /** @type {{ text: string, evolution: Evolution } | null} */
  let kept = null;

  /** Evolves on from what is kept, if that is the same evolution. @param {Experiment} experiment @param {number} generation */
  function evolved(experiment, generation) {
    const text = JSON.stringify(experiment);
    if (kept?.text !== text) {
      const evolution = new Evolution(experiment);
      kept?.evolution.free();
      kept = { text, evolution };
    }
    const { evolution } = kept;
    let told = performance.now();
    while (evolution.generation < generation) {
      evolution.step();
      if (performance.now() - told < 100) continue;
      told = performance.now();
      tell(evolution.generation / generation);
    }
    return evolution;
  }

  return {
    /** The newest generation of a run that has come so far. @param {Experiment} experiment @param {number} generation */
    newestGeneration(experiment, generation) {
      let evolution = evolved(experiment, generation);
      if (evolution.generation > generation) {
        kept?.evolution.free();
        kept = null;
        evolution = evolved(experiment, generation);
      }
      return {
        statistics: evolution.statistics(),
        population: evolution.population(),
        hash: evolution.hash(),
      };
    },

    /** @param {Experiment} experiment @param {number} generation */
    population: (experiment, generation) => evolved(experiment, generation).population(generation),

    /** @param {Experiment} experiment @param {number} generation @returns {PackedRecord} */
    record(experiment, generation) {
      const record = evolved(experiment, generation).record(generation);
      return { ...record, opponents: Uint16Array.from(record.opponents.flat()) };
    },
  };
}

/** @param {PackedRecord} packed @returns {GenerationRecord} */
export function unpacked({ opponents, ...record }) {
  const count = record.wins.length;
  const each = count && opponents.length / count;
  // They are read as lists are, and never written.
  const rows = Array.from({ length: count }, (_, i) => opponents.subarray(i * each, (i + 1) * each));
  return { ...record, opponents: /** @type {number[][]} */ (/** @type {unknown} */ (rows)) };
}
