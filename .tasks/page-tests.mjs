// The tests of the built page: which files there are, and the processes that share them.
import { readdirSync, statSync } from 'node:fs';
import { basename, join } from 'node:path';
import { top } from './run.mjs';

/** @typedef {import('../tests/page/harness/engines.js').EngineName} EngineName */
/** One process and what it is told. @typedef {{ name: string, files: string[], env: Record<string, string> }} Lane */

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

/** Two lists of files about as long as each other. @param {readonly string[]} files */
function halvesOf(files) {
  /** @type {{ size: number, files: string[] }[]} */
  const halves = [
    { size: 0, files: [] },
    { size: 0, files: [] },
  ];
  const sized = files.map((file) => ({ file, size: statSync(join(top, folder, file)).size }));
  for (const { file, size } of sized.sort((a, b) => b.size - a.size)) {
    const [shorter] = [...halves].sort((a, b) => a.size - b.size);
    shorter.files.push(file);
    shorter.size += size;
  }
  return halves.map((half) => half.files.sort());
}

/**
 * Who runs what, side by side, for each spends much of its time waiting: the first engine, which has the most to do, in
 * two processes; each other engine what engines can do differently; and once what needs no browser.
 * @param {readonly EngineName[]} engines @param {string[]} files @param {number} late milliseconds by which every frame comes late
 * @returns {Lane[]}
 */
export function lanesOf(engines, files, late) {
  const [first, ...others] = engines;
  const browser = (/** @type {EngineName} */ engine) => ({
    PAGE_TESTS: 'in browsers',
    ENGINES: engine,
    FIRST_ENGINE: first,
    LATE_FRAMES: String(late),
  });
  const [one, other] = halvesOf(files);
  return [
    { name: 'without browsers', files, env: { PAGE_TESTS: 'without browsers' } },
    ...(first ? [one, other] : [])
      .filter((half) => half.length > 0)
      .map((half) => ({ name: first, files: half, env: browser(first) })),
    ...others.map((engine) => ({ name: engine, files, env: browser(engine) })),
  ];
}
