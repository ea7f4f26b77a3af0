// What an answer comes to, by the core: the same wherever it is asked, when it is handed in and when it is checked.
/** @import { Engine, Experiment, Triple } from '../../core/engine.js' */
/** @import { SurveyOptions } from '../../core/surveys.js' */
/** @import { Aim } from '../../run/aim.js' */
import { samplesOfDrive } from '../../core/bounds.js';
import { remember } from '../../kit/memo.js';
import { circle } from '../../parts/park/task.js';
import { createSets, testOn } from '../../parts/training/sets.js';

/** J, the mean over the starts of the experiment; from how many of them the robot parks; and what the aim wants, measured. @typedef {{ cost: number, parked: number, starts: number, value: number }} Measured */

const setsOf = remember((/** @type {Engine} */ engine) => createSets(engine));

/** The starts that count for an aim; null: those of the experiment. @param {Engine} engine @param {Aim | null} aim @param {Experiment} experiment */
function startsFor(engine, aim, experiment) {
  const { goal, starts } = experiment;
  if (aim?.wanted.kind === 'unseen') return setsOf(engine)(experiment).unseen;
  if (aim?.wanted.kind !== 'parks' || aim.wanted.of === starts.length) return null;
  // As the parking place has them.
  return engine.startsOnCircle({ ...circle, x: goal.x, y: goal.y, count: aim.wanted.of });
}

/** @param {Engine} engine @param {Aim | null} aim @param {Experiment} experiment @param {Triple} gains @param {SurveyOptions} [options] @returns {Promise<Measured>} */
export async function measure(engine, aim, experiment, gains, options) {
  const apart = startsFor(engine, aim, experiment);
  const robots = [experiment.starts, ...(apart ? [apart] : [])].map(
    (starts) => /** @type {const} */ ([testOn(experiment, starts), gains]),
  );
  // One after the other: of a channel's jobs only the newest is done.
  const [cost] = await engine.surveys.costs([robots[0]], options);
  const [own, aside = own] = await engine.surveys.fares(robots, options);
  const parked = countOf(own.arrived);
  const told = { cost, parked, starts: experiment.starts.length };
  if (!aim || aim.wanted.kind === 'cost') return { ...told, value: cost };
  const wanted = countOf(aside.arrived);
  return { ...told, value: aim.wanted.kind === 'parks' ? wanted : wanted / aside.arrived.length };
}

/** @param {Uint8Array} arrived */
const countOf = (arrived) => arrived.reduce((sum, one) => sum + one, 0);

/** How much there is to drive, in samples at most. @param {Engine} engine @param {Aim | null} aim @param {Experiment} experiment */
export function samplesToMeasure(engine, aim, experiment) {
  const apart = startsFor(engine, aim, experiment)?.length ?? 0;
  return (2 * experiment.starts.length + apart) * samplesOfDrive(experiment);
}
