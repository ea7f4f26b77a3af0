// npm test: every check of the project, side by side as far as they do not need each other; when one fails, no
// other begins.
//
//   npm test -- page               only the page, in the browsers of this machine
//   npm test -- plane keys         only the files of tests of these names, those of the page in one browser
//   npm test -- --require-engines  an absent browser, or Python, is a failure
//   npm test -- --late             in the first browser frames and workers come 120 ms late; alone: npm run test:late
//   ENGINES=firefox npm test       only these browsers
import { existsSync } from 'node:fs';
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { findEngines } from '../tests/page/harness/engines.js';
import { buildCore, buildSite } from './build.mjs';
import { absentPython, areBuilt, findPython, finishExamples, prepareExamples } from './examples.mjs';
import { filesOf, keepSeconds, lanesOf, needsExamples, testFiles } from './page-tests.mjs';
import { Failure, lastChange, run, runPackage, step, stopSteps, task, top } from './run.mjs';
import { installPackages, installTestTools, installTools } from './tools.mjs';

const count = { passed: 0, failed: 0 };

/** What the site is built of. */
const siteSources = ['www', 'index.html', 'pkg', '.tasks', 'package-lock.json', 'tests/golden.json'];

/** So late a frame, or an answer of a worker, comes on a machine with much to do. */
const lateFrame = 120;

await task(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: {
      'require-engines': { type: 'boolean', default: false },
      late: { type: 'boolean', default: false },
    },
  });
  const late = values.late ? lateFrame : 0;
  const names = positionals.filter((name) => name !== 'page');
  if (names.length > 0) await testNamed(names, late);
  else await testAll({ pageOnly: positionals.length > 0, isStrict: values['require-engines'], late });
}).finally(() => console.log(`\n${count.passed} passed, ${count.failed} failed`));

/** Files of tests by their names, with no more built than they need. @param {string[]} names @param {number} late */
async function testNamed(names, late) {
  const found = names.map((name) => ({
    name,
    page: filesOf(name),
    rust: existsSync(join(top, 'tests', `${name}.rs`)),
  }));
  const strangers = found.filter(({ page, rust }) => page.length === 0 && !rust);
  if (strangers.length > 0)
    throw new Failure(`no file of tests is called ${strangers.map(({ name }) => name).join(', ')}`);
  await installPackages();
  const rust = found.filter((one) => one.rust).flatMap(({ name }) => ['--test', name]);
  if (rust.length > 0) await step('native tests', () => counted('cargo', ['test', ...rust]));
  const files = found.flatMap(({ page }) => page);
  if (files.length === 0) return;
  await installTools();
  await buildCore();
  // What is written last.
  if (lastChange('dist/embed.js') < lastChange(...siteSources)) await buildSite();
  if (areBuilt() && files.some(needsExamples)) await finishExamples();
  const { found: all, absent } = findEngines();
  const engines = process.env.ENGINES ? all : all.slice(0, 1);
  if (engines.some(isUndriven)) await installTestTools();
  await testPage(namesOf(engines), files, late);
  const advice = engines.length > 0 ? '' : adviceOn(absent);
  if (count.passed + count.failed === 0) throw new Failure(`nothing of it could be tested${advice}`);
  console.log(advice);
}

/** @param {readonly { name: string, hint: string }[]} absent */
function adviceOn(absent) {
  return absent
    .map(({ name, hint }) => `\nAbsent, and what needs it was not tested: ${name}; to have it: ${hint}`)
    .join('');
}

/** @typedef {import('../tests/page/harness/engines.js').Engine} Engine */

/** @param {readonly Engine[]} engines */
function namesOf(engines) {
  return engines.map(({ name }) => name);
}

/** Whether the engine has no WebDriver, which no package ships. @param {Engine} engine */
function isUndriven({ name, driver }) {
  return name === 'firefox' && driver === null;
}

/** @param {{ pageOnly: boolean, isStrict: boolean, late: number }} what */
async function testAll({ pageOnly, isStrict, late }) {
  const { found, absent } = findEngines();
  const python = findPython();
  const advice = adviceOn([...absent, ...(python === null ? [absentPython] : [])]);
  if (isStrict && advice !== '') throw new Failure(`everything is required${advice}`);

  const engines = pageOnly && late > 0 ? found.slice(0, 1) : found;
  const undriven = engines.some(isUndriven);
  await installPackages();
  const tools = installTools({ others: undriven });
  const testTools = tools.then(() => (undriven ? installTestTools() : undefined));
  const sources = pageOnly ? tools : testSources();
  const modules = Promise.all([tools, sources]).then(() => (pageOnly ? undefined : testModule()));
  const examples = python === null ? tools : prepareExamples(python);
  const page = tools.then(async () => {
    await buildCore();
    if (!pageOnly) await testTypes();
    await buildSite();
    await examples;
    if (python !== null) await finishExamples();
    // What is wrong in the sources is known soon, the page's tests take the longest.
    await Promise.all([sources, testTools]);
    await testPage(namesOf(engines), testFiles(), late);
  });
  await together([sources, testTools, modules, examples, page]);
  console.log(`\nEngines that ran: ${namesOf(engines).join(', ') || 'none'}${advice}`);
}

