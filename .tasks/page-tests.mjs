// The tests of the built page: which files there are, and the processes that share them.
import { readdirSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { top } from './run.mjs';

/** @typedef {import('../tests/page/harness/engines.js').EngineName} EngineName */
/** Processes one after the other, and what they are told; some lanes share their lists. @typedef {{ lists: string[][], env: Record<string, string> }} Lane */

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

/** Lists of files about as long as each other. @param {readonly string[]} files @param {number} count */
function shared(files, count) {
  const lists = Array.from({ length: count }, () => ({ size: 0, files: /** @type {string[]} */ ([]) }));
  const sized = files.map((file) => ({ file, size: statSync(join(top, folder, file)).size }));
  for (const { file, size } of sized.sort((a, b) => b.size - a.size)) {
    const [shortest] = [...lists].sort((a, b) => a.size - b.size);
    shortest.files.push(file);
    shortest.size += size;
  }
  return lists.map((list) => list.files.sort()).filter((list) => list.length > 0);
}

/**
 * Who runs what, side by side, for each spends much of its time waiting: the first engine, which has the most to do, in
 * several processes, each of which takes the next list of files when it has done one; each other engine what engines can do
 * differently; and once what needs no browser.
 * @param {readonly EngineName[]} engines @param {string[]} files @param {number} late milliseconds by which every frame of the first engine comes late
 * @returns {Lane[]}
 */
export function lanesOf(engines, files, late) {
  const [first, ...others] = engines;
  const browser = (/** @type {EngineName} */ engine) => ({
    PAGE_TESTS: 'in browsers',
    ENGINES: engine,
    FIRST_ENGINE: first,
    LATE_FRAMES: String(engine === first ? late : 0),
  });
  // Who waits for late frames leaves the machine to others.
  const atOnce = !first ? 0 : late > 0 ? 5 : 2;
  const lists = shared(files, 5 * atOnce);
  return [
    { lists: [files], env: { PAGE_TESTS: 'without browsers' } },
    ...Array.from({ length: atOnce }, () => ({ lists, env: browser(first) })),
    ...others.map((engine) => ({ lists: [files], env: browser(engine) })),
  ];
}
