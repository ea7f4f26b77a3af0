// All hand-ins: each is opened, recomputed, and judged by one exercise, without holding the page.
/** @import { Engine, Experiment, Triple } from '../../core/engine.js' */
/** @import { Linked } from '../../link/keys.js' */
/** @import { Links } from '../../link/link.js' */
/** @import { Judged } from '../../run/aim.js' */
/** @import { Entry } from './entries.js' */
/** @import { Prepared } from '../../run/prepared.js' */
import { createTurns } from '../../kit/loop.js';
import { messageOf } from '../../words/errors.js';
import { exerciseId, exerciseLink } from '../handin/receipt.js';
import { preparedBy } from './prepared.js';
import { isBroken, isHeavy, recompute } from './recompute.js';
import words from './words/index.js';

/** An exercise: the run with which it was given, what of that nobody could choose, its link and its digits. @typedef {{ run: Linked, base: Experiment, prepared: Prepared, link: string, id: string }} Given */
/** What a receipt is: whole and true; its result is another; it was cut or changed; made by another program; or there is none. @typedef {'holds' | 'otherResult' | 'broken' | 'otherProgram' | 'none'} Worth */
/** What came of one hand-in: `cost` in the exercise as it was given, `own` in what was handed in; `drives` null: nobody has told; `lacksDrives`: so the budget of drives cannot be judged; `lacksWho`: nothing was drawn; `reached`: what the aim wants, measured, where it is not J. @typedef {{ who: string, run: Linked, gains: Triple, how: string, cost: number, own: number, drives: number | null, minutes: number | null, isTold: boolean, lacksDrives: boolean, lacksWho: boolean, judged: Judged | null, reached: string, worth: Worth, told: number | null, differs: readonly string[], answers: string }} Checked */
/** `problem`: why it could not be read, in words or one of these; `same`: the rows of this very answer, `ones`: those of this student, itself among them. @typedef {{ entry: Entry, checked: Checked | null, problem: '' | 'none' | 'long' | 'more' | 'bytes' | 'heavy' | { said: string }, same: readonly number[], ones: readonly number[] }} Row */

/** Links are read on the page's own thread, so many milliseconds in a row. */
const slice = 12;

/** @param {Engine} engine @param {Links} links */
export function createChecker(engine, links) {
  const tools = { engine, links, paper: engine.paper() };

  /** @param {string} link */
  const open = (link) => {
    const { opened, problems } = links.openLink(link, engine);
    const { parts, ...run } = opened;
    return { run: /** @type {Linked} */ ({ ...run, slices: parts }), problems };
  };

  /** The run of a link, or what is wrong with it. @param {string} link @returns {Linked | string} */
  const read = (link) => {
    try {
      const { run, problems } = open(link);
      return problems.length > 0 ? problems.join(' ').slice(0, 400) : run;
    } catch (error) {
      return messageOf(error);
    }
  };

  return {
    /** @param {string} asked As it stands behind the #, or a whole address. */
    exerciseIn(asked) {
      const link = asked.slice(asked.indexOf('#') + 1).trim();
      if (link === '' || (!asked.includes('#') && /^[^&]*\//.test(link))) throw new Error(words.noLink);
      const { run, problems } = open(link);
      if (problems.length > 0) throw new Error(problems.join(' '));
      return givenOf(engine, links, run);
    },

    /**
     * Rows in the order of the entries, and the exercise by which they were judged: the one that is given, or else the one
     * that most of those who handed in say they are of.
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
      const given = await givenTo(tools, entries, runs, exercise);
      let done = 0;
      /** @param {Entry} entry @param {number} i @returns {Promise<Row>} */
      const rowOf = async (entry, i) => {
        const run = runs[i];
        const row = { entry, checked: null, same: [], ones: [] };
        if (typeof run === 'string') return { ...row, problem: { said: run } };
        if (run === null || !given) return { ...row, problem: entry.why ?? 'none' };
        if (isHeavy(engine, run, given)) return { ...row, problem: 'heavy' };
        try {
          const checked = await recompute(tools, run, entry, given, { signal, turn });
          return { ...row, checked, problem: '' };
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
        const row = rowOf(entry, i);
        // Of what a cancel ends nobody may be waiting for yet.
        row.catch(() => {});
        checking.push(row);
        await turn();
        signal.throwIfAborted();
      }
      return { rows: withTwins(await Promise.all(checking)), given };
    },
  };
}

/** @param {Engine} engine @param {Links} links @param {Linked} run @returns {Given} */
function givenOf(engine, links, run) {
  const link = exerciseLink(run, engine, links);
  return {
    run,
    base: (run.student.base ?? run).experiment,
    prepared: preparedBy(run, []),
    link,
    id: exerciseId(link),
  };
}

/** The exercise that is asked for, or else the one that most are of, as it was given to these: each counts once, by the last that is whole, and what was cut only where nothing else is there. @param {import('./recompute.js').Tools} tools @param {readonly Entry[]} entries @param {readonly (Linked | string | null)[]} runs @param {Given | null} asked @returns {Promise<Given | null>} */
async function givenTo(tools, entries, runs, asked) {
  const turn = createTurns(slice);
  /** @type {[whole: Map<string, Linked>, broken: Map<string, Linked>]} */
  const [whole, broken] = [new Map(), new Map()];
  for (const [i, run] of runs.entries()) {
    if (run === null || typeof run === 'string') continue;
    (isBroken(tools, run, entries[i]) ? broken : whole).set(whoseOf(entries[i], run, i), run);
    await turn();
  }
  // By the whole link: other exercises can be made that have the same digits.
  /** @type {Map<string, { given: Given, of: Linked[] }>} */
  const found = new Map();
  for (const run of (whole.size > 0 ? whole : broken).values()) {
    const given = givenOf(tools.engine, tools.links, run);
    const known = found.get(given.link);
    if (known) known.of.push(run);
    else found.set(given.link, { given, of: [run] });
    await turn();
  }
  const given = asked ?? [...found.values()].sort((a, b) => b.of.length - a.of.length)[0]?.given;
  return given ? { ...given, prepared: preparedBy(given.run, found.get(given.link)?.of ?? []) } : null;
}

/** By this a hand-in is one person's; what only stands before a link may stand before all. @param {Entry} entry @param {Linked} run @param {number} index */
const whoseOf = ({ name, ident, isOnes }, { student }, index) =>
  JSON.stringify([name, ident, isOnes || student.who || index]);

/** Whether the platform says whose it is: a name alone may be that of two. @param {Entry} entry */
const isKnown = ({ isOnes, ident }) => isOnes && Object.keys(ident).length > 0;

/** Who has the very same answer as whom, and who handed in what else: one list for all of an answer, or of a student. @param {Row[]} rows @returns {Row[]} */
function withTwins(rows) {
  /** @type {Map<string, number[]>} */
  const lists = new Map();
  const listOf = (/** @type {string} */ key, /** @type {number} */ i) => {
    const list = lists.get(key) ?? [];
    lists.set(key, list);
    list.push(i);
    return list;
  };
  return rows.map((row, i) => {
    const { entry, checked } = row;
    if (!checked) return row;
    return {
      ...row,
      same: listOf(`${checked.gains} ${checked.how}`, i),
      // Whose it is by what is typed in it, anybody may say.
      ones: isKnown(entry) ? listOf(whoseOf(entry, checked.run, i), i) : [i],
    };
  });
}
