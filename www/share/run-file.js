// A run as a file: its link, which is all that is needed to make it again, and what it came to, which proves that it is.
/** @import { Engine, Experiment, Individual, Statistics, Triple } from '../core/engine.js' */
/** @import { Linked } from '../link/keys.js' */
/** @import { Links } from '../link/link.js' */
/** @import { Opened } from '../run/actions/page.js' */
import { gainsOf } from '../run/drivers.js';
import { lastGeneration } from '../run/pace.js';
import { tried } from '../run/scene.js';
import { mark } from './handin/mark.js';
import words from './words/index.js';

const format = 'ep-locomotion run';
const version = 1;
/** No run's file is near as large: what is larger is not read. */
const mostCharacters = 50_000_000;

/** What drives on screen, and the J that it comes to from there. @typedef {{ gains: Triple, cost: number }} Drive */

/** What is driven: with what is tried, and from the first start alone. @param {Pick<Linked, 'experiment' | 'trial'>} state @returns {Experiment} */
function drivenIn({ experiment, trial }) {
  const driven = tried(experiment, trial);
  return { ...driven, starts: driven.starts.slice(0, 1) };
}

/** @param {Linked & { history: Statistics[] }} state @param {Engine} engine @param {Links} links @param {Drive} [drive] If the link alone says whose it is. */
export function runFile(state, engine, links, drive) {
  const newest = state.history.length - 1;
  const content = {
    format,
    version,
    program: engine.version(),
    link: links.linkOf(state, engine.experiment),
    hash: engine.hash(),
    generations: newest,
    drive: drive && { ...drive, experiment: drivenIn(state) },
    experiment: state.experiment,
    statistics: state.history,
  };
  return `${JSON.stringify(content, null, 1)}\n`;
}

/** Of one that is too large not even the text. @param {Pick<Blob, 'size' | 'text'>} file */
export async function textOfRun(file) {
  // In UTF-8 one has three bytes at most.
  if (file.size > 3 * mostCharacters) throw new Error(words.largeFile);
  return file.text();
}

/**
 * Reads a run, and makes it again to see that it comes to the same. Throws an Error that says what is wrong with the file.
 * @param {string} text @param {Engine} engine @param {Links} links @param {AbortSignal} [signal]
 * @returns {Promise<{ opened: Opened, generations: number, hasDrive: boolean }>} Older files say nothing of the drive.
 */
export async function openRunFile(text, engine, links, signal) {
  const content = parse(text);
  if (content.format !== format) throw new Error(words.foreignFile);
  if (typeof content.version !== 'number') throw new Error(words.damagedFile('version'));
  if (content.version !== version) throw new Error(words.otherVersion(content.version, version));
  const { link, hash, generations, statistics } = content;
  if (typeof link !== 'string' || typeof hash !== 'string') throw new Error(words.damagedFile('link, hash'));
  // To make a run again takes time: only as many generations as the file holds.
  const held = Array.isArray(statistics) ? statistics.length - 1 : -1;
  if (generations !== held || held < 0 || held > lastGeneration)
    throw new Error(words.damagedFile('generations'));
  const { opened, problems } = links.openLink(link, engine);
  if (problems.length > 0) throw new Error(words.damagedLink(problems));
  if (opened.generation > generations) throw new Error(words.damagedFile('generations'));
  const again = await engine.surveys.evolve(opened.experiment, generations, {
    signal,
    shown: opened.generation,
  });
  if (again.hash !== hash) throw new Error(words.otherHash(hash, again.hash));
  // Nothing of them is opened; but who reads the file rests on what stands in it.
  if (!isSame(content.experiment, opened.experiment, engine))
    throw new Error(words.changedFile('experiment'));
  const { best, median } = again.history;
  const isTold = (/** @type {any} */ one, /** @type {number} */ i) =>
    cameTo(one?.best?.cost, best[i]) && cameTo(one?.median, median[i]);
  if (!statistics.every(isTold)) throw new Error(words.changedFile('statistics'));
  const hasDrive = content.drive !== undefined;
  if (hasDrive) await checkDrive(content.drive, opened, again.leader, engine, signal);
  return { opened, generations, hasDrive };
}

/** JSON knows no infinity. @param {unknown} told @param {number} found */
const cameTo = (told, found) => told === found || (told === null && !Number.isFinite(found));

/** @param {any} told @param {Opened} opened @param {Individual | undefined} leader Of the generation that is shown. @param {Engine} engine @param {AbortSignal} [signal] */
async function checkDrive(told, { experiment, trial, ...run }, leader, engine, signal) {
  if (!Array.isArray(told?.gains)) throw new Error(words.damagedFile('drive'));
  const gains = gainsOf({ ...run, population: leader ? [leader] : [] }, run.driver, engine.paper());
  const [said, found] = [told.gains, gains].map((one) => JSON.stringify(one));
  if (said !== found) throw new Error(words.otherGains(said, found));
  const alone = drivenIn({ experiment, trial });
  const [cost] = await engine.surveys.costs([[alone, gains]], { signal });
  if (!cameTo(told.cost, cost)) throw new Error(words.otherCost(JSON.stringify(told.cost), cost));
  // Older files do not have it.
  if (told.experiment !== undefined && !isSame(told.experiment, engine.experiment(alone), engine))
    throw new Error(words.changedFile('drive.experiment'));
}

/** Also where the file was written before some field was there. @param {any} told @param {Experiment} found @param {Engine} engine */
function isSame(told, found, engine) {
  try {
    return JSON.stringify(engine.experiment(told)) === JSON.stringify(found);
  } catch {
    return false;
  }
}

/** @param {string} text @returns {Record<string, any>} */
function parse(text) {
  if (text.length > mostCharacters) throw new Error(words.largeFile);
  try {
    const content = JSON.parse(text);
    if (content !== null && typeof content === 'object') return content;
  } catch {
    if (text.includes(`"${format}"`)) throw new Error(words.cutFile);
  }
  throw new Error(text.includes(mark) ? words.handInFile : words.foreignFile);
}
