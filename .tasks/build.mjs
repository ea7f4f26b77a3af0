// npm run build: the core as pkg/, the static site as dist/, and the whole page in dist/ep-locomotion.html.
//
//   npm run build -- core     only pkg/, which is all that npm pack needs
//   npm run build -- python   all, and the core without JavaScript: what a wheel of python/ holds
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { tidyGlue } from './glue.mjs';
import { Failure, isProgram, lastChange, run, runPackage, step, task, top } from './run.mjs';
import { installTools } from './tools.mjs';

/** Of the core, and of what stands beside it in pkg/. What stands in src/ in JavaScript goes with it as it is. */
const sources = () => [
  ...readdirSync(join(top, 'src'))
    .filter((name) => !/\.(js|d\.ts)$/.test(name))
    .map((name) => join('src', name)),
  ...['Cargo.toml', 'Cargo.lock', '.cargo', '.tasks/glue.mjs', '.tasks/build.mjs', 'package-lock.json'],
];
const wasm = 'pkg/ep_locomotion_bg.wasm';
/** The core for hosts without JavaScript, which the wheel of python/ holds. */
const bytesWasm = 'pkg/ep_locomotion_bytes.wasm';

/** The core, compiled, joined to JavaScript and optimised, unless nothing has changed. */
export async function buildCore() {
  await unlessBuilt(wasm, 'pkg/.complete', async () => {
    await step('compiling the core to WebAssembly', compile, '1 minute at first, then 10 s');
    await step('optimising the WebAssembly', () => optimise(wasm));
  });
  await buildLink();
}

/** The core without imports, unless nothing has changed. */
export const buildBytes = () =>
  unlessBuilt(bytesWasm, 'pkg/.complete-bytes', () =>
    step(
      'compiling the core for Python',
      async () => {
        mkdirSync('pkg', { recursive: true });
        copyFileSync(await compiled('--no-default-features', '--features', 'bytes'), bytesWasm);
        await optimise(bytesWasm);
      },
      '10 s',
    ),
  );

/**
 * Builds a module whose sources have changed.
 * @param {string} module
 * @param {string} stamp holds the time of the sources that were built. Written last, so that a build that was interrupted is done again
 * @param {() => Promise<void>} build
 */
async function unlessBuilt(module, stamp, build) {
  const sourceTime = String(lastChange(...sources()));
  const built = existsSync(stamp) && readFileSync(stamp, 'utf8') === sourceTime;
  const ours = existsSync(module) && lastChange(module) <= lastChange(stamp);
  if (built && ours) return;
  rmSync(stamp, { force: true });
  await build();
  writeFileSync(stamp, sourceTime);
}

/** How the package reads links. */
async function buildLink() {
  if (lastChange('pkg/link.js') >= lastChange('src/link.js', 'www', '.tasks')) return;
  const build = ['build', '--config', '.tasks/vite.config.js', '--logLevel', 'warn', '--mode', 'link'];
  await step('joining the package’s reader of links', () => runPackage('vite/bin/vite.js', build));
}

/** What wasm-pack would do, which need not be there. */
async function compile() {
  await run('wasm-bindgen', [await compiled(), '--target', 'web', '--out-dir', 'pkg']);
  tidyGlue('pkg');
}

/** Where cargo writes the module. @param {string[]} features */
async function compiled(...features) {
  const target = ['--target', 'wasm32-unknown-unknown'];
  const build = ['build', '--lib', '--release', ...target, ...features, '--config', withoutHome];
  // It has more ways to be told of a folder.
  const folder = process.env.CARGO_TARGET_DIR ?? 'target';
  await run('cargo', [...build, '--target-dir', folder]);
  return join(folder, target[1], 'release', 'ep_locomotion.wasm');
}

/** Panic messages name the source files of libraries: without the folder in which this machine keeps them. */
const remap = `--remap-path-prefix=${process.env.CARGO_HOME ?? join(homedir(), '.cargo')}=cargo`;
const withoutHome = `target.wasm32-unknown-unknown.rustflags=[${JSON.stringify(remap)}]`;

/** Puts an optimised module in the place of this one. @param {string} wasm */
export async function optimise(wasm) {
  // Two may be at it.
  const optimised = `${wasm}.${process.pid}`;
  await runPackage('binaryen/bin/wasm-opt', ['-O3', ...copying, ...features, wasm, '-o', optimised]);
  renameSync(optimised, wasm);
}

/** Only small functions are copied to where they are called: more would be larger, and no quicker. */
const copying = ['--one-caller-inline-max-function-size=20', '--flexible-inline-max-function-size=4'];

/** What every browser of the last years has, and what the compiler was told to use. */
const features = [
  '--enable-simd',
  '--enable-bulk-memory',
  '--enable-mutable-globals',
  '--enable-nontrapping-float-to-int',
  '--enable-sign-ext',
  '--enable-reference-types',
  '--enable-multivalue',
];

/** The static site, which works from any folder of any host; the page as one file, which needs no host; the element for other pages. */
export const buildSite = () =>
  step('building the site', async () => {
    const build = ['build', '--config', '.tasks/vite.config.js', '--logLevel', 'warn'];
    await runPackage('vite/bin/vite.js', build);
    await runPackage('vite/bin/vite.js', [...build, '--mode', 'offline']);
    await runPackage('vite/bin/vite.js', [...build, '--mode', 'element']);
  });

if (isProgram(import.meta.url)) {
  await task(async () => {
    const only = process.argv.slice(2);
    if (only.some((name) => name !== 'core' && name !== 'python')) {
      throw new Failure(`npm run build knows only "core" and "python", not ${only.join(', ')}`);
    }
    await installTools();
    await buildCore();
    if (only.includes('python')) await buildBytes();
    if (only.includes('core')) return;
    await buildSite();
    console.log('\nThe site is in dist/: copy that folder to any static host.');
    console.log(
      'The whole page is in dist/ep-locomotion.html: open it from anywhere, without a network too.',
    );
  });
}
