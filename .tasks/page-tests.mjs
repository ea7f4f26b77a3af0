// The tests of the built page: which files there are, and the processes that share them.
import { readdirSync, readFileSync } from 'node:fs';
import { basename, join } from 'node:path';
import { top } from './run.mjs';

/** @typedef {import('../tests/page/harness/engines.js').EngineName} EngineName */
/** A process, the files that it takes one after the other, and what it is told; some share their files. @typedef {{ files: string[], env: Record<string, string> }} Lane */

const folder = join('tests', 'page');

/** Every file of tests of the page, relative to their folder. */
export const testFiles = () =>
  readdirSync(join(top, folder), { recursive: true, encoding: 'utf8' })
    .filter((name) => name.endsWith('.test.js'))
    .map((name) => name.replaceAll('\\', '/'))
    .sort();

/** The files of a name, for instance of "plane" or "lab/plane". @param {string} name */
export const filesOf = (name) =>
  testFiles().filter((file) => file === `${name}.test.js` || basename(file) === `${name}.test.js`);

/** Those that take the longest first, so that in the end no process is left alone with one: they go through all views, or are long themselves. @param {readonly string[]} files */
function sorted(files) {
  const weighed = files.map((file) => {
    const text = readFileSync(join(top, folder, file), 'utf8');
    return { file, weight: text.length + (text.includes('/views.js') ? 1e6 : 0) };
  });
  return weighed.sort((a, b) => b.weight - a.weight).map(({ file }) => file);
}

/**
 * Who runs what, side by side, for each spends much of its time waiting: what the page does in every engine alike, in the first
 * one, in several processes, each of which takes the next file when it has done one; in each engine what engines can do
 * differently; and once what needs no browser.
 * @param {readonly EngineName[]} engines @param {string[]} files @param {number} late milliseconds by which every frame, and every answer of a worker, comes late in the first engine
 * @returns {Lane[]}
 */
export function lanesOf(engines, files, late) {
  const [first] = engines;
  /** @param {import('../tests/page/harness/once.js').Kind} kind @param {EngineName} engine */
  const browser = (kind, engine) => ({
    PAGE_TESTS: kind,
    ENGINES: engine,
    LATE_FRAMES: String(engine === first ? late : 0),
  });
  // Who waits for late frames leaves the machine to others.
  const atOnce = !first ? 0 : late > 0 ? 4 : 2;
  const shared = sorted(files);
  return [
    { files: [...files], env: { PAGE_TESTS: 'logic' } },
    ...Array.from({ length: atOnce }, () => ({ files: shared, env: browser('page', first) })),
    ...engines.map((engine) => ({ files: [...files], env: browser('engine', engine) })),
  ];
}
