// Runs controllers as the programs that they are: in each language all of them in one process.
import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { languages } from '../../../www/share/code/languages.js';
import { findProgram, pythons } from '../harness/engines.js';

/** @typedef {import('../../../www/share/code/controller.js').Controller} Controller */
/** @typedef {import('../../../www/share/code/languages.js').LanguageName} LanguageName */
/** @typedef {import('../../../www/share/code/parts.js').Words['comments']} Comments */
/** What a program came to: t_f, J, x, y, θ. @typedef {readonly number[]} Numbers */
/** @typedef {{ name: string, text: string }} Program */

const python = findProgram(pythons);
const compiler = findProgram(['cc', 'gcc', 'clang']);
const octave = findProgram(['octave-cli', 'octave']);

/** @param {string} text @returns {Numbers} */
const numbersOf = (text) => JSON.parse(text).map(Number);

const pythonRunner = `
import importlib, json, sys
sys.path.insert(0, ".")
sys.dont_write_bytecode = True
for name in open("names").read().split():
    time, cost, pose = importlib.import_module(name).drive()
    print(json.dumps([str(value) for value in (time, cost, *pose)]))
`;

/** All drives in one file: what stands at the top of each gets a name of its own. @param {readonly Program[]} programs */
function oneInC(programs) {
  const runs = programs.map(({ name, text }, i) => {
    const own = [
      ...text.matchAll(/^(?:static )?(?:const )?\w+ (?:\*)?(\w+)\(/gm),
      ...text.matchAll(/^typedef .*\b(\w+);/gm),
      ...[...text.matchAll(/^static const \w+ (.*);/gm)].flatMap(([, list]) => [
        ...list.matchAll(/(\w+) = /g),
      ]),
    ].map(([, one]) => one);
    const named = [...new Set(own)];
    return [
      ...named.map((one) => `#define ${one} ${one}_${i}`),
      `#include "${name}.c"`,
      `static void print_${i}(void)\n{\n    const Run run = drive();`,
      '    printf("[\\"%.17g\\",\\"%.17g\\",\\"%.17g\\",\\"%.17g\\",\\"%.17g\\"]\\n", (double)run.time, (double)run.cost,',
      '        (double)run.pose.x, (double)run.pose.y, (double)run.pose.theta);\n}',
      ...named.map((one) => `#undef ${one}`),
    ].join('\n');
  });
  const calls = programs.map((_, i) => `    print_${i}();`).join('\n');
  return `${runs.join('\n')}\nint main(void)\n{\n${calls}\n}\n`;
}

/** @param {string} folder @param {readonly Program[]} programs @param {readonly string[]} options */
function runC(folder, programs, options) {
  writeFileSync(join(folder, 'all.c'), oneInC(programs));
  const [source, program] = ['all.c', 'all'].map((name) => join(folder, name));
  const strict = ['-std=c99', '-pedantic', '-Wall', '-Wextra', '-Werror'];
  execFileSync(String(compiler), [...strict, ...options, source, '-o', program, '-lm'], { stdio: 'pipe' });
  return said(execFileSync(program, { encoding: 'utf8' }));
}

const said = (/** @type {string} */ text) =>
  text
    .replaceAll(/"(-?)inf"/gi, '"$1Infinity"')
    .trim()
    .split('\n')
    .map(numbersOf);

/** What a program prints of its own. @param {string} text @returns {Numbers[]} */
export function printed(text) {
  const values = [...text.matchAll(/^(?:t_f \(s\)|J|x \(m\)|y \(m\)|theta \(rad\)) +(\S+) +page (\S+)$/gm)];
  return Array.from({ length: values.length / 5 }, (_, i) =>
    values.slice(5 * i, 5 * i + 5).map(([, own]) => Number(own.replace(/inf/i, 'Infinity'))),
  );
}

/** @type {Record<LanguageName | 'float', { program: string | null, language: LanguageName, run: (folder: string, programs: readonly Program[]) => Numbers[] | Promise<Numbers[]> }>} */
export const runners = {
  python: {
    program: python,
    language: 'python',
    run: (folder) =>
      said(
        execFileSync(String(python), ['-c', pythonRunner], {
          cwd: folder,
          encoding: 'utf8',
        }),
      ),
  },
  c: {
    program: compiler,
    language: 'c',
    run: (folder, programs) => runC(folder, programs, ['-O0']),
  },
  float: {
    program: compiler,
    language: 'c',
    run: (folder, programs) => runC(folder, programs, ['-O0', '-DREAL=float']),
  },
  matlab: {
    program: octave,
    language: 'matlab',
    run: (folder, programs) =>
      printed(
        execFileSync(
          String(octave),
          ['--no-gui', '--norc', '--eval', programs.map(({ name }) => name).join('; ')],
          { cwd: folder, encoding: 'utf8' },
        ),
      ),
  },
  javascript: {
    program: process.execPath,
    language: 'javascript',
    run: (folder, programs) =>
      Promise.all(
        programs.map(async ({ name }) => {
          const { drive } = await import(pathToFileURL(join(folder, `${name}.mjs`)).href);
          const { time, cost, pose } = drive();
          return [time, cost, pose.x, pose.y, pose.theta];
        }),
      ),
  },
};

/** A folder that is there as long as it is used. @template T @param {(folder: string) => T | Promise<T>} use */
export async function inFolder(use) {
  const folder = mkdtempSync(join(tmpdir(), 'ep-locomotion-'));
  try {
    return await use(folder);
  } finally {
    rmSync(folder, { recursive: true });
  }
}

/** Writes controllers as programs and runs them. @param {keyof typeof runners} how @param {readonly Controller[]} controllers @param {(i: number) => Comments} wordsOf */
export function runAll(how, controllers, wordsOf) {
  const { language, run } = runners[how];
  const { write, ending } = languages[language];
  return inFolder((folder) => {
    const programs = controllers.map((controller, i) => ({
      name: controller.name,
      text: write(controller, wordsOf(i)),
    }));
    for (const { name, text } of programs) writeFileSync(join(folder, `${name}.${ending}`), text);
    writeFileSync(join(folder, 'names'), programs.map(({ name }) => name).join('\n'));
    return run(folder, programs);
  });
}

/** What a program prints when it is run as its head says. @param {LanguageName} language @param {Controller} controller @param {Comments} words */
export function printedBy(language, controller, words) {
  const { write, ending } = languages[language];
  return printedText(language, `${controller.name}.${ending}`, write(controller, words));
}

/** What a file prints when it is run. @param {LanguageName} language @param {string} file @param {string} text */
export function printedText(language, file, text) {
  const { program } = runners[language];
  return inFolder((folder) => {
    writeFileSync(join(folder, file), text);
    const run = (/** @type {string} */ command, /** @type {readonly string[]} */ args) =>
      execFileSync(command, args, { cwd: folder, encoding: 'utf8' });
    if (language === 'matlab')
      return run(String(program), ['--no-gui', '--norc', '--eval', file.replace(/\.m$/, '')]);
    if (language !== 'c') return run(String(program), [file]);
    run(String(program), [file, '-lm', '-o', 'drive']);
    return run(join(folder, 'drive'), []);
  });
}
