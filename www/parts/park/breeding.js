// Evolution of robots that park, a generation at a time.
/** @import { Engine } from '../../core/engine.js' */
/** @import { Bred } from './state.js' */
import { parkedOf } from './task.js';

/** It goes on until all park, at most for so many generations. */
const mostGenerations = 100;

/** Whether it has come to its end by itself. @param {readonly Bred[]} bred @param {number} count */
export const isDone = (bred, count) => bred.length > mostGenerations || bred.at(-1)?.parked === count;

/** @param {Engine} engine @param {ReturnType<typeof import('./task.js').createTask>} task */
export function createBreeding(engine, task) {
  /** @type {ReturnType<Engine['apart']> | null} */
  let evolution = null;

  return {
    /** @param {number} seed */
    begin(seed) {
      const next = engine.apart(task.experiment(seed));
      evolution?.free();
      evolution = next;
    },

    /** The best robot of the next generation and its drives, with those of the one in the middle and of the last; null: it has yet to come to the one before, as in another language, for which the page is loaded again. @param {Bred | null} before @param {number} seed */
    next(before, seed) {
      evolution ??= engine.apart(task.experiment(seed));
      if (before && evolution.statistics().generation < before.generation) {
        evolution.step();
        return null;
      }
      const { generation, evaluations, best } = before ? evolution.step() : evolution.statistics();
      const population = evolution.population();
      const [drives, ...others] = task.drive(
        [0, population.length >> 1, population.length - 1].map((i) => population[i].gains),
      );
      // Whoever stays the best is the same robot.
      const gains =
        before && best.gains.every((gain, i) => gain === before.gains[i]) ? before.gains : best.gains;
      /** @type {Bred} */
      const robot = { gains, parked: parkedOf(drives), generation, drives: evaluations };
      return { drives, others: others.flat(), robot };
    },
  };
}
