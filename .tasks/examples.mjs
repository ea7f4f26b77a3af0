// What Python builds, beside the examples that run as they are: the book, and the wheel of python/.
//
//   node .tasks/examples.mjs   after npm run build
import { cpSync, existsSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join } from 'node:path';
import { pythons } from '../tests/page/harness/engines.js';
import { buildBytes } from './build.mjs';
import { ask, Failure, isProgram, run, step, task, top } from './run.mjs';

const requirements = 'examples/requirements.txt';
/** Large, and of each machine's own code: where they cannot be had, the optimisers are not tested. */
const optimisers = 'examples/optimisers/requirements.txt';
const environment = '.tools/python';
/** Holds what was installed. Written last, so that what was interrupted is done again. */
const stamp = `${environment}/.complete`;
const output = 'target/examples';

/** The Python that has what the examples need, once it is installed. */
export const python = join(
  top,
  environment,
  ...(process.platform === 'win32' ? ['Scripts', 'python.exe'] : ['bin', 'python']),
);
/** The book, with the site beside it as ep/. */
export const book = join(top, output, 'book', '_build', 'html');

/** What is installed, by a Python that is still there. */
const installed = () =>
  existsSync(stamp) && ask(python, ['-c', 'import jupyter_book']) !== null ? readFileSync(stamp, 'utf8') : '';

/** All that is to be installed. */
const wanted = () => [requirements, optimisers].map((file) => readFileSync(file, 'utf8')).join('');

/** Whether the book and the widget are there to be tested. */
export const areBuilt = () => existsSync(join(book, 'ep')) && existsSync(python);

/** What to say where there is none. */
export const absentPython = {
  name: 'Python 3.11 or newer with venv',
  hint: 'python.org; on Debian "apt install python3-venv"',
};

/** A Python that can install packages, or null. */
export function findPython() {
  const works = 'import sys, venv, ensurepip; assert sys.version_info >= (3, 11)';
  return pythons.find((name) => ask(name, ['-c', works]) !== null) ?? null;
}

/** Installs what is missing, and builds the book, neither of which needs the site. @param {string} program */
export async function prepareExamples(program) {
  const before = installed();
  if (before !== wanted()) {
    const isBegun = before === readFileSync(requirements, 'utf8');
    await step('installing the Python packages of the examples', () => install(program, isBegun), '1 minute');
  }
  await step('building the book', async () => {
    rmSync(output, { recursive: true, force: true });
    const to = ['--path-output', `${output}/book`];
    // Not its program, which names the folder in which it was installed.
    const book = ['-c', 'from jupyter_book.cli.main import main; main()', 'build', 'examples/book'];
    await run(python, [...book, ...to, '--warningiserror', '--quiet'], { keepColours: false });
  });
}

/** @param {string} program @param {boolean} isBegun whether only the optimisers are lacking */
async function install(program, isBegun) {
  const packages = ['install', '--no-compile', '--no-deps', '--requirement'];
  if (!isBegun) {
    rmSync(environment, { recursive: true, force: true });
    await run(program, ['-m', 'venv', environment]);
    await pip(...packages, requirements);
    writeFileSync(stamp, readFileSync(requirements, 'utf8'));
  }
  try {
    await pip(...packages, optimisers, '--only-binary', ':all:');
    writeFileSync(stamp, wanted());
  } catch {
    console.log(`Absent, and what needs them was not tested: the packages of ${optimisers}`);
  }
}

/** What needs the site: the book shows its figures, the wheel holds its page, and a core of its own. */
export async function finishExamples() {
  await buildBytes();
  await step('building the wheel for Python', async () => {
    cpSync('dist', join(book, 'ep'), { recursive: true });
    for (const name of wheels()) rmSync(join(output, name));
    await pip('wheel', '--no-deps', '--no-build-isolation', '--wheel-dir', output, './python');
    const [wheel] = wheels();
    await pip('install', '--no-deps', '--force-reinstall', join(output, wheel));
  });
}

const wheels = () => readdirSync(output).filter((name) => name.endsWith('.whl'));

/** @param {string[]} args */
const pip = (...args) => run(python, ['-m', 'pip', '--quiet', '--disable-pip-version-check', ...args]);

if (isProgram(import.meta.url)) {
  await task(async () => {
    const program = findPython();
    if (program === null) throw new Failure(`${absentPython.name} is needed: ${absentPython.hint}`);
    await prepareExamples(program);
    await finishExamples();
  });
}
