// What every task needs: steps with a name and a time, child processes, and failures told in one line.
import { spawn, spawnSync } from 'node:child_process';
import { once } from 'node:events';
import { existsSync, readdirSync, realpathSync, statSync } from 'node:fs';
import { getPriority, setPriority } from 'node:os';
import { basename, dirname, join } from 'node:path';
import { fileURLToPath, pathToFileURL } from 'node:url';

/** The folder that holds package.json. */
export const top = fileURLToPath(new URL('..', import.meta.url));

/** A failure whose message says all there is to say, so that no stack trace is shown. */
export class Failure extends Error {
  /** What the program that failed had printed. */
  output = '';
}

/** Runs a whole task: its failure is printed and becomes the exit code. @param {() => Promise<void>} body */
export async function task(body) {
  process.chdir(top);
  hearSignals();
  try {
    await body();
  } catch (error) {
    const misspelt =
      error instanceof TypeError && 'code' in error && String(error.code).startsWith('ERR_PARSE_ARGS');
    console.error(error instanceof Failure || misspelt ? `\n✗ ${error.message}` : error);
    process.exitCode = 1;
  }
}

let stopped = false;

/** Lets no further step begin: another one has failed. */
export function stopSteps() {
  stopped = true;
}

let hears = false;

/** What has begun would go on alone when a task is ended. */
function hearSignals() {
  if (hears) return;
  hears = true;
  for (const signal of /** @type {const} */ (['SIGTERM', 'SIGHUP']))
    process.on(signal, async () => {
      stopSteps();
      const ended = [...running].map((child) => once(child, 'close'));
      for (const child of running) child.kill(signal);
      await Promise.all(ended);
      process.exit(1);
    });
}

/**
 * Runs one named step and tells how long it took.
 * @template T
 * @param {string} name
 * @param {() => T | Promise<T>} body
 * @param {string} [usual] how long it usually takes
 * @returns {Promise<T>}
 */
export async function step(name, body, usual) {
  if (stopped) throw new Failure(`${name}: not begun`);
  console.log(`\n▸ ${name}${usual ? `, usually ${usual}` : ''}`);
  const start = performance.now();
  const seconds = () => `${((performance.now() - start) / 1000).toFixed(1)} s`;
  try {
    const result = await body();
    console.log(`✓ ${name}, ${seconds()}`);
    return result;
  } catch (error) {
    if (!(error instanceof Failure)) throw error;
    error.message = `${name}: ${error.message} (after ${seconds()})`;
    console.error(`✗ ${error.message}`);
    throw error;
  }
}

/** The programs that run now. @type {Set<import('node:child_process').ChildProcess>} */
const running = new Set();

/**
 * Runs a program to its end and returns its standard output, which is shown as it comes.
 * @param {string} program
 * @param {string[]} args
 * @param {{ env?: Record<string, string>, keepColours?: boolean, yields?: boolean, next?: () => string }} [options] keepColours hands the terminal to the program, and then nothing is returned; with yields all others go first; next answers each message of a program of Node
 * @returns {Promise<string>}
 */
export function run(program, args, { env = {}, keepColours = true, yields = false, next } = {}) {
  return new Promise((resolve, reject) => {
    const child = spawn(program, args, {
      cwd: top,
      env: { ...process.env, ...env },
      stdio: [
        'ignore',
        keepColours ? 'inherit' : 'pipe',
        'inherit',
        ...(next ? [/** @type {const} */ ('ipc')] : []),
      ],
    });
    running.add(child);
    child.on('close', () => running.delete(child));
    if (next) child.on('message', () => child.send(next()));
    if (yields && child.pid) setPriority(child.pid, Math.max(10, getPriority()));
    let output = '';
    child.stdout?.setEncoding('utf8').on('data', (text) => {
      output += text;
      process.stdout.write(text);
    });
    child.on('error', (error) => reject(new Failure(`${program} does not start: ${error.message}`)));
    child.on('close', (code, signal) => {
      if (code === 0) resolve(output);
      else {
        const end = signal ?? `exit code ${code}`;
        const failure = new Failure(
          `${[program, ...args].map((word) => basename(word)).join(' ')} ended with ${end}`,
        );
        failure.output = output;
        reject(failure);
      }
    });
  });
}

/**
 * Runs a Node program of an installed package, which needs no shell on any system.
 * @param {string} file its path under node_modules
 * @param {string[]} args
 * @param {Parameters<typeof run>[2]} [options]
 */
export const runPackage = (file, args, options) =>
  run(process.execPath, [join(top, 'node_modules', file), ...args], options);

/**
 * npm itself, which names its own program to its scripts; calling that one needs no shell on Windows.
 * @param {string[]} args
 * @param {Parameters<typeof run>[2]} [options]
 */
export function npm(args, options) {
  const beside = join(dirname(process.execPath), 'node_modules/npm/bin/npm-cli.js');
  const program = process.env.npm_execpath ?? (process.platform === 'win32' ? beside : null);
  return program ? run(process.execPath, [program, ...args], options) : run('npm', args, options);
}

/** Whether this file is what Node was told to run, by whichever way to it. @param {string} url */
export const isProgram = (url) =>
  existsSync(process.argv[1] ?? '') && pathToFileURL(realpathSync(process.argv[1])).href === url;

/** What a program prints, or null if it is absent or fails. @param {string} program @param {string[]} args */
export function ask(program, args) {
  const { status, stdout } = spawnSync(program, args, { cwd: top, encoding: 'utf8' });
  return status === 0 ? stdout.trim() : null;
}

/**
 * The time of the latest change in files and folders, in milliseconds; an absent one counts as never changed.
 * @param {string[]} paths relative to the top folder
 * @returns {number}
 */
export function lastChange(...paths) {
  const times = paths.map((path) => {
    const full = join(top, path);
    if (!existsSync(full)) return 0;
    const status = statSync(full);
    if (!status.isDirectory()) return status.mtimeMs;
    return Math.max(status.mtimeMs, lastChange(...readdirSync(full).map((name) => join(path, name))));
  });
  return Math.max(0, ...times);
}

/** @param {string} site the folder of a built site */
export function needBuilt(site) {
  if (!existsSync(join(site, 'index.html'))) throw new Failure(`no built site in ${site}: npm run build`);
}
