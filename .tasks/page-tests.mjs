// The tests of the built page: which files there are, and the processes that share them.
import { mkdirSync, readdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, dirname, join } from 'node:path';
import { Failure, top } from './run.mjs';

/** @typedef {import('../tests/page/harness/engines.js').EngineName} EngineName */
/** A process, the files that it takes one after the other, and what it is told; some share their files, and what is left of others' another takes after its own. @typedef {{ files: string[], env: Record<string, string>, after?: Lane }} Lane */

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

/** Whether a file of tests wants the book or the wheel. @param {string} file */
export const needsExamples = (file) =>
  readFileSync(join(top, folder, file), 'utf8').includes('.tasks/examples.mjs');

/** How many seconds each file took when it ran last on this machine. */
const lastTime = join(top, '.tools', 'page-tests.json');
/** @returns {Record<string, number>} */
function lastSeconds() {
  try {
    return JSON.parse(readFileSync(lastTime, 'utf8'));
  } catch {
    return {};
  }
}

/** @param {Record<string, number>} seconds */
export function keepSeconds(seconds) {
  mkdirSync(dirname(lastTime), { recursive: true });
  writeFileSync(lastTime, JSON.stringify({ ...lastSeconds(), ...seconds }, null, 1));
}

/** Those that take the longest first, so that in the end no process is left alone with one; of what never ran, those that go through all views, or are long themselves. @param {readonly string[]} files */
function sorted(files) {
  const seconds = lastSeconds();
  const weighed = files.map((file) => {
    const text = readFileSync(join(top, folder, file), 'utf8');
    return { file, weight: seconds[file] ?? text.length / 500 + (text.includes('/views.js') ? 1000 : 0) };
  });
  return weighed.sort((a, b) => b.weight - a.weight).map(({ file }) => file);
}

/** How tests of each kind are declared, in the file itself. */
const declared = {
  logic: /\btest\b[^}]*\} from '[./]*harness\/once\.js'/,
  page: /\bpageTest\b/,
  engine: /\bengineTest\b/,
};

/** The files that have tests of a kind: to load another takes its time. @param {readonly string[]} files @param {import('../tests/page/harness/once.js').Kind} kind */
function having(files, kind) {
  const found = files.map((file) => {
    const text = readFileSync(join(top, folder, file), 'utf8');
    if (!Object.values(declared).some((one) => one.test(text)))
      throw new Failure(`${file} has no test that harness/browsers.js or harness/once.js declares`);
    return declared[kind].test(text) ? file : '';
  });
  return found.filter(Boolean);
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
  const page = { files: sorted(having(files, 'page')), env: browser('page', first) };
  const after = late > 0 ? page : undefined;
  return [
    { files: having(files, 'logic'), env: { PAGE_TESTS: 'logic' } },
    ...Array.from({ length: atOnce }, () => page),
    ...engines.map((engine) => ({ files: having(files, 'engine'), env: browser('engine', engine), after })),
  ];
}
