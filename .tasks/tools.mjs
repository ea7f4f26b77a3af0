// Installs what is missing: the wasm target, the npm packages, and the Rust tools that no package ships, which go into
// the folder .tools/ so that nothing else on the machine changes.
import { existsSync, readFileSync, rmSync } from 'node:fs';
import { delimiter, join } from 'node:path';
import { ask, Failure, lastChange, npm, run, step, top } from './run.mjs';

const bin = join(top, '.tools', 'bin');
const build = join(top, '.tools', 'build');

/** What checks and tests the sources natively: quick, beside the tools that are built. */
export async function installPackages() {
  preparePath();
  await checkToolchain();
  await installNpmPackages();
}

/**
 * Everything that builds the page.
 * @param {{ others?: boolean }} [soon] other tools follow, which share compiled dependencies with these
 */
export async function installTools({ others = false } = {}) {
  await installPackages();
  await installWasmBindgen();
  if (!others) removeLeftovers();
}

/** What only tests need: the WebDriver of Firefox. */
export async function installTestTools() {
  await cargoInstall('geckodriver', ['--version', '0.37.1'], 'it drives Firefox in the page tests');
  removeLeftovers();
}

/** What the tools were built from is only a load on the disk afterwards. */
const removeLeftovers = () => rmSync(build, { recursive: true, force: true });

/** Lets child processes find the tools, their own children included. */
function preparePath() {
  if (!process.env.PATH?.startsWith(bin)) process.env.PATH = bin + delimiter + process.env.PATH;
  if (process.env.RUSTFLAGS === undefined) return;
  console.log('RUSTFLAGS is set aside, because it would replace the flags of .cargo/config.toml');
  delete process.env.RUSTFLAGS;
}

async function checkToolchain() {
  const [major, minor] = process.versions.node.split('.').map(Number);
  if (!((major === 20 && minor >= 19) || (major === 22 && minor >= 12) || major > 22)) {
    throw new Failure(
      `Node ${process.versions.node} cannot build this: Node 20.19, 22.12 or newer is needed`,
    );
  }
  const sysroot = ask('rustc', ['--print', 'sysroot']);
  if (sysroot === null || ask('cargo', ['--version']) === null) {
    throw new Failure('rustc and cargo are needed: install Rust with rustup, see https://rustup.rs');
  }
  const missing = [
    !existsSync(join(sysroot, 'lib', 'rustlib', 'wasm32-unknown-unknown')) && [
      'target',
      'wasm32-unknown-unknown',
    ],
    ask('cargo', ['fmt', '--version']) === null && ['component', 'rustfmt'],
    ask('cargo', ['clippy', '--version']) === null && ['component', 'clippy'],
  ].filter((part) => part !== false);
  for (const [kind, name] of missing) {
    await step(`installing the Rust ${kind} ${name}`, () => run('rustup', [kind, 'add', name]));
  }
}

async function installNpmPackages() {
  if (lastChange('node_modules/.package-lock.json') >= lastChange('package-lock.json')) return;
  const install = () => npm(['ci', '--include=dev', '--no-audit', '--no-fund']);
  await step('installing the npm packages', install, '5 to 60 s');
}

/** It must be of exactly the version of the library that it serves, and needs its test runner beside it. */
async function installWasmBindgen() {
  const lock = readFileSync(join(top, 'Cargo.lock'), 'utf8');
  const version = /name = "wasm-bindgen"\r?\nversion = "(.+)"/.exec(lock)?.[1];
  if (version === undefined)
    throw new Failure('Cargo.lock does not name wasm-bindgen: run "cargo generate-lockfile"');
  const programs = ['wasm-bindgen', 'wasm-bindgen-test-runner'];
  if (programs.every((program) => ask(program, ['--version'])?.endsWith(` ${version}`))) return;
  const options = ['--version', version, '--no-default-features'];
  await cargoInstall(
    'wasm-bindgen-cli',
    options,
    `it joins the core to JavaScript, and Cargo.lock wants ${version}`,
  );
}

/**
 * A debug build takes a third of a release build's time, and what the tool then does takes no longer to notice.
 * @param {string} name
 * @param {string[]} options
 * @param {string} reason
 */
async function cargoInstall(name, options, reason) {
  console.log(`\n${name} is missing: ${reason}. It is built into .tools/ once.`);
  const env = { CARGO_TARGET_DIR: build, CARGO_PROFILE_DEV_DEBUG: '0' };
  const args = ['install', name, ...options, '--debug', '--force', '--root', join(top, '.tools')];
  await step(`building ${name}`, () => run('cargo', args, { env }), '1 to 2 minutes');
}
