import { relative } from 'node:path';
import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { chunks } from './chunks.mjs';
import { hints } from './hints.mjs';
import { instead } from './instead.mjs';
import { oneFile } from './offline.mjs';
import { wordsFirst } from './words.mjs';

/** @param {string} path */
const fileOf = (path) => fileURLToPath(new URL(path, import.meta.url));

/** The element for other pages: one file that stands alone, under a name that stays, beside the site. @type {import('vite').BuildOptions} */
const element = {
  target: 'es2022',
  lib: { entry: fileOf('../www/embed/element.js'), formats: ['es'], fileName: () => 'embed.js' },
  emptyOutDir: false,
};

/** How the package reads links: one file beside the core, with English words. @type {import('vite').BuildOptions} */
const link = {
  target: 'es2022',
  minify: false,
  outDir: fileOf('../pkg'),
  emptyOutDir: false,
  lib: { entry: fileOf('../src/link.js'), formats: ['es'], fileName: () => 'link.js' },
};

/** The core stays outside, for it must be the one that is ready; words are of one language, and of the parts only their names are needed. @type {import('vite').Plugin} */
const inPackage = {
  name: 'in-package',
  enforce: 'pre',
  resolveId(source) {
    if (source === '../pkg/ep_locomotion.js') return { id: './ep_locomotion.js', external: true };
    if (source === '../words/index.js' || source === '../www/parts/parts.js') return source;
  },
  async load(id) {
    if (id === '../words/index.js')
      return `export * as link from ${JSON.stringify(fileOf('../www/words/en/link.js'))};`;
    if (id !== '../www/parts/parts.js') return;
    const { pageNames } = await import(new URL(id, import.meta.url).href);
    return `export const pageNames = ${JSON.stringify(pageNames)};`;
  },
};

/** The page gives the core to what joins it to JavaScript, which else would ask for it by itself: it would be twice in the one file. @type {import('vite').Plugin} */
const coreGiven = {
  name: 'core-given',
  enforce: 'pre',
  transform: (code, id) =>
    id.endsWith('/pkg/ep_locomotion.js')
      ? code.replace("new URL('ep_locomotion_bg.wasm', import.meta.url)", 'null')
      : undefined,
};

/** What is built, and not looked at; the project may stand below a folder of such a name. @param {string} path */
const isBuilt = (path) => /^(?:target|dist|\.tools)(?:[\\/]|$)/.test(relative(fileOf('..'), path));

export default defineConfig(({ mode }) => ({
  root: fileOf('..'),
  base: './',
  publicDir: false,
  css: { transformer: 'lightningcss', lightningcss: { drafts: { customMedia: true } } },
  // The page that one works on is the page that is built: no library warns that it is another.
  resolve: { conditions: ['module', 'browser', 'production'] },
  server: { watch: { ignored: isBuilt } },
  build: {
    target: 'es2022',
    // Nothing inline, so that the strictest content security policy lets the page run.
    assetsInlineLimit: 0,
    // Firefox counts a module that is asked for twice, of which one is given up, as one that failed.
    modulePreload: false,
    rolldownOptions: { output: { codeSplitting: chunks } },
  },
  // A file of modules, from a Blob, is no worker for Chromium in a page that was opened from a disk.
  worker: { format: 'iife' },
  plugins: [
    coreGiven,
    instead({ isOneFile: mode === 'offline' }),
    ...(mode === 'offline' ? [oneFile()] : [wordsFirst(), hints()]),
  ],
  ...(mode === 'element' && { build: element }),
  ...(mode === 'link' && { build: link, plugins: [inPackage] }),
}));
