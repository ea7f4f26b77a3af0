// The exercise's own experiment: an answer is judged in it, whatever else was driven.
/** @import { Engine, Experiment } from '../../core/engine.js' */
/** @import { Exercise } from '../../run/exercise.js' */
/** @import { Student } from '../../run/variant.js' */
import { remember } from '../../kit/memo.js';
import { apartFrom } from '../../link/exercise.js';
import { pathOf } from '../../link/experiment.js';
import { drawnFor } from '../../run/variant.js';

/** What of an experiment has a word of its own. @typedef {keyof Experiment | 'seed'} Thing */
/** The experiment in which an answer is judged, and what of the run is not as it has it. @typedef {{ own: Experiment, apart: readonly Thing[] }} Own */

/** @param {string} name Of a field, as links have it. @returns {Thing} */
const thingOf = (name) =>
  name === 'seed' ? name : /** @type {keyof Experiment} */ (pathOf(name).split('.')[0]);

/** The same as long as it is that of the same student: what is measured in it is measured once. */
const drawnIn = remember(
  /** @param {Engine} engine @param {Experiment} given @param {Exercise['vary']} vary @param {string} who */
  (engine, given, vary, who) => engine.experiment(drawnFor(given, vary, who)),
);

/** @param {Engine} engine @param {Exercise} exercise @param {Student} student @param {Experiment} experiment Of the run. @returns {Own} */
export function ownOf(engine, exercise, { who, base }, experiment) {
  if (!base) return { own: experiment, apart: [] };
  const drawn = drawnIn(engine, base.experiment, exercise.vary, who);
  const apart = [...new Set(apartFrom(experiment, drawn, exercise).map(thingOf))];
  return { own: apart.length > 0 ? drawn : experiment, apart };
}
