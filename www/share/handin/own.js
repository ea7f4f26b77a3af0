// The exercise's own experiment: an answer is judged in it, whatever else was driven.
/** @import { Engine, Experiment } from '../../core/engine.js' */
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Drive, Unreachable } from '../../run/prepared.js' */
/** @import { State } from '../../run/state.js' */
/** @import { Student } from '../../run/variant.js' */
import { remember } from '../../kit/memo.js';
import { apartFrom } from '../../link/exercise.js';
import { pathOf } from '../../link/experiment.js';
import { unreachable } from '../../run/prepared.js';
import { caughtUp } from '../../run/state.js';
import { drawnFor, nobody } from '../../run/variant.js';

/** What of a run has a word of its own. @typedef {keyof Experiment | 'seed' | Unreachable} Thing */
/** The experiment in which an answer is judged, and what of the run is not as it has it. @typedef {{ own: Experiment, apart: readonly Thing[] }} Own */

/** @param {string} name Of a field, as links have it. @returns {Thing} */
const thingOf = (name) =>
  name === 'seed' ? name : /** @type {keyof Experiment} */ (pathOf(name).split('.')[0]);

/** What of a run nobody can set right by pressing. @param {Thing} thing */
export const isOutOfReach = (thing) => thing === 'drives' || thing === 'gains' || thing === 'generation';

/** The same as long as it is that of the same student: what is measured in it is measured once. */
const drawnIn = remember(
  /** @param {Engine} engine @param {Experiment} given @param {Exercise['vary']} vary @param {string} who */
  (engine, given, vary, who) => engine.experiment(drawnFor(given, vary, who)),
);

/** @param {Engine} engine @param {Exercise} exercise @param {Student} student @param {Experiment} experiment Of the run. @param {Drive} drive @returns {Own} */
export function ownOf(engine, exercise, { who, base }, experiment, drive) {
  if (!base) return { own: experiment, apart: [] };
  const drawn = drawnIn(engine, base.experiment, exercise.vary, who);
  const changed = [...new Set(apartFrom(experiment, drawn, exercise).map(thingOf))];
  const apart = [...changed, ...unreachable(drive, exercise, base.prepared)];
  return { own: changed.length > 0 ? drawn : experiment, apart };
}

/** Of the run that is on screen, found anew where something of it is another. @param {Engine} engine */
export function createOwnNow(engine) {
  const ownIn = remember(
    /** @param {Exercise} exercise @param {Student} student @param {Experiment} experiment @param {Drive['driver']} driver @param {Drive['handGains']} handGains @param {number} generation */
    (exercise, student, experiment, driver, handGains, generation) =>
      ownOf(engine, exercise, student, experiment, { driver, handGains, generation }),
  );
  /** What is in the making is as it is on screen. @param {State} state */
  return (state) => {
    const { exercise, student, experiment, driver, handGains, generation, maker } = caughtUp(state);
    return ownIn(exercise, maker.open ? nobody : student, experiment, driver, handGains, generation);
  };
}
