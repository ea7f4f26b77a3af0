// Every hand-in recomputed by the core: none is believed. What it says is compared with what it comes to; what it came to is
// judged in the exercise as it was given, drawn for its student.
/** @import { Engine, Experiment, Triple } from '../../core/engine.js' */
/** @import { Linked } from '../../link/keys.js' */
/** @import { Links } from '../../link/link.js' */
/** @import { Judged } from '../../run/aim.js' */
/** @import { Entry } from './entries.js' */
import { createTurns } from '../../kit/loop.js';
import { changesOf } from '../../link/experiment.js';
import { judged } from '../../run/aim.js';
import { gainsOf } from '../../run/drivers.js';
import { wayOf } from '../../run/exercise.js';
import { drawnFor, undrawn } from '../../run/variant.js';
import { messageOf } from '../../words/errors.js';
import { measure, samplesToMeasure } from '../handin/measure.js';
import { exerciseId, exerciseLink, holds, isWhole, toldIn } from '../handin/receipt.js';

/** An exercise: the run with which it was given, its link and its digits. @typedef {{ run: Linked, base: Experiment, link: string, id: string }} Given */
/** What a receipt is: whole and true; its result is another; it was cut or changed; made by another program; or there is none. @typedef {'holds' | 'otherResult' | 'broken' | 'otherProgram' | 'none'} Worth */
/** What came of one hand-in: `cost` in the exercise as it was given, `own` in what was handed in; `drives` null: nobody has told; `lacksDrives`: so the budget of drives cannot be judged. @typedef {{ who: string, run: Linked, gains: Triple, how: string, cost: number, own: number, value: number, drives: number | null, minutes: number | null, isTold: boolean, lacksDrives: boolean, judged: Judged | null, worth: Worth, told: number | null, differs: readonly string[], answers: string }} Checked */
/** `problem`: why it could not be read, in words or one of these. @typedef {{ entry: Entry, checked: Checked | null, problem: '' | 'none' | 'long' | 'heavy' | { said: string }, same: readonly number[] }} Row */

/** Whoever asks for more would hold the others: samples of a drive, about half a minute of evolution. */
const mostSamples = 5e9;
/** Links are read on the page's own thread, so many milliseconds in a row. */
const slice = 12;

