// A hand-in recomputed by the core, for none is believed. What it says is compared with what it comes to; what it came to is
// judged in the exercise as it was given, drawn for its student.
/** @import { Engine, Experiment, PaperResult } from '../../core/engine.js' */
/** @import { Linked } from '../../link/keys.js' */
/** @import { Links } from '../../link/link.js' */
/** @import { Measured } from '../handin/measure.js' */
/** @import { Checked, Given, Worth } from './check.js' */
/** @import { Entry } from './entries.js' */
import { samplesOfRobot } from '../../core/bounds.js';
import { apartFrom } from '../../link/exercise.js';
import { judged } from '../../run/aim.js';
import { gainsOf } from '../../run/drivers.js';
import { drawnFor } from '../../run/variant.js';
import { measure, samplesToMeasure } from '../handin/measure.js';
import { holds, isWhole, toldIn } from '../handin/receipt.js';
import handIn from '../handin/words/index.js';
import { unreachable } from '../../run/prepared.js';

/** @typedef {{ engine: Engine, links: Links, paper: PaperResult[] }} Tools */

/** Whoever asks for more would hold the others: samples of a drive, about half a minute of evolution. */
const mostSamples = 5e9;

/** @param {Engine} engine @param {Linked} run @param {Given} given */
export function isHeavy(engine, run, given) {
  const { experiment, generation, driver } = run;
  const { population } = experiment.evolution;
  const evolved = driver === 'evolved' ? population * (generation + 1) * samplesOfRobot(experiment) : 0;
  return evolved + samplesToMeasure(engine, given.run.exercise.aim, experiment) > mostSamples;
}

/** @param {Tools} tools @param {Linked} run @param {Entry} entry @param {Given} given @param {{ signal: AbortSignal, turn: () => Promise<void> }} options @returns {Promise<Checked>} */
export async function recompute(tools, run, entry, given, { signal, turn }) {
  const { engine } = tools;
  const { aim, scale, vary } = given.run.exercise;
  const { who, handin } = run.student;
  const told = toldIn(handin);
  const { gains, drives } = await answerOf(tools, run, signal);
  const own = await measure(engine, null, run.experiment, gains, { signal });
  const asGiven = engine.experiment(drawnFor(given.base, vary, who));
  const there = await measure(engine, aim, asGiven, gains, { signal });
  const made = drives ?? told?.drives ?? null;
  // Many come at once.
  await turn();
  const worth = worthOf(tools, run, entry, told, own);
  // Of what was cut or changed nobody knows what it was.
  const isUsable = worth !== 'broken';
  const lacksDrives = isUsable && made === null && aim !== null && aim.drives !== null;
  // What is drawn is drawn for a name.
  const lacksWho = vary.length > 0 && who === '';
  const mayJudge = isUsable && !lacksDrives && !lacksWho;
  return {
    who,
    run,
    gains,
    how: howOf(run),
    cost: there.cost,
    own: own.cost,
    drives: made,
    minutes: told?.minutes ?? null,
    isTold: drives === null,
    lacksDrives,
    lacksWho,
    judged: aim && mayJudge ? judged(aim, scale, { value: there.value, drives: made ?? 0 }) : null,
    reached: aim && mayJudge && aim.wanted.kind !== 'cost' ? handIn.valueText(aim.wanted, there.value) : '',
    worth,
    told: told?.cost ?? null,
    differs: differencesOf(engine, run, given, asGiven),
    answers: told?.answers ?? '',
  };
}

/** The gains of an answer and the drives that evolution made for them. @param {Tools} tools @param {Linked} run @param {AbortSignal} signal */
async function answerOf({ engine, paper }, run, signal) {
  const { driver, experiment, generation } = run;
  if (driver !== 'evolved')
    return { gains: gainsOf({ ...run, population: [] }, driver, paper), drives: null };
  const { population, statistics } = await engine.surveys.generation(experiment, generation, { signal });
  return { gains: population[0].gains, drives: statistics.evaluations };
}

/** A receipt that was cut or changed. @param {Pick<Tools, 'engine' | 'links'>} tools @param {Linked} run @param {Entry} entry */
export function isBroken({ engine, links }, run, { isReceipt }) {
  const { handin } = run.student;
  return handin ? toldIn(handin) === null || !isWhole(run, engine, links) : isReceipt;
}

/** @param {Tools} tools @param {Linked} run @param {Entry} entry @param {ReturnType<typeof toldIn>} told @param {Measured} own @returns {Worth} */
function worthOf(tools, run, entry, told, own) {
  if (isBroken(tools, run, entry)) return 'broken';
  if (!told) return 'none';
  if (holds(told, own)) return 'holds';
  return told.program === tools.engine.version() ? 'otherResult' : 'otherProgram';
}

/** How the gains were found. @param {Linked} run */
const howOf = ({ driver, experiment, generation }) =>
  driver === 'evolved'
    ? `${experiment.evolution.method}, ${experiment.evolution.seed}, ${generation}`
    : driver;

/** What is not as it was given, by the names of links. @param {Engine} engine @param {Linked} run @param {Given} given @param {Experiment} asGiven */
function differencesOf(engine, run, given, asGiven) {
  const { exercise } = given.run;
  const fields = apartFrom(engine.experiment(run.experiment), asGiven, exercise);
  const text = (/** @type {unknown} */ value) => JSON.stringify(value);
  const { task, locked, hidden, aim, scale, vary } = run.exercise;
  /** @type {[string, unknown, unknown][]} */
  const parts = [
    ['task', task, exercise.task],
    ['lock', locked, exercise.locked],
    ['hide', hidden, exercise.hidden],
    ['aim', aim, exercise.aim],
    ['points', scale, exercise.scale],
    ['vary', vary, exercise.vary],
  ];
  return [
    ...fields,
    ...unreachable(run, exercise, given.prepared),
    ...parts.filter(([, own, other]) => text(own) !== text(other)).map(([name]) => name),
  ];
}
