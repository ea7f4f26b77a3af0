// What is measured of a disturbed drive, and asking the workers for it.
/** @import { Engine, Experiment, PaperResult, Posture, RemainingErrors, Triple } from '../../core/engine.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Store } from '../../run/store.js' */
import { disturbanceSlice } from './state.js';
import { remember } from '../../kit/memo.js';
import { endsOf } from '../../run/state.js';
import { gainsOf } from '../../run/drivers.js';
import { messageAround } from '../around.js';
import { offGoal, undisturbed, withDisturbance } from '../../run/scene.js';
import { usualStarts } from './numbers.js';

/** @typedef {import('../../core/engine.js').ErrorParts} ErrorParts */
/** The experiment's first start is that of the drive. @typedef {{ experiment: Experiment, gains: Triple, seconds: number }} Spec */
/** @typedef {{ spec: Spec, runs: ErrorParts[], disturbed: RemainingErrors, calm: RemainingErrors }} Measured One value for each start. */

/** The other starts: as far from the goal as the paper's, all around. */
const circle = { radius: 2 * Math.SQRT2, count: usualStarts, seed: 1 };
/** What remains is measured at the end of the run. */
const measuredSeconds = 2;
/** Most samples of all starts together: more would be slow to drive and to draw. */
const mostSamples = 200_000;

/** What a state asks for; the same object while nothing that matters has changed. @param {Engine} engine @param {PaperResult[]} paper */
export function createSpec(engine, paper) {
  const startsAround = remember(
    (/** @type {number} */ x, /** @type {number} */ y, /** @type {number} */ count) =>
      engine.startsOnCircle({ ...circle, x, y, count }),
  );
  const spec = remember(
    /** @param {Experiment} experiment @param {Experiment['disturbance']} disturbance @param {Posture} start @param {Triple} gains @returns {Spec} */
    (experiment, disturbance, start, gains) => {
      const { goal, horizon, sampleTime } = experiment;
      const affordable = Math.floor((mostSamples * sampleTime) / horizon);
      const others = startsAround(goal.x, goal.y, Math.max(1, Math.min(circle.count, affordable)));
      return {
        experiment: {
          ...experiment,
          ...withDisturbance(disturbance),
          starts: [offGoal(experiment, start), ...others],
        },
        gains,
        seconds: Math.min(measuredSeconds, horizon),
      };
    },
  );
  return (/** @type {State} */ state) =>
    spec(state.experiment, state.tried, endsOf(state).start, gainsOf(state, state.driver, paper));
}

/** @param {Engine} engine @param {Store} store */
export function createRequests(engine, store) {
  /** @type {Spec | null} */
  let asked = null;
  let isRunning = false;
  const { now, update } = disturbanceSlice.at(store);

  /** @param {Spec} spec */
  const ask = async (spec) => {
    const { experiment, gains, seconds } = spec;
    try {
      const [runs, [disturbed, calm]] = await Promise.all([
        engine.surveys.errorParts(experiment, gains),
        engine.surveys.remainingErrors([experiment, undisturbed(experiment)], gains, seconds),
      ]);
      isRunning = false;
      update({ measured: { spec, runs, disturbed, calm }, message: '' });
    } catch (error) {
      isRunning = false;
      // Asked for no more, until it is retried: what was measured last stays, and the page says why.
      update({ message: messageAround(error) });
    }
  };

  return {
    /** Each measurement is let end, so that numbers keep coming while something moves. @param {Spec} spec */
    follow(spec) {
      if (isRunning || spec === asked) return;
      asked = spec;
      isRunning = true;
      ask(spec);
    },

    retry() {
      if (now().message) asked = null;
    },
  };
}
