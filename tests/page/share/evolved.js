// An evolution that a run's file can be made of, and what reads it.
import { links } from '../../../www/lesson/links.js';
import { Evolution, evaluate, experiment, paper, Simulation } from '../harness/core.js';

/** @typedef {import('../harness/core.js').Experiment} Experiment */
/** @typedef {import('../../../www/core/engine.js').Engine} Engine */
/** @typedef {Parameters<typeof import('../../../www/share/run-file.js').runFile>[0]} Kept */

/** An evolution, and what the page knows of it. @param {Experiment} from @param {number} generations */
export function evolved(from, generations) {
  const evolution = new Evolution(from);
  const history = [evolution.statistics()];
  while (history.length <= generations) history.push(evolution.step());
  const engine = /** @type {Engine} */ (
    /** @type {unknown} */ ({
      experiment,
      paper,
      version: () => '0.1.0',
      hash: () => evolution.hash(),
      population: (/** @type {number} */ generation) => evolution.population(generation),
      check: (/** @type {Experiment} */ from, /** @type {number[]} */ gains) =>
        new Simulation(from, gains).free(),
      surveys: {
        async evolve(/** @type {Experiment} */ e, /** @type {number} */ count, { shown = count } = {}) {
          const { engine: again, state } = evolved(e, count);
          const [best, median] = [
            state.history.map((one) => one.best.cost),
            state.history.map((one) => one.median),
          ];
          return { hash: again.hash(), history: { best, median }, leader: again.population(shown)[0] };
        },
        costs: async (/** @type {(readonly [Experiment, number[]])[]} */ robots) =>
          robots.map(([from, gains]) => evaluate(from, gains)[0]),
      },
    })
  );
  const { parts, ...run } = links.openLink('lab', engine).opened;
  /** @type {Kept} */
  const state = { ...run, slices: parts, experiment: from, generation: 3, history };
  return { engine, state };
}