/** @param {Engine} engine @param {Links} links */
export function createChecker(engine, links) {
  const paper = engine.paper();

  /** @param {string} link */
  const open = (link) => {
    const { opened, problems } = links.openLink(link, engine);
    const { parts, ...run } = opened;
    return { run: /** @type {Linked} */ ({ ...run, slices: parts }), problems };
  };

  /** @param {Linked} run @returns {Given} */
  const givenOf = (run) => {
    const link = exerciseLink(run, engine, links);
    return {
      run,
      base: undrawn(run.experiment, run.exercise.vary, run.student) ?? run.experiment,
      link,
      id: exerciseId(link),
    };
  };

  /** @param {string} link As it stands behind the #, or a whole address. */
  const exerciseIn = (link) => {
    const { run, problems } = open(link.slice(link.indexOf('#') + 1).trim());
    if (problems.length > 0) throw new Error(problems.join(' '));
    return givenOf(run);
  };

  /** The gains of an answer and the drives that evolution made for them. @param {Linked} run @param {AbortSignal} signal */
  async function answerOf(run, signal) {
    const { driver, experiment, generation } = run;
    if (driver !== 'evolved')
      return { gains: gainsOf({ ...run, population: [] }, driver, paper), drives: null };
    const { population, statistics } = await engine.surveys.generation(experiment, generation, { signal });
    return { gains: population[0].gains, drives: statistics.evaluations };
  }

  /** @param {Linked} run @param {Entry} entry @param {Given} given @param {{ signal: AbortSignal, turn: () => Promise<void> }} options @returns {Promise<Checked>} */
  async function check(run, entry, given, { signal, turn }) {
    const { aim, scale, vary } = given.run.exercise;
    const { who, handin } = run.student;
    const told = toldIn(handin);
    const { gains, drives } = await answerOf(run, signal);
    const own = await measure(engine, null, run.experiment, gains, { signal });
    const asGiven = engine.experiment(drawnFor(given.base, who ? vary : [], who));
    const there = await measure(engine, aim, asGiven, gains, { signal });
    const made = drives ?? told?.drives ?? null;
    // Many come at once.
    await turn();
    const worth = worthOf(run, entry, told, own);
    // Of what was cut or changed nobody knows what it was.
    const isUsable = worth !== 'broken';
    const lacksDrives = isUsable && made === null && aim !== null && aim.drives !== null;
    return {
      who,
      run,
      gains,
      how: howOf(run),
      cost: there.cost,
      own: own.cost,
      value: there.value,
      drives: made,
      minutes: told?.minutes ?? null,
      isTold: drives === null,
      lacksDrives,
      judged:
        aim && isUsable && !lacksDrives
          ? judged(aim, scale, { value: there.value, drives: made ?? 0 })
          : null,
      worth,
      told: told?.cost ?? null,
      differs: differencesOf(run, given, asGiven, engine),
      answers: told?.answers ?? '',
    };
  }

  /** @param {Linked} run @param {Entry} entry @param {ReturnType<typeof toldIn>} told @param {import('../handin/measure.js').Measured} own @returns {Worth} */
  function worthOf(run, entry, told, own) {
    if (!run.student.handin) return entry.isReceipt ? 'broken' : 'none';
    if (!told || !isWhole(run, engine, links)) return 'broken';
    if (holds(told, own)) return 'holds';
    return told.program === engine.version() ? 'otherResult' : 'otherProgram';
  }

  /** @param {Linked} run @param {Given} given */
  const isHeavy = (run, given) => {
    const { experiment, generation, driver } = run;
    const { population } = experiment.evolution;
    const each = (experiment.starts.length * experiment.horizon) / experiment.sampleTime;
    const evolved = driver === 'evolved' ? population * (generation + 1) * each : 0;
    return evolved + samplesToMeasure(engine, given.run.exercise.aim, experiment) > mostSamples;
  };

  return {
    exerciseIn,

    /**
     * Rows in the order of the entries, and the exercise by which they were judged: the one that is given, or else the one
     * that most of them say they are of.
     * @param {readonly Entry[]} entries @param {Given | null} exercise @param {{ signal: AbortSignal, onProgress: (share: number) => void }} options
     * @returns {Promise<{ rows: Row[], given: Given | null }>}
     */
    async check(entries, exercise, { signal, onProgress }) {
      const turn = createTurns(slice);
      /** @type {(Linked | string | null)[]} */
      const runs = [];
      for (const { link } of entries) {
        runs.push(link === null ? null : read(link));
        onProgress((0.3 * runs.length) / entries.length);
        await turn();
        signal.throwIfAborted();
      }
      const given =
        exercise ?? (await commonOf(runs.filter((run) => run !== null && typeof run !== 'string')));
      let done = 0;
      /** @param {Entry} entry @param {number} i @returns {Promise<Row>} */
      const rowOf = async (entry, i) => {
        const run = runs[i];
        const row = { entry, checked: null, same: [] };
        if (run === null || !given) return { ...row, problem: entry.why ?? 'none' };
        if (typeof run === 'string') return { ...row, problem: { said: run } };
        if (isHeavy(run, given)) return { ...row, problem: 'heavy' };
        try {
          return { ...row, checked: await check(run, entry, given, { signal, turn }), problem: '' };
        } catch (error) {
          signal.throwIfAborted();
          return { ...row, problem: { said: messageOf(error) } };
        } finally {
          done += 1;
          onProgress(0.3 + (0.7 * done) / entries.length);
        }
      };
      /** @type {Promise<Row>[]} */
      const checking = [];
      for (const [i, entry] of entries.entries()) {
        checking.push(rowOf(entry, i));
        await turn();
        signal.throwIfAborted();
      }
      return { rows: withTwins(await Promise.all(checking)), given };
    },
  };

  /** The run of a link, or what is wrong with it. @param {string} link @returns {Linked | string} */
  function read(link) {
    try {
      const { run, problems } = open(link);
      return problems.length > 0 ? problems.join(' ').slice(0, 400) : run;
    } catch (error) {
      return messageOf(error);
    }
  }

  /** @param {readonly Linked[]} runs */
  async function commonOf(runs) {
    /** @type {Map<string, { given: Given, count: number }>} */
    const found = new Map();
    const turn = createTurns(slice);
    for (const run of runs) {
      const given = givenOf(run);
      const known = found.get(given.id);
      found.set(given.id, { given: known?.given ?? given, count: (known?.count ?? 0) + 1 });
      await turn();
    }
    return [...found.values()].sort((a, b) => b.count - a.count)[0]?.given ?? null;
  }
}

/** How the gains were found. @param {Linked} run */
const howOf = ({ driver, experiment, generation }) =>
  driver === 'evolved'
    ? `${experiment.evolution.method}, ${experiment.evolution.seed}, ${generation}`
    : driver;

/** What is not as it was given, by the names of links. @param {Linked} run @param {Given} given @param {Experiment} asGiven @param {Engine} engine */
function differencesOf(run, given, asGiven, engine) {
  const { exercise } = given.run;
  const isFree = (/** @type {string} */ path) =>
    path === 'seed'
      ? wayOf(exercise, 'seed') === 'free' && !exercise.vary.includes('seed')
      : /^(evolution\.|population|opponents)/.test(path) && wayOf(exercise, 'settings') === 'free';
  const fields = changesOf(engine.experiment(run.experiment), asGiven)
    .map(([path]) => path)
    .filter((path) => !isFree(path));
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
  return [...fields, ...parts.filter(([, own, other]) => text(own) !== text(other)).map(([name]) => name)];
}

/** Who has the very same answer as whom. @param {Row[]} rows @returns {Row[]} */
function withTwins(rows) {
  /** @type {Map<string, number[]>} */
  const byAnswer = new Map();
  const keyOf = (/** @type {Row} */ { checked }) => checked && `${checked.gains} ${checked.how}`;
  for (const [i, row] of rows.entries()) {
    const key = keyOf(row);
    if (key) byAnswer.set(key, [...(byAnswer.get(key) ?? []), i]);
  }
  return rows.map((row, i) => ({
    ...row,
    same: (byAnswer.get(keyOf(row) ?? '') ?? []).filter((one) => one !== i),
  }));
}
