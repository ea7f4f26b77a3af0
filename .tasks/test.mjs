// npm test: every check of the project, side by side as far as they do not need each other; when one fails, no
// other begins.
//
//   npm test -- page               only the page, in the browsers of this machine
//   npm test -- --require-engines  an absent browser, or Python, is a failure
//   ENGINES=firefox npm test       only these browsers
import { join } from 'node:path';
import { parseArgs } from 'node:util';
import { findEngines } from '../tests/page/harness/engines.js';
import { buildCore, buildSite } from './build.mjs';
import { absentPython, findPython, finishExamples, prepareExamples } from './examples.mjs';
import { Failure, run, runPackage, step, stopSteps, task } from './run.mjs';
import { installPackages, installTestTools, installTools } from './tools.mjs';

const count = { passed: 0, failed: 0 };

await task(async () => {
  const { values, positionals } = parseArgs({
    allowPositionals: true,
    options: { 'require-engines': { type: 'boolean', default: false } },
  });
  const strangers = positionals.filter((name) => name !== 'page');
  if (strangers.length > 0) throw new Failure(`npm test knows only "page", not ${strangers.join(', ')}`);

  const { found, absent } = findEngines();
  const python = findPython();
  const advice = [...absent, ...(python === null ? [absentPython] : [])]
    .map(({ name, hint }) => `\nAbsent, and what needs it was not tested: ${name}; to have it: ${hint}`)
    .join('');
  if (values['require-engines'] && advice !== '') throw new Failure(`everything is required${advice}`);

  const undriven = found.some(({ name, driver }) => name === 'firefox' && driver === null);
  const pageOnly = positionals.length > 0;
  await installPackages();
  const tools = installTools({ others: true });
  const testTools = tools.then(() => installTestTools({ geckodriver: undriven }));
  const sources = pageOnly ? tools : testSources();
  const modules = Promise.all([testTools, sources]).then(() => (pageOnly ? undefined : testModule()));
  const examples = python === null ? tools : prepareExamples(python);
  const page = tools.then(async () => {
    await buildCore();
    if (!pageOnly) await testTypes();
    await buildSite();
    await examples;
    if (python !== null) await finishExamples();
    // What is wrong in the sources is known soon, the page's tests take the longest.
    await Promise.all([sources, testTools]);
    await testPage(found.map(({ name }) => name));
  });
  await together([sources, testTools, modules, examples, page]);
  console.log(`\nEngines that ran: ${found.map(({ name }) => name).join(', ') || 'none'}${advice}`);
}).finally(() => console.log(`\n${count.passed} passed, ${count.failed} failed`));

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

/** @param {string[]} target */
function clippy(...target) {
  return run('cargo', ['clippy', ...target, '--', '-D', 'warnings']);
}

/** What needs nothing but cargo and the npm packages. */
async function testSources() {
  await step('format of the Rust (cargo fmt mends it)', () => run('cargo', ['fmt', '--check']));
  await step('format and lint of the JavaScript (npm run format mends it)', () =>
    runPackage('@biomejs/biome/bin/biome', ['check', '.']),
  );
  await step('lint of the Rust', () => clippy('--all-targets'));
  await step('native tests', () => counted('cargo', ['test']));
}

/** The core as WebAssembly. With every optimisation the tests of the page run it, under Node and in the browsers. */
async function testModule() {
  await step('lint of the Rust for WebAssembly', () => clippy('--lib', '--target', 'wasm32-unknown-unknown'));
  await step('the same tests as WebAssembly under Node', () => counted('wasm-pack', ['test', '--node']));
  await step('the known values with every optimisation, natively', () =>
    counted('cargo', ['test', '--release', '--test', 'golden']),
  );
}

/** They rest on the types of the core, which its build writes. */
function testTypes() {
  return step('types of the JavaScript', () => runPackage('typescript/bin/tsc', ['-p', 'www']));
}

/** The engines side by side, for each spends much of its time waiting; beside them, once, what needs no browser. @param {string[]} engines */
function testPage(engines) {
  const args = ['--test-reporter=spec', join('tests', 'page', 'harness', 'every.js')];
  return step('tests of the built page in real browsers', async () => {
    const runs = [
      counted(process.execPath, args, { PAGE_TESTS: 'without browsers' }),
      ...engines.map((engine) =>
        counted(process.execPath, args, { PAGE_TESTS: 'in browsers', ENGINES: engine }),
      ),
    ];
    await together(runs);
  });
}

/**
 * Runs tests and adds up what their closing lines count, also if some fail.
 * @param {string} program
 * @param {string[]} args
 * @param {Record<string, string>} [env]
 */
async function counted(program, args, env) {
  /** @param {string} output */
  const add = (output) => {
    for (const [, passed, failed] of output.matchAll(/test result: .*?(\d+) passed; (\d+) failed/g)) {
      count.passed += Number(passed);
      count.failed += Number(failed);
    }
    for (const [, kind, number] of output.matchAll(/^\S+ (pass|fail|cancelled) (\d+)/gm)) {
      count[kind === 'pass' ? 'passed' : 'failed'] += Number(number);
    }
  };
  try {
    add(await run(program, args, { env, keepColours: false }));
  } catch (error) {
    if (error instanceof Failure) add(error.output);
    throw error;
  }
}
