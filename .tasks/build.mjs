// npm run build: the core as pkg/, the static site as dist/, and the whole page in dist/ep-locomotion.html.
//
//   npm run build -- core   only pkg/, which is all that npm pack needs
import { existsSync, readFileSync, renameSync, rmSync, writeFileSync } from 'node:fs';
import { homedir } from 'node:os';
import { join } from 'node:path';
import { pathToFileURL } from 'node:url';
import { tidyGlue } from './glue.mjs';
import { Failure, lastChange, run, runPackage, step, task } from './run.mjs';
import { installTools } from './tools.mjs';

const sources = ['src', 'Cargo.toml', 'Cargo.lock', '.cargo'];
const wasm = 'pkg/ep_locomotion_bg.wasm';
/** Holds the time of the sources that were built. Written last, so that a build that was interrupted is done again. */
const stamp = 'pkg/.complete';

/** The core, compiled, joined to JavaScript and optimised, unless nothing has changed. */
export async function buildCore() {
  const sourceTime = String(lastChange(...sources));
  const built = existsSync(stamp) && readFileSync(stamp, 'utf8') === sourceTime;
  const ours = existsSync(wasm) && lastChange(wasm) <= lastChange(stamp);
  if (built && ours) return buildLink();
  rmSync(stamp, { force: true });
  await step('compiling the core to WebAssembly', compile, '1 minute at first, then 10 s');
  await step('optimising the WebAssembly', () => optimise(wasm));
  writeFileSync(stamp, sourceTime);
  await buildLink();
}

/** How the package reads links. */
async function buildLink() {
  if (lastChange('pkg/link.js') >= lastChange('src/link.js', 'www/link', 'www/words', '.tasks')) return;
  const build = ['build', '--config', '.tasks/vite.config.js', '--logLevel', 'warn', '--mode', 'link'];
  await step('joining the package’s reader of links', () => runPackage('vite/bin/vite.js', build));
}

/** What wasm-pack would do, which need not be there. */
async function compile() {
  const target = 'wasm32-unknown-unknown';
  await run('cargo', ['build', '--lib', '--release', '--target', target, '--config', withoutHome]);
  const folder = process.env.CARGO_TARGET_DIR ?? 'target';
  const module = join(folder, target, 'release', 'ep_locomotion.wasm');
  await run('wasm-bindgen', [module, '--target', 'web', '--out-dir', 'pkg']);
  tidyGlue('pkg');
}

/** Panic messages name the source files of libraries: without the folder in which this machine keeps them. */
const remap = `--remap-path-prefix=${process.env.CARGO_HOME ?? join(homedir(), '.cargo')}=cargo`;
const withoutHome = `target.wasm32-unknown-unknown.rustflags=[${JSON.stringify(remap)}]`;

/** Puts an optimised module in the place of this one. @param {string} wasm */
export async function optimise(wasm) {
  const optimised = `${wasm}.optimised`;
  await runPackage('binaryen/bin/wasm-opt', ['-O3', ...features, wasm, '-o', optimised]);
  renameSync(optimised, wasm);
}

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

if (import.meta.url === pathToFileURL(process.argv[1]).href) {
  await task(async () => {
    const only = process.argv.slice(2);
    if (only.some((name) => name !== 'core')) {
      throw new Failure(`npm run build knows only "core", not ${only.join(', ')}`);
    }
    await installTools();
    await buildCore();
    if (only.length > 0) return;
    await buildSite();
    console.log('\nThe site is in dist/: copy that folder to any static host.');
    console.log(
      'The whole page is in dist/ep-locomotion.html: open it from anywhere, without a network too.',
    );
  });
}
