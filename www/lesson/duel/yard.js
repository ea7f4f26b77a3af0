// The yard: one set of gains drives from 32 starts around the goal, those that Training evolves on too.
import { isLongDrive } from '../../core/bounds.js';
import { remember, rememberEach } from '../../kit/memo.js';
import { createSets } from '../../parts/training/sets.js';
import { taskText } from './tally.js';

/** @import { Engine, Experiment, Run, Triple } from '../../core/engine.js' */
/** @typedef {{ experiment: Experiment, gains: Triple, runs: readonly Run[], parked: number, cost: number }} Yard J is the mean over all starts. */

const mostKept = 16;

/** The same task from all of its starts. @param {Engine} engine */
function createYard(engine) {
  const setsOf = createSets(engine);
  /** @type {Map<string, Yard>} */
  const known = new Map();

  const experimentOf = remember(
    /** @returns {Experiment} */ (/** @type {Experiment} */ experiment) => ({
      ...experiment,
      starts: setsOf(experiment).circle,
    }),
    // On the stage and of the duel.
    2,
  );

  return {
    experimentOf,

    /** All of them drive; null where that would take too long to watch. @param {Experiment} experiment @param {Triple} gains @returns {Yard | null} */
    drive(experiment, gains) {
      const own = experimentOf(experiment);
      if (isLongDrive(own, own.starts.length)) return null;
      const name = `${gains} ${taskText(own)}`;
      const before = known.get(name);
      if (before) return before;
      const runs = own.starts.map((start) => engine.drive({ ...own, starts: [start] }, [gains])[0]);
      const yard = {
        experiment: own,
        gains,
        runs,
        parked: runs.filter(({ arrived }) => arrived).length,
        cost: runs.reduce((sum, { cost }) => sum + cost.total, 0) / runs.length,
      };
      known.set(name, yard);
      if (known.size > mostKept) known.delete(known.keys().next().value ?? '');
      return yard;
    },
  };
}

/** One for each engine, so that nothing drives twice. */
export const yardOf = rememberEach(createYard);
