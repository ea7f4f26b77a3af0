import { fileURLToPath } from 'node:url';
import { defineConfig } from 'vite';
import { chunks } from './chunks.mjs';
import { hints } from './hints.mjs';
import { instead } from './instead.mjs';
import { oneFile } from './offline.mjs';

/** @param {string} path */
const fileOf = (path) => fileURLToPath(new URL(path, import.meta.url));

/** The element for other pages: one file that stands alone, under a name that stays, beside the site. @type {import('vite').BuildOptions} */
const element = {
  target: 'es2022',
  lib: { entry: fileOf('../www/embed/element.js'), formats: ['es'], fileName: () => 'embed.js' },
  emptyOutDir: false,
};

export default defineConfig(({ mode }) => ({
  root: fileOf('..'),
  base: './',
  publicDir: false,
  server: { watch: { ignored: ['**/target/**', '**/dist/**', '**/.tools/**'] } },
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
  plugins: [instead({ isOneFile: mode === 'offline' }), mode === 'offline' ? oneFile() : hints()],
  ...(mode === 'element' && { build: element }),
}));