/** Waits for all of them, also when one has failed, because its programs would go on alone. @param {Promise<unknown>[]} lanes */
async function together(lanes) {
  /** @type {unknown[]} */
  const reasons = [];
  for (const lane of lanes)
    lane.catch((reason) => {
      reasons.push(reason);
      stopSteps();
    });
  await Promise.allSettled(lanes);
  if (reasons.length > 0) throw reasons[0];
}

/** @param {string[]} target @param {Parameters<typeof run>[2]} [options] */
function clippy(target, options) {
  return run('cargo', ['clippy', ...target, '--', '-D', 'warnings'], options);
}

/** What needs nothing but cargo and the npm packages. */
async function testSources() {
  await step('format of the Rust (cargo fmt mends it)', () => run('cargo', ['fmt', '--check']));
  await step('format and lint of the JavaScript (npm run format mends it)', () =>
    runPackage('@biomejs/biome/bin/biome', ['check', '.']),
  );
  await step('lint of the Rust', () => clippy(['--all-targets']));
  await step('native tests', async () => {
    await counted('cargo', ['test', '--lib', '--test', 'all']);
    await counted('cargo', ['test', '--doc']);
  });
}

/**
 * The core as WebAssembly. With every optimisation the tests of the page run it, under Node and in the browsers; to those, which
 * take the longest, it leaves the machine.
 */
async function testModule() {
  const yields = true;
  const target = ['--target', 'wasm32-unknown-unknown'];
  await step('lint of the Rust for WebAssembly', async () => {
    await clippy(['--lib', ...target], { yields });
    await clippy(['--lib', ...target, '--no-default-features', '--features', 'bytes'], { yields });
  });
  await step('the known values natively, with the core fully optimised', () =>
    // Not as a release, which would compile every library anew.
    counted('cargo', ['test', '--test', 'golden'], { env: { CARGO_PROFILE_TEST_OPT_LEVEL: '3' }, yields }),
  );
  await step('the same tests as WebAssembly under Node', () =>
    // A panic loses the instance that it happens in.
    counted('cargo', ['test', ...target, '--test', 'all', '--test', 'panics'], {
      env: { CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUNNER: 'wasm-bindgen-test-runner' },
      yields,
    }),
  );
}

/** They rest on the types of the core, which its build writes. */
function testTypes() {
  return step('types of the JavaScript', () => runPackage('typescript/bin/tsc', ['-p', 'www']));
}

/** @param {Parameters<typeof lanesOf>} lanes */
function testPage(...lanes) {
  return step('tests of the built page in real browsers', () => together(lanesOf(...lanes).map(runLane)));
}

/** @param {import('./page-tests.mjs').Lane} lane */
async function runLane({ files, env, after }) {
  let isDone = false;
  /** @type {Record<string, number>} */
  const seconds = {};
  let [file, began] = ['', 0];
  const next = () => {
    const now = performance.now();
    if (file !== '') seconds[file] = (now - began) / 1000;
    [file, began] = [files.shift() ?? '', now];
    isDone = file === '';
    return file;
  };
  const every = join('tests', 'page', 'harness', 'every.js');
  await counted(process.execPath, ['--test-reporter=spec', every], { env, next });
  if (env.PAGE_TESTS === 'page') keepSeconds(seconds);
  if (!isDone) throw new Failure('a process of tests ended before its files were done');
  if (after && after.files.length > 0) await runLane(after);
}

/**
 * Runs tests and adds up what their closing lines count, also if some fail.
 * @param {string} program
 * @param {string[]} args
 * @param {Parameters<typeof run>[2]} [options]
 */
async function counted(program, args, options) {
  /** @param {string} output */
  const add = (output) => {
    for (const [, passed, failed] of output.matchAll(/test result: .*?(\d+) passed; (\d+) failed/g)) {
      count.passed += Number(passed);
      count.failed += Number(failed);
    }
    for (const [, kind, number] of output.matchAll(/^\S+ (pass|fail|cancelled) (\d+)/gm)) {
      count[kind === 'pass' ? 'passed' : 'failed'] += Number(number);
    }
    // What waits for them is none itself.
    count.passed -= [...output.matchAll(/^✔ files of tests are loaded/gm)].length;
  };
  try {
    add(await run(program, args, { ...options, keepColours: false }));
  } catch (error) {
    if (error instanceof Failure) add(error.output);
    throw error;
  }
}
